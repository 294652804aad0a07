# The definition that a bad value comes from may stand in another file.
file parts/terms.tex
| \begin{equation}
|   d = \ln{-\cos{\theta_i}}
| \end{equation}
client {"capabilities": {}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open main.tex
| \input{parts/terms}
| \begin{equation}
|   f = d * 2
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"main.tex","version":1,"diagnostics":[]}}
-> texbrdf/openPreview {"uri": "file:///work/main.tex", "width": 64, "height": 64, "light": {"theta": 0, "phi": 0}}
<- {"id":1,"result":{"preview":1,"root":"f"}}
-> texbrdf/definitions {"uri": "file:///work/main.tex"}
<- {"id":2,"result":[{"name":"f","label":"f","type":"real"},{"name":"d","label":"d","type":"real"}]}
-> texbrdf/badPixels {"preview": 1}
<- {
     "id": 3,
     "result": {
       "size": 64,
       "nan": 2684,
       "infinite": 0,
       "negative": 0,
       "first": {
         "x": 0.4000562692924648,
         "y": 0.06178518074388406,
         "kind": "nan",
         "definition": "d",
         "label": "d",
         "location": {"uri":"parts/terms.tex","range":"2:3-2:4"}
       }
     }
   }
=> exit status 1
