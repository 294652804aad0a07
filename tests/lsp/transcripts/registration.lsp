# A feature that is off at the start is not announced. A client that lets providers come later gets it when it is
# switched on; one that is announced stays so, and is answered with nothing.
-> initialize {"capabilities": {"textDocument": {"rename": {"dynamicRegistration": true, "prepareSupport": true}}}, "initializationOptions": {"features": {"diagnostics": true, "hover": false, "rename": false, "completion": false, "signatureHelp": false, "semanticTokens": false, "inlayHint": false, "codeLens": false, "codeAction": false, "foldingRange": false, "documentHighlight": false}}}
<- {
     "id": 0,
     "result": {
       "capabilities": {
         "positionEncoding": "utf-16",
         "textDocumentSync": {"openClose":true,"change":2,"save":true},
         "definitionProvider": true,
         "referencesProvider": {"workDoneProgress":true},
         "documentSymbolProvider": true,
         "workspace": {"workspaceFolders":{"supported":true,"changeNotifications":true}},
         "experimental": {"texbrdf":{"preview":true}}
       },
       "serverInfo": {"name":"texbrdf","version":"0.0"}
     }
   }
-> initialized {}
open a.tex
| \begin{equation}
|   f = a
| \end{equation}
| \begin{equation}
|   a = 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/prepareRename {"doc": "a.tex", "at": "2:7"}
<- {"id":1,"result":null}
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"rename": true}}}}
<- {
     "id": 1,
     "method": "client/registerCapability",
     "params": {
       "registrations": [
         {
           "id": "textDocument/rename",
           "method": "textDocument/rename",
           "registerOptions": {"documentSelector":null,"workDoneProgress":true,"prepareProvider":true}
         }
       ]
     }
   }
reply 1 null
-> textDocument/prepareRename {"doc": "a.tex", "at": "2:7"}
<- {"id":2,"result":{"range":"2:7-2:8","placeholder":"a"}}
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"rename": false}}}}
<- {
     "id": 2,
     "method": "client/unregisterCapability",
     "params": {"unregisterations":[{"id":"textDocument/rename","method":"textDocument/rename"}]}
   }
-> textDocument/rename {"doc": "a.tex", "at": "2:7", "newName": "b"}
<- {"id":3,"result":null}
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"rename": true, "definition": false}}}}
<- {
     "id": 3,
     "method": "client/registerCapability",
     "params": {
       "registrations": [
         {
           "id": "textDocument/rename",
           "method": "textDocument/rename",
           "registerOptions": {"documentSelector":null,"workDoneProgress":true,"prepareProvider":true}
         }
       ]
     }
   }
-> textDocument/definition {"doc": "a.tex", "at": "2:7"}
<- {"id":4,"result":null}
=> exit status 1
