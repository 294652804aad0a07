client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   a = 1/4
| \end{equation}
| \begin{equation}
|   f = a + a
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/codeLens {"doc": "a.tex"}
<- {"id":1,"result":[{"range":"2:3-2:4","data":{"uri":"a.tex","name":"a"}}]}
-> codeLens/resolve {"range": {"start": {"line": 1, "character": 2}, "end": {"line": 1, "character": 3}}, "data": {"uri": "file:///work/a.tex", "name": "a"}}
<- {
     "id": 2,
     "result": {"range":"2:3-2:4","command":{"title":"2 uses","command":""},"data":{"uri":"a.tex","name":"a"}}
   }
-> codeLens/resolve {"range": {"start": {"line": 1, "character": 2}, "end": {"line": 1, "character": 3}}}
<- {"id":3,"error":{"code":-32602,"message":"`data` has to be an object"}}
=> exit status 1
