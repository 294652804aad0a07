client {"capabilities": {"textDocument": {"definition": {"linkSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = g(\text{shine}, 2)
| \end{equation}
| \begin{equation}
|   g(x, y) = x * y
|     - x
| \end{equation}
| \begin{equation}
|   \text{shine} = \theta_h
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/definition {"doc": "a.tex", "at": "2:7"}
<- {
     "id": 1,
     "result": [
       {
         "originSelectionRange": "2:7-2:8",
         "targetUri": "a.tex",
         "targetRange": "5:3-6:8",
         "targetSelectionRange": "5:3-5:4"
       }
     ]
   }
-> textDocument/definition {"doc": "a.tex", "at": "2:12"}
<- {
     "id": 2,
     "result": [
       {
         "originSelectionRange": "2:9-2:21",
         "targetUri": "a.tex",
         "targetRange": "9:3-9:26",
         "targetSelectionRange": "9:3-9:15"
       }
     ]
   }
# A parameter, and a definition's own name.
-> textDocument/definition {"doc": "a.tex", "at": "6:7"}
<- {
     "id": 3,
     "result": [
       {
         "originSelectionRange": "6:7-6:8",
         "targetUri": "a.tex",
         "targetRange": "5:3-6:8",
         "targetSelectionRange": "5:5-5:6"
       }
     ]
   }
-> textDocument/definition {"doc": "a.tex", "at": "5:3"}
<- {
     "id": 4,
     "result": [
       {
         "originSelectionRange": "5:3-5:4",
         "targetUri": "a.tex",
         "targetRange": "5:3-6:8",
         "targetSelectionRange": "5:3-5:4"
       }
     ]
   }
# A convention is declared nowhere; neither is prose.
-> textDocument/definition {"doc": "a.tex", "at": "9:20"}
<- {"id":5,"result":null}
-> textDocument/definition {"doc": "a.tex", "at": "1:3"}
<- {"id":6,"result":null}
=> exit status 1
