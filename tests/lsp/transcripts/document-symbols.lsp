client {"capabilities": {"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open empty.tex
| no equation
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"empty.tex","version":1,"diagnostics":[]}}
-> textDocument/documentSymbol {"doc": "empty.tex"}
<- {"id":1,"result":[]}
open a.tex
| \begin{equation}
|   \rho_d = \vec{1, 1, 1}
| \end{equation}
| \begin{equation}
|   g(x, \vec{v}) = x * \vec{v}
| \end{equation}
| \begin{equation}
|   broken = (
| \end{equation}
| \begin{equation}
|   f = g(1, \vec{n}) * \rho_d
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {"range":"8:3-8:9","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `broken`"},
         {"range":"8:12-8:13","severity":4,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}
       ]
     }
   }
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {
     "id": 2,
     "result": [
       {"name":"\\rho_d","detail":"ℝ³","kind":13,"range":"2:3-2:25","selectionRange":"2:3-2:9"},
       {
         "name": "g",
         "detail": "ℝ × ℝ³ → ℝ³",
         "kind": 12,
         "range": "5:3-5:30",
         "selectionRange": "5:3-5:4",
         "children": [
           {"name":"x","detail":"ℝ","kind":26,"range":"5:5-5:6","selectionRange":"5:5-5:6"},
           {"name":"\\vec{v}","detail":"ℝ³","kind":26,"range":"5:8-5:15","selectionRange":"5:8-5:15"}
         ]
       },
       {"name":"broken","detail":"?","kind":13,"range":"8:3-8:13","selectionRange":"8:3-8:9"},
       {"name":"f","detail":"ℝ","kind":13,"range":"11:3-11:29","selectionRange":"11:3-11:4"}
     ]
   }
=> exit status 1
