client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
-> texbrdf/stats
<- {
     "id": 1,
     "result": {
       "requests": 2,
       "notifications": 0,
       "cancelled": 0,
       "errors": 0,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
open a.tex
| \begin{equation}
|   f = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> texbrdf/stats
<- {
     "id": 2,
     "result": {
       "requests": 3,
       "notifications": 1,
       "cancelled": 0,
       "errors": 0,
       "published": 1,
       "workspaceFolders": [],
       "documents": [
         {
           "uri": "a.tex",
           "version": 1,
           "bytes": 39,
           "blocks": 1,
           "definitions": 1,
           "blocksScanned": 1,
           "blocksParsed": 1,
           "definitionsChecked": 1,
           "diagnosticsPending": false
         }
       ]
     }
   }
change a.tex 2:7-2:8 "2"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
-> no/such
<- {"id":3,"error":{"code":-32601,"message":"no method no/such"}}
-> texbrdf/stats
<- {
     "id": 4,
     "result": {
       "requests": 5,
       "notifications": 2,
       "cancelled": 0,
       "errors": 1,
       "published": 2,
       "workspaceFolders": [],
       "documents": [
         {
           "uri": "a.tex",
           "version": 2,
           "bytes": 39,
           "blocks": 1,
           "definitions": 1,
           "blocksScanned": 1,
           "blocksParsed": 1,
           "definitionsChecked": 1,
           "diagnosticsPending": false
         }
       ]
     }
   }
=> exit status 1
