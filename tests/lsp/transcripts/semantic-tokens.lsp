client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| prose 😀 \begin{equation} \rho_d = 1/4 \end{equation}
| \begin{equation}
|   g(x) = x * \theta_h
| \end{equation}
| \begin{equation}
|   f = g(0.5) + \rho_d
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/semanticTokens/full {"doc": "a.tex"}
<- {
     "id": 1,
     "result": {
       "resultId": "1",
       "data": [0,26,6,1,2,0,7,1,4,0,0,2,1,3,0,0,1,1,4,0,0,1,1,3,0,2,2,1,0,2,0,2,1,2,1,0,3,1,4,0,0,2,1,2,0,0,2,1,4,0,0,2,8,1,4,3,2,1,1,2,0,2,1,4,0,0,2,1,0,0,0,2,3,3,0,0,5,1,4,0,0,2,6,1,0]
     }
   }
-> textDocument/semanticTokens/range {"doc": "a.tex", "range": {"start": {"line": 2, "character": 0}, "end": {"line": 2, "character": 9}}}
<- {"id":2,"result":{"data":[2,2,1,0,2,0,2,1,2,1,0,3,1,4,0,0,2,1,2,0]}}
# nothing changed
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "1"}
<- {"id":3,"result":{"resultId":"2","edits":[]}}
# a digit of the same length, then one more
change a.tex 1:38-1:39 "3"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "2"}
<- {"id":4,"result":{"resultId":"3","edits":[]}}
change a.tex 1:38-1:39 "35"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":3,"diagnostics":[]}}
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "3"}
<- {
     "id": 5,
     "result": {
       "resultId": "4",
       "edits": [{"start":0,"deleteCount":25,"data":[0,26,6,1,2,0,7,1,4,0,0,2,1,3,0,0,1,1,4,0,0,1,2,3,0]}]
     }
   }
# a line of prose moves what follows
change a.tex 4:15-4:15 "\nprose"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":4,"diagnostics":[]}}
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "4"}
<- {"id":6,"result":{"resultId":"5","edits":[{"start":55,"deleteCount":2,"data":[4,2]}]}}
# an id that is not the last: everything
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "4"}
<- {
     "id": 7,
     "result": {
       "resultId": "6",
       "data": [0,26,6,1,2,0,7,1,4,0,0,2,1,3,0,0,1,1,4,0,0,1,2,3,0,2,2,1,0,2,0,2,1,2,1,0,3,1,4,0,0,2,1,2,0,0,2,1,4,0,0,2,8,1,4,4,2,1,1,2,0,2,1,4,0,0,2,1,0,0,0,2,3,3,0,0,5,1,4,0,0,2,6,1,0]
     }
   }
-> textDocument/semanticTokens/full/delta {"doc": "a.tex"}
<- {"id":8,"error":{"code":-32602,"message":"`previousResultId` has to be a string"}}
-> textDocument/semanticTokens/full {"doc": "b.tex"}
<- {"id":9,"error":{"code":-32602,"message":"/work/b.tex is not open"}}
=> exit status 1
