# A picture of what is hovered goes to clients that name the parser of their Markdown, or are set to get it.
client {"capabilities": {"textDocument": {"hover": {"contentFormat": ["plaintext"]}}}, "initializationOptions": {"hover.picture": "on"}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = \cos{\theta_h} * g(m) / \pi
| \end{equation}
| \begin{equation}
|   g(x) = x^2
| \end{equation}
| \begin{equation}
|   m = 0.5
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
# A definition; an operator; a bracket of a constant part; a constant; the operator of a function; a definition that is constant.
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 1,
     "result": {
       "contents": {
         "kind": "plaintext",
         "value": "f: ℝ\n\nf = \\cos{\\theta_h} * g(m) / \\pi\n\ndefined on line 2\n\n9.809e-05 to 0.07958, sampled over the hemisphere"
       },
       "range": "2:3-2:4"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:22"}
<- {
     "id": 2,
     "result": {
       "contents": {
         "kind": "plaintext",
         "value": "ℝ\n\n\\cos{\\theta_h} * g(m)\n\n0.0003081 to 0.25, sampled over the hemisphere"
       },
       "range": "2:7-2:28"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:25"}
<- {"id":3,"result":{"contents":{"kind":"plaintext","value":"ℝ\n\ng(m)\n\nvalue 0.25"},"range":"2:24-2:28"}}
-> textDocument/hover {"doc": "a.tex", "at": "2:26"}
<- {
     "id": 4,
     "result": {
       "contents": {"kind":"plaintext","value":"m: ℝ\n\nm = 0.5\n\nvalue 0.5 · defined on line 8"},
       "range": "2:26-2:27"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "5:11"}
<- {"id":5,"result":{"contents":{"kind":"plaintext","value":"ℝ\n\nx^2"},"range":"5:10-5:13"}}
-> textDocument/hover {"doc": "a.tex", "at": "8:3"}
<- {
     "id": 6,
     "result": {
       "contents": {"kind":"plaintext","value":"m: ℝ\n\nm = 0.5\n\nvalue 0.5 · defined on line 8"},
       "range": "8:3-8:4"
     }
   }
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"hover": {"picture": "off"}}}}
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 7,
     "result": {
       "contents": {"kind":"plaintext","value":"f: ℝ\n\nf = \\cos{\\theta_h} * g(m) / \\pi\n\ndefined on line 2"},
       "range": "2:3-2:4"
     }
   }
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"hover": {"picture": "sometimes"}}}}
=> exit status 1
