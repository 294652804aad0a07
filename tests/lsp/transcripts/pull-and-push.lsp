# A client that could pull but does not ask for it gets its diagnostics pushed, and is answered when it asks.
client {"capabilities": {"textDocument": {"diagnostic": {"dynamicRegistration": true}}, "workspace": {"diagnostics": {"refreshSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = zz
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:7-2:9",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/diagnostic {"doc": "a.tex"}
<- {
     "id": 1,
     "result": {
       "kind": "full",
       "resultId": "1",
       "items": [
         {
           "range": "2:7-2:9",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `f`"
         }
       ]
     }
   }
# Now it asks for it: the server registers what was not announced, and takes back what it pushed.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"diagnostics": {"delivery": "pull"}}}}
<- {
     "id": 1,
     "method": "client/registerCapability",
     "params": {
       "registrations": [
         {
           "id": "textDocument/diagnostic",
           "method": "textDocument/diagnostic",
           "registerOptions": {
             "documentSelector": null,
             "identifier": "texbrdf",
             "interFileDependencies": true,
             "workspaceDiagnostics": false
           }
         }
       ]
     }
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","diagnostics":[]}}
reply 1 null
change a.tex 2:7-2:9 "yy"
-> textDocument/diagnostic {"doc": "a.tex"}
<- {
     "id": 2,
     "result": {
       "kind": "full",
       "resultId": "2",
       "items": [
         {
           "range": "2:7-2:9",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `yy` in the definition of `f`"
         }
       ]
     }
   }
# Another severity: what the client has is outdated.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"diagnostics": {"delivery": "pull", "hints": "off"}}}}
<- {"id":2,"method":"workspace/diagnostic/refresh"}
# And back.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {}}}
<- {
     "id": 3,
     "method": "client/unregisterCapability",
     "params": {"unregisterations":[{"id":"textDocument/diagnostic","method":"textDocument/diagnostic"}]}
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {
           "range": "2:7-2:9",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `yy` in the definition of `f`"
         }
       ]
     }
   }
=> exit status 1
