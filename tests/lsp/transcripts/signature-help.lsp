client {"capabilities": {"textDocument": {"signatureHelp": {"signatureInformation": {"documentationFormat": ["markdown"], "parameterInformation": {"labelOffsetSupport": true}}}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   g(\vec{m}, x) = \vec{m} * x
| \end{equation}
| \begin{equation}
|   f = g(\vec{n}, \max(1, 2
| \end{equation}
| g(prose)
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [{"range":"5:8-5:9","severity":1,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}]
     }
   }

# The first and the second parameter, a nested call, and a place between calls; offsets count UTF-16 units.
-> textDocument/signatureHelp {"doc": "a.tex", "at": "5:9"}
<- {
     "id": 1,
     "result": {
       "signatures": [
         {
           "label": "g(\\vec{m}: ℝ³, x: ℝ): ℝ³",
           "documentation": {
             "kind": "markdown",
             "value": "`g`: `ℝ³ × ℝ → ℝ³`\n\n```latex\ng(\\vec{m}, x) = \\vec{m} * x\n```\n\ndefined on line 2"
           },
           "parameters": [{"label":[2,13]},{"label":[15,19]}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 0
     }
   }
-> textDocument/signatureHelp {"doc": "a.tex", "at": "5:18"}
<- {
     "id": 2,
     "result": {
       "signatures": [
         {
           "label": "g(\\vec{m}: ℝ³, x: ℝ): ℝ³",
           "documentation": {
             "kind": "markdown",
             "value": "`g`: `ℝ³ × ℝ → ℝ³`\n\n```latex\ng(\\vec{m}, x) = \\vec{m} * x\n```\n\ndefined on line 2"
           },
           "parameters": [{"label":[2,13]},{"label":[15,19]}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 1
     }
   }
-> textDocument/signatureHelp {"doc": "a.tex", "at": "5:26"}
<- {
     "id": 3,
     "result": {
       "signatures": [{"label":"\\max(x_1: ℝ, x_2: ℝ, …): ℝ","parameters":[{"label":[5,11]},{"label":[13,19]}]}],
       "activeSignature": 0,
       "activeParameter": 1
     }
   }
# Nothing in front of the bracket, where the function is defined, and in prose.
-> textDocument/signatureHelp {"doc": "a.tex", "at": "5:8"}
<- {"id":4,"result":null}
-> textDocument/signatureHelp {"doc": "a.tex", "at": "2:6"}
<- {"id":5,"result":null}
-> textDocument/signatureHelp {"doc": "a.tex", "at": "7:4"}
<- {"id":6,"result":null}
-> textDocument/signatureHelp {"doc": "b.tex", "at": "7:4"}
<- {"id":7,"error":{"code":-32602,"message":"/work/b.tex is not open"}}
=> exit status 1
