client {"capabilities": {"workspace": {"workspaceEdit": {"documentChanges": true}}, "textDocument": {"publishDiagnostics": {"relatedInformation": true}, "codeAction": {"codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix"]}}}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   g(x) = x \times \vec{n}
| \end{equation}
| \begin{equation}
|   f = g((\vec{h})
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:5-2:6",
           "severity": 4,
           "code": "E4005",
           "source": "texbrdf",
           "message": "`x` is taken as a vector; write `\\vec{x}`"
         },
         {
           "range": "5:8-5:9",
           "severity": 1,
           "code": "E2003",
           "source": "texbrdf",
           "message": "`(` is never closed",
           "relatedInformation": [
             {
               "location": {"uri":"a.tex","range":"6:1-6:5"},
               "message": "found the end of the equation instead of `)`"
             }
           ]
         }
       ]
     }
   }

# The edit names the version that it is for; several places change at once.
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 1, "character": 4}, "end": {"line": 1, "character": 4}}, "context": {"diagnostics": []}}
<- {
     "id": 1,
     "result": [
       {
         "title": "write `\\vec{x}`",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "2:5-2:6",
             "severity": 4,
             "code": "E4005",
             "source": "texbrdf",
             "message": "`x` is taken as a vector; write `\\vec{x}`"
           }
         ],
         "edit": {
           "documentChanges": [
             {
               "textDocument": {"uri":"a.tex","version":1},
               "edits": [{"range":"2:5-2:6","newText":"\\vec{x}"},{"range":"2:10-2:11","newText":"\\vec{x}"}]
             }
           ]
         }
       }
     ]
   }
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 4, "character": 7}, "end": {"line": 4, "character": 7}}, "context": {"diagnostics": []}}
<- {
     "id": 2,
     "result": [
       {
         "title": "insert `)`",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "5:8-5:9",
             "severity": 1,
             "code": "E2003",
             "source": "texbrdf",
             "message": "`(` is never closed",
             "relatedInformation": [
               {
                 "location": {"uri":"a.tex","range":"6:1-6:5"},
                 "message": "found the end of the equation instead of `)`"
               }
             ]
           }
         ],
         "edit": {
           "documentChanges": [{"textDocument":{"uri":"a.tex","version":1},"edits":[{"range":"5:18-5:18","newText":")"}]}]
         }
       }
     ]
   }
=> exit status 1
