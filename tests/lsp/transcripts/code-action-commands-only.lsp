# A client that takes only commands is offered nothing: there are none.
client {"capabilities": {"textDocument": {"codeAction": {}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = exp(1)
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:7-2:10",
           "severity": 2,
           "code": "E2022",
           "source": "texbrdf",
           "message": "`exp` is read as `\\exp`"
         }
       ]
     }
   }
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 1, "character": 7}, "end": {"line": 1, "character": 7}}, "context": {"diagnostics": []}}
<- {"id":1,"result":[]}
=> exit status 1
