client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   g(\vec{m}, x) = \vec{m} * x
| \end{equation}
| \begin{equation}
|   f = g(\vec{n}, 1)
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}

# Without offsets a parameter is named by its text.
-> textDocument/signatureHelp {"doc": "a.tex", "at": "5:18"}
<- {
     "id": 1,
     "result": {
       "signatures": [
         {
           "label": "g(\\vec{m}: ℝ³, x: ℝ): ℝ³",
           "documentation": {
             "kind": "plaintext",
             "value": "g: ℝ³ × ℝ → ℝ³\n\ng(\\vec{m}, x) = \\vec{m} * x\n\ndefined on line 2"
           },
           "parameters": [{"label":"\\vec{m}: ℝ³"},{"label":"x: ℝ"}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 1
     }
   }
=> exit status 1
