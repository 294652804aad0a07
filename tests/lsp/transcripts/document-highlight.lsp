client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   \alpha = 0.5
| \end{equation}
| \begin{equation}
|   f = \alpha * \alpha + \pi
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/documentHighlight {"doc": "a.tex", "at": "5:8"}
<- {
     "id": 1,
     "result": [{"range":"2:3-2:9","kind":3},{"range":"5:7-5:13","kind":2},{"range":"5:16-5:22","kind":2}]
   }
-> textDocument/documentHighlight {"doc": "a.tex", "at": "5:25"}
<- {"id":2,"result":[{"range":"5:25-5:28","kind":2}]}
-> textDocument/documentHighlight {"doc": "a.tex", "at": "1:1"}
<- {"id":3,"result":[]}
=> exit status 1
