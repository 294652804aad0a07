client {"capabilities": {"textDocument": {"foldingRange": {"lineFoldingOnly": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| prose
| \begin{equation}
|   a = 1
| \end{equation}
| \begin{equation} b =
|  2 \end{equation}
| \begin{equation}
|   f =
|     a
|
| prose
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {"range":"5:18-5:19","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `b`"},
         {
           "range": "7:1-7:17",
           "severity": 1,
           "code": "E2005",
           "source": "texbrdf",
           "message": "`\\begin{equation}` has no `\\end{equation}`"
         }
       ]
     }
   }
-> textDocument/foldingRange {"doc": "a.tex"}
<- {"id":1,"result":[{"startLine":1,"endLine":2},{"startLine":6,"endLine":8}]}
=> exit status 1
