client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   \rho_d = 0.5
| \end{equation}
| Some text with \rho_d in it.
| \begin{equation}
|   g(x, \omega_i) = x^2 * \cos\theta_i
|     + \rho_d + \theta_o
| \end{equation}
| \begin{equation}
|   c = \vec{1, 0, 0.25} * 2
| \end{equation}
| \begin{equation}
|   f = g(\rho_d, \vec{n}) * c
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}

# A definition: from its left side, from a use, at the end of the name, and in its subscript.
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 1,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\rho_d`: `ℝ`\n\n```latex\n\\rho_d = 0.5\n```\n\nvalue 0.5 · defined on line 2"
       },
       "range": "2:3-2:9"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "7:7"}
<- {
     "id": 2,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\rho_d`: `ℝ`\n\n```latex\n\\rho_d = 0.5\n```\n\nvalue 0.5 · defined on line 2"
       },
       "range": "7:7-7:13"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "7:13"}
<- {
     "id": 3,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\rho_d`: `ℝ`\n\n```latex\n\\rho_d = 0.5\n```\n\nvalue 0.5 · defined on line 2"
       },
       "range": "7:7-7:13"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "7:12"}
<- {
     "id": 4,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\rho_d`: `ℝ`\n\n```latex\n\\rho_d = 0.5\n```\n\nvalue 0.5 · defined on line 2"
       },
       "range": "7:7-7:13"
     }
   }
# A function, and a vector with a value.
-> textDocument/hover {"doc": "a.tex", "at": "13:7"}
<- {
     "id": 5,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`g`: `ℝ × ℝ³ → ℝ`\n\n```latex\ng(x, \\omega_i) = x^2 * \\cos\\theta_i + \\rho_d + \\theta_o\n```\n\ndefined on line 6"
       },
       "range": "13:7-13:8"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "13:28"}
<- {
     "id": 6,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`c`: `ℝ³`\n\n```latex\nc = \\vec{1, 0, 0.25} * 2\n```\n\nvalue (2, 0, 0.5) · defined on line 10"
       },
       "range": "13:28-13:29"
     }
   }
# A parameter, where it is declared and where it is used.
-> textDocument/hover {"doc": "a.tex", "at": "6:5"}
<- {
     "id": 7,
     "result": {"contents":{"kind":"markdown","value":"`x`: `ℝ`\n\nparameter of `g`"},"range":"6:5-6:6"}
   }
-> textDocument/hover {"doc": "a.tex", "at": "6:20"}
<- {
     "id": 8,
     "result": {"contents":{"kind":"markdown","value":"`x`: `ℝ`\n\nparameter of `g`"},"range":"6:20-6:21"}
   }
-> textDocument/hover {"doc": "a.tex", "at": "6:10"}
<- {
     "id": 9,
     "result": {"contents":{"kind":"markdown","value":"`\\omega_i`: `ℝ³`\n\nparameter of `g`"},"range":"6:8-6:16"}
   }
# Conventions; the first follows the parameter.
-> textDocument/hover {"doc": "a.tex", "at": "6:34"}
<- {
     "id": 10,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\theta_i`: `ℝ` = `arccos(N·L)`\n\npolar angle of the incident direction\n\nhere of the parameter `\\omega_i`\n\na convention of the language"
       },
       "range": "6:30-6:38"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "7:17"}
<- {
     "id": 11,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\theta_o`: `ℝ` = `arccos(N·V)`\n\npolar angle of the outgoing direction\n\na convention of the language"
       },
       "range": "7:16-7:24"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "13:20"}
<- {
     "id": 12,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\vec{n}`: `ℝ³` = `N`\n\nunit surface normal\n\na convention of the language"
       },
       "range": "13:17-13:24"
     }
   }
# Nothing: prose, a sign of equality, a number, far outside.
-> textDocument/hover {"doc": "a.tex", "at": "4:17"}
<- {"id":13,"result":null}
-> textDocument/hover {"doc": "a.tex", "at": "13:5"}
<- {"id":14,"result":null}
-> textDocument/hover {"doc": "a.tex", "at": "2:13"}
<- {"id":15,"result":null}
-> textDocument/hover {"doc": "a.tex", "at": "100000:100000"}
<- {"id":16,"result":null}
=> exit status 1
