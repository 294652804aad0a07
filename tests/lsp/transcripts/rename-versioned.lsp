client {"capabilities": {"workspace": {"workspaceEdit": {"documentChanges": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = a
| \end{equation}
| \begin{equation}
|   a = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
change a.tex 5:7-5:8 "2"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
# For clients that check that their text is the one that was asked about.
-> textDocument/rename {"doc": "a.tex", "at": "2:7", "newName": "\\rho_d"}
<- {
     "id": 1,
     "result": {
       "documentChanges": [
         {
           "textDocument": {"uri":"a.tex","version":2},
           "edits": [{"range":"2:7-2:8","newText":"\\rho_d"},{"range":"5:3-5:4","newText":"\\rho_d"}]
         }
       ]
     }
   }
=> exit status 1
