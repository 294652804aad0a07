client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| prose
| \begin{equation}
|   a = 1
| \end{equation}
| \begin{equation} b = 2 \end{equation}
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
           "range": "6:1-6:17",
           "severity": 1,
           "code": "E2005",
           "source": "texbrdf",
           "message": "`\\begin{equation}` has no `\\end{equation}`"
         }
       ]
     }
   }
-> textDocument/foldingRange {"doc": "a.tex"}
<- {
     "id": 1,
     "result": [
       {"startLine":1,"startCharacter":16,"endLine":3,"endCharacter":0},
       {"startLine":5,"startCharacter":16,"endLine":7,"endCharacter":5}
     ]
   }
=> exit status 1
