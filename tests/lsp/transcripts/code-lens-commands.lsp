client {"capabilities": {"experimental": {"texbrdf": {"commands": ["texbrdf.preview", "texbrdf.showReferences"]}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   a = 1/4
| \end{equation}
| \begin{equation}
|   f = a
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/codeLens {"doc": "a.tex"}
<- {
     "id": 1,
     "result": [
       {"range":"2:3-2:4","data":{"uri":"a.tex","name":"a"}},
       {"range":"5:3-5:4","command":{"title":"preview","command":"texbrdf.preview","arguments":["a.tex","f"]}}
     ]
   }
-> codeLens/resolve {"range": {"start": {"line": 1, "character": 2}, "end": {"line": 1, "character": 3}}, "data": {"uri": "file:///work/a.tex", "name": "a"}}
<- {
     "id": 2,
     "result": {
       "range": "2:3-2:4",
       "command": {"title":"1 use","command":"texbrdf.showReferences","arguments":["a.tex",{"line":1,"character":2}]},
       "data": {"uri":"a.tex","name":"a"}
     }
   }
=> exit status 1
