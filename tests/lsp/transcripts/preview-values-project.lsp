# The definition that a bad value comes from may stand in another file.
file parts/terms.tex
| \begin{equation}
|   d = \ln{-\cos{\theta_i}}
| \end{equation}
client {"capabilities": {}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open paper.tex
| \input{parts/terms}
| \begin{equation}
|   f = d * 2
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"paper.tex","version":1,"diagnostics":[]}}
-> texbrdf/openPreview {"uri": "file:///work/paper.tex", "width": 64, "height": 64, "light": {"theta": 0, "phi": 0}}
<- {"id":1,"result":{"preview":1,"root":"f"}}
-> texbrdf/definitions {"uri": "file:///work/paper.tex"}
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
# That file as an editor has it, and as it is on disk again when the editor gives it up.
open parts/terms.tex
| \begin{equation}
|   d = 3
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"parts/terms.tex","version":1,"diagnostics":[]}
   }
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":4,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[6]}}
-> textDocument/didClose {"doc": "parts/terms.tex"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/terms.tex","diagnostics":[]}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"paper.tex","version":1,"diagnostics":[]}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":5,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":["nan"]}}
=> exit status 1
