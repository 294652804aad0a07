client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}

# Cancelled while it still waits: the cancellation overtakes it. Its neighbours are answered.
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
+> textDocument/hover {"doc": "a.tex", "at": "2:3"}
+> textDocument/hover {"doc": "a.tex", "at": "1:1"}
+> $/cancelRequest {"id": 2}
<- {
     "id": 1,
     "result": {
       "contents": {"kind":"markdown","value":"`f`: `ℝ`\n\n```latex\nf = 1\n```\n\nvalue 1 · defined on line 2"},
       "range": "2:3-2:4"
     }
   }
<- {"id":2,"error":{"code":-32800,"message":"cancelled by the client"}}
<- {"id":3,"result":null}

# Too late, unknown, or without an id: nothing happens.
-> $/cancelRequest {"id": 1}
-> $/cancelRequest {"id": "nobody"}
-> $/cancelRequest {}
-> $/cancelRequest
-> texbrdf/stats
<- {
     "id": 4,
     "result": {
       "requests": 5,
       "notifications": 6,
       "cancelled": 1,
       "errors": 1,
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
=> exit status 1
