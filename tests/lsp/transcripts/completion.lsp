client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| Prose with \rh in it.
| \begin{equation}
|   \rho_d = 0.5
| \end{equation}
| \begin{equation}
|   g(m, \omega_i) = m * \cos\theta_i
| \end{equation}
| \begin{equation}
|   f = 𝔹 + \rho_ + g(
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {"range":"3:3-3:9","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `\\rho_d`"},
         {
           "range": "9:7-9:9",
           "severity": 1,
           "code": "E1001",
           "source": "texbrdf",
           "message": "unexpected character `𝔹`"
         },
         {
           "range": "9:12-9:19",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\rho_+` in the definition of `f`; did you mean `\\rho_d`?"
         },
         {"range":"9:21-9:22","severity":1,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}
       ]
     }
   }

# Not in prose, nor in \begin, nor in a comment, nor in a number.
-> textDocument/completion {"doc": "a.tex", "at": "1:15"}
<- {"id":1,"result":null}
-> textDocument/completion {"doc": "a.tex", "at": "2:10"}
<- {"id":2,"result":null}
-> textDocument/completion {"doc": "a.tex", "at": "3:15"}
<- {"id":3,"result":null}

# Of an equation that cannot be read; the range counts UTF-16 units behind the 𝔹.
-> textDocument/completion {"doc": "a.tex", "at": "9:17", "context": {"triggerKind": 2, "triggerCharacter": "_"}}
<- {
     "id": 4,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\rho_d",
           "kind": 6,
           "detail": "ℝ",
           "sortText": "01",
           "textEdit": {"range":"9:12-9:17","newText":"\\rho_d"},
           "data": {"uri":"a.tex","kind":"definition"}
         }
       ]
     }
   }

# A parameter, and what it hides.
-> textDocument/completion {"doc": "a.tex", "at": "6:21"}
<- {
     "id": 5,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "m",
           "kind": 6,
           "detail": "ℝ",
           "sortText": "00",
           "textEdit": {"range":"6:20-6:21","newText":"m"},
           "data": {"uri":"a.tex","kind":"parameter","function":"g"}
         },
         {
           "label": "\\text{mix}",
           "kind": 3,
           "detail": "ℝ × ℝ × ℝ → ℝ",
           "sortText": "04",
           "filterText": "mix",
           "textEdit": {"range":"6:20-6:21","newText":"\\text{mix}"},
           "data": {"uri":"a.tex","kind":"builtin"}
         },
         {
           "label": "\\max",
           "kind": 14,
           "sortText": "05",
           "filterText": "max",
           "textEdit": {"range":"6:20-6:21","newText":"\\max"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\min",
           "kind": 14,
           "sortText": "05",
           "filterText": "min",
           "textEdit": {"range":"6:20-6:21","newText":"\\min"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\mathbf",
           "kind": 14,
           "sortText": "05",
           "filterText": "mathbf",
           "textEdit": {"range":"6:20-6:21","newText":"\\mathbf"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\mathrm",
           "kind": 14,
           "sortText": "05",
           "filterText": "mathrm",
           "textEdit": {"range":"6:20-6:21","newText":"\\mathrm"},
           "data": {"uri":"a.tex","kind":"command"}
         }
       ]
     }
   }
change a.tex 6:22-6:34 "\\omega"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {"range":"3:3-3:9","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `\\rho_d`"},
         {
           "range": "9:7-9:9",
           "severity": 1,
           "code": "E1001",
           "source": "texbrdf",
           "message": "unexpected character `𝔹`"
         },
         {
           "range": "9:12-9:19",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\rho_+` in the definition of `f`; did you mean `\\rho_d`?"
         },
         {"range":"9:21-9:22","severity":1,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "6:28"}
<- {
     "id": 6,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\omega_i",
           "kind": 6,
           "detail": "ℝ³",
           "sortText": "00",
           "textEdit": {"range":"6:22-6:28","newText":"\\omega_i"},
           "data": {"uri":"a.tex","kind":"parameter","function":"g"}
         },
         {
           "label": "\\omega_o",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"6:22-6:28","newText":"\\omega_o"},
           "data": {"uri":"a.tex","kind":"convention","function":"g"}
         }
       ]
     }
   }

