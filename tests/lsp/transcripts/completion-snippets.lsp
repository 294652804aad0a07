client {"capabilities": {"general": {"positionEncodings": ["utf-8"]}, "textDocument": {"completion": {"completionItem": {"snippetSupport": true, "documentationFormat": ["markdown"]}}}}}
<- {"id":0,"positionEncoding":"utf-8"}
open a.tex
| \begin{equation}
|   gauss(m, \vec{t}) = m * \vec{t}
| \end{equation}
| \begin{equation}
|   f = 𝔹 + ga
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {"range":"2:3-2:8","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `gauss`"},
         {
           "range": "5:7-5:11",
           "severity": 1,
           "code": "E1001",
           "source": "texbrdf",
           "message": "unexpected character `𝔹`"
         },
         {
           "range": "5:14-5:16",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `ga` in the definition of `f`"
         }
       ]
     }
   }

# Functions with their parameters; the range counts bytes.
-> textDocument/completion {"doc": "a.tex", "at": "5:16"}
<- {
     "id": 1,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "gauss",
           "kind": 3,
           "detail": "ℝ × ℝ³ → ℝ³",
           "sortText": "01",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:14-5:16","newText":"gauss(${1:m}, ${2:\\\\vec{t\\}})"},
           "data": {"uri":"a.tex","kind":"definition"}
         }
       ]
     }
   }

# Commands with places to fill in, the ones first that give the type that fits.
change a.tex 5:7-5:16 "\\vec{n} \\times \\ve"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {"range":"2:3-2:8","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `gauss`"},
         {
           "range": "5:22-5:25",
           "severity": 1,
           "code": "E3003",
           "source": "texbrdf",
           "message": "unknown command `\\ve`"
         }
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "5:25"}
<- {
     "id": 2,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\vec{\\omega_i}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"5:22-5:25","newText":"\\vec{\\omega_i}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{\\omega_o}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"5:22-5:25","newText":"\\vec{\\omega_o}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{n}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"5:22-5:25","newText":"\\vec{n}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{h}",
           "kind": 12,
           "detail": "ℝ³",
           "sortText": "03",
           "textEdit": {"range":"5:22-5:25","newText":"\\vec{h}"},
           "data": {"uri":"a.tex","kind":"convention"}
         },
         {
           "label": "\\vec{…, …, …}",
           "kind": 15,
           "sortText": "05",
           "filterText": "\\vec",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:22-5:25","newText":"\\\\vec{$1, $2, $3}"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\vec{…}",
           "kind": 15,
           "sortText": "15",
           "filterText": "\\vec",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:22-5:25","newText":"\\\\vec{$1}"},
           "data": {"uri":"a.tex","kind":"command"}
         }
       ]
     }
   }
change a.tex 5:7-5:25 "\\m"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {"range":"2:3-2:8","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `gauss`"},
         {"range":"5:7-5:9","severity":1,"code":"E3003","source":"texbrdf","message":"unknown command `\\m`"}
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "5:9"}
<- {
     "id": 3,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\max(…, …)",
           "kind": 15,
           "sortText": "05",
           "filterText": "\\max",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:7-5:9","newText":"\\\\max($1, $2)"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\min(…, …)",
           "kind": 15,
           "sortText": "05",
           "filterText": "\\min",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:7-5:9","newText":"\\\\min($1, $2)"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\mathbf{…}",
           "kind": 15,
           "sortText": "05",
           "filterText": "\\mathbf",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:7-5:9","newText":"\\\\mathbf{$1}"},
           "data": {"uri":"a.tex","kind":"command"}
         },
         {
           "label": "\\mathrm{…}",
           "kind": 15,
           "sortText": "05",
           "filterText": "\\mathrm",
           "insertTextFormat": 2,
           "textEdit": {"range":"5:7-5:9","newText":"\\\\mathrm{$1}"},
           "data": {"uri":"a.tex","kind":"command"}
         }
       ]
     }
   }

# Where arguments stand already, only the name.
change a.tex 5:7-5:9 "ga(1, \\vec{n})"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 4,
       "diagnostics": [
         {"range":"2:3-2:8","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `gauss`"},
         {
           "range": "5:7-5:9",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `ga` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "5:9"}
<- {
     "id": 4,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "gauss",
           "kind": 3,
           "detail": "ℝ × ℝ³ → ℝ³",
           "sortText": "01",
           "textEdit": {"range":"5:7-5:9","newText":"gauss"},
           "data": {"uri":"a.tex","kind":"definition"}
         }
       ]
     }
   }
-> completionItem/resolve {"label": "gauss", "data": {"uri": "file:///work/a.tex", "kind": "definition"}}
<- {
     "id": 5,
     "result": {
       "data": {"kind":"definition","uri":"a.tex"},
       "label": "gauss",
       "documentation": {
         "kind": "markdown",
         "value": "`gauss`: `ℝ × ℝ³ → ℝ³`\n\n```latex\ngauss(m, \\vec{t}) = m * \\vec{t}\n```\n\ndefined on line 2"
       }
     }
   }
=> exit status 1
