# A client that wants to see the progress of a request gets it.
client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = a
| \end{equation}
| \begin{equation}
|   a = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/references {"doc": "a.tex", "at": "2:7", "context": {"includeDeclaration": false}, "workDoneToken": "t1"}
<- {"method":"$/progress","params":{"token":"t1","value":{"kind":"begin","title":"references"}}}
<- {"method":"$/progress","params":{"token":"t1","value":{"kind":"end"}}}
<- {"id":1,"result":[{"uri":"a.tex","range":"2:7-2:8"}]}
-> textDocument/rename {"doc": "a.tex", "at": "2:7", "newName": "b", "workDoneToken": 7}
<- {"method":"$/progress","params":{"token":7,"value":{"kind":"begin","title":"rename"}}}
<- {"method":"$/progress","params":{"token":7,"value":{"kind":"end"}}}
<- {
     "id": 2,
     "result": {"changes":{"file:///work/a.tex":[{"range":"2:7-2:8","newText":"b"},{"range":"5:3-5:4","newText":"b"}]}}
   }
# Also where there is no result.
-> textDocument/rename {"doc": "a.tex", "at": "2:7", "newName": "", "workDoneToken": 7}
<- {"method":"$/progress","params":{"token":7,"value":{"kind":"begin","title":"rename"}}}
<- {"method":"$/progress","params":{"token":7,"value":{"kind":"end"}}}
<- {"id":3,"error":{"code":-32803,"message":"the new name is empty"}}
-> textDocument/references {"doc": "a.tex", "at": "2:7", "context": {"includeDeclaration": false}, "workDoneToken": {}}
<- {"id":4,"result":[{"uri":"a.tex","range":"2:7-2:8"}]}
=> exit status 1