# Inside \vec{, with the closer that an editor has put there.
change a.tex 9:7-9:21 "\\vec{}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {"range":"3:3-3:9","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `\\rho_d`"},
         {"range":"6:3-6:4","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `g`"},
         {
           "range": "9:12-9:13",
           "severity": 1,
           "code": "E2018",
           "source": "texbrdf",
           "message": "expected a name, found `}`"
         },
         {"range":"9:13-9:14","severity":1,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "9:12", "context": {"triggerKind": 2, "triggerCharacter": "{"}}
<- {
     "id": 7,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\vec{\\omega_i}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"9:7-9:13","newText":"\\vec{\\omega_i}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{\\omega_o}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"9:7-9:13","newText":"\\vec{\\omega_o}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{n}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"9:7-9:13","newText":"\\vec{n}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{h}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"9:7-9:13","newText":"\\vec{h}"},
           "data": {"uri":"a.tex","kind":"convention"}
         }
       ]
     }
   }

# Documentation comes later; what nothing is known of comes back as it was sent.
-> completionItem/resolve {"label": "\\rho_d", "kind": 6, "sortText": "01", "data": {"uri": "file:///work/a.tex", "kind": "definition"}}
<- {
     "id": 8,
     "result": {
       "data": {"kind":"definition","uri":"a.tex"},
       "kind": 6,
       "label": "\\rho_d",
       "sortText": "01",
       "documentation": {"kind":"plaintext","value":"\\rho_d: ℝ\n\n\\rho_d = 0.5\n\nvalue 0.5 · defined on line 3"}
     }
   }
-> completionItem/resolve {"label": "m", "data": {"uri": "file:///work/a.tex", "kind": "parameter", "function": "g"}}
<- {
     "id": 9,
     "result": {
       "data": {"function":"g","kind":"parameter","uri":"a.tex"},
       "label": "m",
       "documentation": {"kind":"plaintext","value":"m: ℝ\n\nparameter of g"}
     }
   }
-> completionItem/resolve {"label": "\\theta_i", "data": {"uri": "file:///work/a.tex", "kind": "convention", "function": "g"}}
<- {
     "id": 10,
     "result": {
       "data": {"function":"g","kind":"convention","uri":"a.tex"},
       "label": "\\theta_i",
       "documentation": {
         "kind": "plaintext",
         "value": "\\theta_i: ℝ = arccos(N·L)\n\npolar angle of the incident direction\n\nhere of the parameter \\omega_i\n\na convention of the language"
       }
     }
   }
-> completionItem/resolve {"label": "\\frac", "data": {"uri": "file:///work/a.tex", "kind": "command"}}
<- {
     "id": 11,
     "result": {
       "data": {"kind":"command","uri":"a.tex"},
       "label": "\\frac",
       "documentation": {"kind":"plaintext","value":"A quotient: \\frac{a}{b} is a / b."}
     }
   }
-> completionItem/resolve {"label": "gone", "data": {"uri": "file:///work/a.tex", "kind": "definition"}}
<- {"id":12,"result":{"data":{"kind":"definition","uri":"a.tex"},"label":"gone"}}
-> completionItem/resolve {"label": "gone", "data": {"uri": "file:///work/closed.tex", "kind": "definition"}}
<- {"id":13,"result":{"data":{"kind":"definition","uri":"closed.tex"},"label":"gone"}}
-> completionItem/resolve {"label": "other", "data": 7}
<- {"id":14,"result":{"data":7,"label":"other"}}
-> completionItem/resolve {}
<- {"id":15,"error":{"code":-32602,"message":"`label` has to be a string"}}
-> textDocument/completion {"doc": "closed.tex", "at": "1:1"}
<- {"id":16,"error":{"code":-32602,"message":"/work/closed.tex is not open"}}
=> exit status 1
