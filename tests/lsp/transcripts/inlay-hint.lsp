client {"initializationOptions": {"inlayHint": {"parameterTypes": false}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   a = 1/4
| \end{equation}
| \begin{equation}
|   g(x) = x * \vec{n}
| \end{equation}
| \begin{equation}
|   f = g(a)
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/inlayHint {"doc": "a.tex", "range": {"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}}}
<- {
     "id": 1,
     "result": [
       {"position":{"line":1,"character":3},"label":": ℝ","kind":1},
       {"position":{"line":1,"character":9},"label":"= 0.25","paddingLeft":true},
       {"position":{"line":4,"character":6},"label":": ℝ³","kind":1},
       {"position":{"line":7,"character":3},"label":": ℝ³","kind":1}
     ]
   }
-> textDocument/inlayHint {"doc": "a.tex", "range": {"start": {"line": 7, "character": 0}, "end": {"line": 8, "character": 0}}}
<- {"id":2,"result":[{"position":{"line":7,"character":3},"label":": ℝ³","kind":1}]}
=> exit status 1
