client {"capabilities": {"textDocument": {"completion": {"completionItem": {"snippetSupport": true}}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \[ a_1(x) = x, \quad a_2(x) = x^2, \quad h(x) = \sin x \]
| \[ s = \sum_{k=1}^{2} k a_k(0.5) + \int_\Omega \cos\theta_i \, d\omega_i + h'(1) \]
| \[ p(y) = \frac{\partial}{\partial y} y^2 \]
| \[ \mathbf w = \omega_i + \omega_o \]
| \[ g(s) = s, \quad t = \cos\theta_w + g \]
| \[ f = s + p(0.2) + t = t + p(0.2) + s \]
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
# Bound names.
-> textDocument/hover {"doc": "a.tex", "at": "2:23"}
<- {
     "id": 1,
     "result": {
       "contents": {"kind":"markdown","value":"`k`: `ℝ`\n\nindex of `\\sum_{k=1}^{2} k a_k(0.5)`"},
       "range": "2:23-2:24"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:53"}
<- {
     "id": 2,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\theta_i`: `ℝ` = `arccos(N·\\omega_i)`\n\nangle of the variable of `\\int_\\Omega \\cos\\theta_i \\, d\\omega_i`"
       },
       "range": "2:52-2:60"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:65"}
<- {
     "id": 3,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`\\omega_i`: `ℝ³`\n\nvariable of `\\int_\\Omega \\cos\\theta_i \\, d\\omega_i`"
       },
       "range": "2:65-2:73"
     }
   }
# Calls of several functions, of a derivative, and of what needs no definition.
-> textDocument/signatureHelp {"doc": "a.tex", "at": "2:29"}
<- {
     "id": 4,
     "result": {
       "signatures": [
         {
           "label": "a_1(x: ℝ): ℝ",
           "documentation": {"kind":"plaintext","value":"a_1: ℝ → ℝ\n\na_1(x) = x\n\ndefined on line 1"},
           "parameters": [{"label":"x: ℝ"}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 0
     }
   }
-> textDocument/signatureHelp {"doc": "a.tex", "at": "2:79"}
<- {
     "id": 5,
     "result": {
       "signatures": [
         {
           "label": "h(x: ℝ): ℝ",
           "documentation": {"kind":"plaintext","value":"h: ℝ → ℝ\n\nh(x) = \\sin x\n\ndefined on line 1"},
           "parameters": [{"label":"x: ℝ"}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 0
     }
   }
# What a derivative is taken by has one name.
-> textDocument/rename {"doc": "a.tex", "at": "3:6", "newName": "z"}
<- {
     "id": 6,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"3:6-3:7","newText":"z"},
           {"range":"3:36-3:37","newText":"z"},
           {"range":"3:39-3:40","newText":"z"}
         ]
       }
     }
   }
# What is found by a part of its name keeps it.
-> textDocument/rename {"doc": "a.tex", "at": "4:5", "newName": "\\mathbf{z}"}
<- {"id":7,"error":{"code":-32803,"message":"in `t`, an angle or a component is named after `\\vec{w}`"}}
-> textDocument/rename {"doc": "a.tex", "at": "1:4", "newName": "b"}
<- {
     "id": 8,
     "error": {"code":-32803,"message":"`a_1` is found by its index or derivative in `s` and keeps its name"}
   }
-> textDocument/rename {"doc": "a.tex", "at": "5:6", "newName": "z"}
<- {
     "id": 9,
     "error": {"code":-32803,"message":"a function stands without arguments in `t` and takes `s` by its name"}
   }
# All sides of a chain.
-> textDocument/rename {"doc": "a.tex", "at": "6:21", "newName": "z"}
<- {
     "id": 10,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"5:20-5:21","newText":"z"},
           {"range":"6:21-6:22","newText":"z"},
           {"range":"6:25-6:26","newText":"z"}
         ]
       }
     }
   }
-> textDocument/references {"doc": "a.tex", "at": "6:25", "context": {"includeDeclaration": false}}
<- {"id":11,"result":[{"uri":"a.tex","range":"6:21-6:22"},{"uri":"a.tex","range":"6:25-6:26"}]}
-> textDocument/definition {"doc": "a.tex", "at": "6:29"}
<- {"id":12,"result":{"uri":"a.tex","range":"3:4-3:5"}}
open b.tex
| \[ f = sat \]
| \[ g(x) = \text{lerp}(0.1, x \]
| \[ k = \sum_{jj=1}^{3} j \]
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "b.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "1:8-1:11",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `sat` in the definition of `f`"
         },
         {"range":"2:4-2:5","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `g`"},
         {"range":"2:22-2:23","severity":4,"code":"E2003","source":"texbrdf","message":"`(` is never closed"},
         {"range":"3:4-3:5","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `k`"},
         {
           "range": "3:24-3:25",
           "severity": 4,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `j` in the definition of `k`"
         }
       ]
     }
   }
-> textDocument/completion {"doc": "b.tex", "at": "1:11"}
<- {
     "id": 13,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\text{saturate}",
           "kind": 3,
           "detail": "ℝ → ℝ",
           "sortText": "04",
           "filterText": "saturate",
           "insertTextFormat": 2,
           "textEdit": {"range":"1:8-1:11","newText":"\\\\text{saturate}($1)"},
           "data": {"uri":"b.tex","kind":"builtin"}
         }
       ]
     }
   }
-> textDocument/signatureHelp {"doc": "b.tex", "at": "2:29"}
<- {
     "id": 14,
     "result": {
       "signatures": [
         {
           "label": "\\text{lerp}(ℝ, ℝ, ℝ): ℝ",
           "documentation": {
             "kind": "plaintext",
             "value": "\\text{lerp}: ℝ × ℝ × ℝ → ℝ\n\nfrom the first argument to the second by the third\n\na function that needs no definition"
           },
           "parameters": [{"label":"ℝ"},{"label":"ℝ"},{"label":"ℝ"}]
         }
       ],
       "activeSignature": 0,
       "activeParameter": 1
     }
   }
-> textDocument/completion {"doc": "b.tex", "at": "3:25"}
<- {
     "id": 15,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "jj",
           "kind": 6,
           "detail": "ℝ",
           "sortText": "00",
           "textEdit": {"range":"3:24-3:25","newText":"jj"},
           "data": {"uri":"b.tex","kind":"parameter"}
         }
       ]
     }
   }
=> exit status 1
