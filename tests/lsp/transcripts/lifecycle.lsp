# Before `initialize` every other request is refused, and notifications are dropped.
-> textDocument/hover {"doc": "a.tex", "at": "1:1"}
<- {"id":0,"error":{"code":-32002,"message":"the server is not initialized"}}
-> textDocument/didOpen {"textDocument": {"uri": "file:///work/a.tex", "languageId": "latex", "version": 1, "text": "x"}}
-> $/setTrace {"value": "off"}
-> initialize {"processId": null, "clientInfo": {"name": "transcript"}, "capabilities": {}}
<- {
     "id": 1,
     "result": {
       "capabilities": {
         "positionEncoding": "utf-16",
         "textDocumentSync": {"openClose":true,"change":2,"save":true},
         "hoverProvider": true,
         "definitionProvider": true,
         "referencesProvider": {"workDoneProgress":true},
         "documentSymbolProvider": true,
         "renameProvider": {"workDoneProgress":true},
         "documentHighlightProvider": true,
         "foldingRangeProvider": true,
         "semanticTokensProvider": {
           "legend": {
             "tokenTypes": ["function","variable","parameter","number","operator","keyword","macro"],
             "tokenModifiers": ["declaration","definition","defaultLibrary"]
           },
           "range": true,
           "full": {"delta":true}
         },
         "inlayHintProvider": true,
         "codeLensProvider": {"resolveProvider":true},
         "completionProvider": {"triggerCharacters":["\\","{","_"],"resolveProvider":true},
         "signatureHelpProvider": {"triggerCharacters":["(",","]},
         "workspace": {"workspaceFolders":{"supported":true,"changeNotifications":true}},
         "experimental": {"texbrdf":{"preview":true}}
       },
       "serverInfo": {"name":"texbrdf","version":"0.0"}
     }
   }
-> initialized {}

# Once is enough.
client {"capabilities": {}}
<- {"id":2,"error":{"code":-32600,"message":"the server is initialized already"}}

# After `shutdown` nothing but `exit` is taken.
-> shutdown
<- {"id":3,"result":null}
-> textDocument/hover {"doc": "a.tex", "at": "1:1"}
<- {"id":4,"error":{"code":-32600,"message":"the server is shut down"}}
-> no/such/method
<- {"id":5,"error":{"code":-32600,"message":"the server is shut down"}}
-> shutdown
<- {"id":6,"error":{"code":-32600,"message":"the server is shut down"}}
client {"capabilities": {}}
<- {"id":7,"error":{"code":-32600,"message":"the server is shut down"}}
-> textDocument/didOpen {"textDocument": {"uri": "file:///work/a.tex", "languageId": "latex", "version": 1, "text": "x"}}
-> exit
=> exit status 0
