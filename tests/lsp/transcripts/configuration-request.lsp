# A client that can be asked for its settings is asked, at the start and after each change.
client {"capabilities": {"workspace": {"configuration": true, "didChangeConfiguration": {"dynamicRegistration": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> initialized {}
<- {
     "id": 1,
     "method": "client/registerCapability",
     "params": {
       "registrations": [
         {
           "id": "workspace/didChangeConfiguration",
           "method": "workspace/didChangeConfiguration",
           "registerOptions": {"section":"texbrdf"}
         }
       ]
     }
   }
<- {"id":2,"method":"workspace/configuration","params":{"items":[{"section":"texbrdf"}]}}
reply 1 null
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 1,
     "result": {
       "contents": {"kind":"markdown","value":"`f`: `ℝ`\n\n```latex\nf = 1\n```\n\nvalue 1 · defined on line 2"},
       "range": "2:3-2:4"
     }
   }
reply 2 [{"features": {"hover": false}}]
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {"id":2,"result":null}
# What the notification itself says is not looked at.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"hover": true}}}}
<- {"id":3,"method":"workspace/configuration","params":{"items":[{"section":"texbrdf"}]}}
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {"id":3,"result":null}
# Replies to nothing, and of the wrong kind.
reply 2 [{"features": {"hover": true}}]
reply 77 [{"features": {"hover": true}}]
reply "3" [{"features": {"hover": true}}]
frame "{\"jsonrpc\": \"2.0\", \"id\": 3, \"error\": {\"code\": -32601, \"message\": \"no\"}}"
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {"id":4,"result":null}
-> workspace/didChangeConfiguration {"settings": null}
<- {"id":4,"method":"workspace/configuration","params":{"items":[{"section":"texbrdf"}]}}
reply 4 []
-> workspace/didChangeConfiguration {"settings": null}
<- {"id":5,"method":"workspace/configuration","params":{"items":[{"section":"texbrdf"}]}}
reply 5 [null]
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 5,
     "result": {
       "contents": {"kind":"markdown","value":"`f`: `ℝ`\n\n```latex\nf = 1\n```\n\nvalue 1 · defined on line 2"},
       "range": "2:3-2:4"
     }
   }
# Nothing is asked of a client that has ended the session.
-> workspace/didChangeConfiguration {"settings": null}
+> shutdown
<- {"id":6,"method":"workspace/configuration","params":{"items":[{"section":"texbrdf"}]}}
<- {"id":6,"result":null}
reply 6 [{"features": {"hover": false}}]
-> exit
=> exit status 0
