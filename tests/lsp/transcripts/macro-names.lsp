client {"capabilities": {"textDocument": {"completion": {"completionItem": {"snippetSupport": true}}, "definition": {"linkSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \newcommand{\rough}{0.3}
| \newcommand{\sq}[1]{(#1)^2} % \sq in a comment
| \newcommand{\cube}[1]{\sq{#1} #1}
| \DeclareMathOperator{\toward}{lerp}
| \renewcommand{\vec}[1]{\mathbf{#1}}
| The macro $\sq{x}$ squares, \verb|\sq| is code.
| \begin{equation}
|   m = \rough
| \end{equation}
| \begin{equation}
|   f = \cube{m} + \sq m + \toward(m, 1, 0.5)
| \end{equation}
| \begin{verbatim}
| \sq 100% \sq
| \end{verbatim}
| 100\% of \sq{x}, \\sq
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
# In the bodies of other macros and in prose as well; not in comments and verbatim text.
-> textDocument/references {"doc": "a.tex", "at": "2:14", "context": {"includeDeclaration": true}}
<- {
     "id": 1,
     "result": [
       {"uri":"a.tex","range":"2:13-2:16"},
       {"uri":"a.tex","range":"3:23-3:26"},
       {"uri":"a.tex","range":"6:12-6:15"},
       {"uri":"a.tex","range":"11:18-11:21"},
       {"uri":"a.tex","range":"16:10-16:13"}
     ]
   }
-> textDocument/prepareRename {"doc": "a.tex", "at": "6:12"}
<- {"id":2,"result":{"range":"6:12-6:15","placeholder":"\\sq"}}
-> textDocument/rename {"doc": "a.tex", "at": "11:19", "newName": "\\squared"}
<- {
     "id": 3,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"2:13-2:16","newText":"\\squared"},
           {"range":"3:23-3:26","newText":"\\squared"},
           {"range":"6:12-6:15","newText":"\\squared"},
           {"range":"11:18-11:21","newText":"\\squared"},
           {"range":"16:10-16:13","newText":"\\squared"}
         ]
       }
     }
   }
-> textDocument/rename {"doc": "a.tex", "at": "11:19", "newName": "cube"}
<- {"id":4,"error":{"code":-32803,"message":"`\\cube` stands on line 3 already"}}
-> textDocument/rename {"doc": "a.tex", "at": "11:19", "newName": "\\alpha"}
<- {"id":5,"error":{"code":-32803,"message":"`\\alpha` is a command of LaTeX"}}
-> textDocument/rename {"doc": "a.tex", "at": "11:19", "newName": "sq2"}
<- {"id":6,"error":{"code":-32803,"message":"a macro's name is made of letters"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:16", "newName": "v"}
<- {"id":7,"error":{"code":-32803,"message":"`\\vec` is a command of LaTeX and keeps its name"}}
-> textDocument/hover {"doc": "a.tex", "at": "3:24"}
<- {
     "id": 8,
     "result": {
       "contents": {"kind":"markdown","value":"```latex\n\\newcommand{\\sq}[1]{(#1)^2}\n```\n\nmacro, defined on line 2"},
       "range": "3:23-3:26"
     }
   }
-> textDocument/definition {"doc": "a.tex", "at": "11:27"}
<- {
     "id": 9,
     "result": [
       {
         "originSelectionRange": "11:26-11:33",
         "targetUri": "a.tex",
         "targetRange": "4:1-4:36",
         "targetSelectionRange": "4:22-4:29"
       }
     ]
   }
# A macro that is nothing but a number and used once is what a slider changes.
-> texbrdf/parameterEdit {"uri": "file:///work/a.tex", "name": "m", "value": [0.45]}
<- {"id":10,"result":{"changes":{"file:///work/a.tex":[{"range":"1:21-1:24","newText":"0.45"}]}}}
change a.tex 11:7-11:7 "\\rough "
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
-> texbrdf/parameterEdit {"uri": "file:///work/a.tex", "name": "m", "value": [0.45]}
<- {"id":11,"error":{"code":-32602,"message":"`m` is no parameter of this kind"}}
change a.tex 11:7-11:13 "\\ro"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "11:7-11:10",
           "severity": 1,
           "code": "E3003",
           "source": "texbrdf",
           "message": "unknown command `\\ro`"
         }
       ]
     }
   }
-> textDocument/completion {"doc": "a.tex", "at": "11:10"}
<- {
     "id": 12,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\rough",
           "kind": 1,
           "detail": "0.3",
           "sortText": "02",
           "textEdit": {"range":"11:7-11:10","newText":"\\rough"},
           "data": {"uri":"a.tex","kind":"macro"}
         }
       ]
     }
   }
=> exit status 1
