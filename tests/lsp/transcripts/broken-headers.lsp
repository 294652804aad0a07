client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
raw "hello\r\n\r\n"
<- {"id":null,"error":{"code":-32700,"message":"unreadable input is skipped: no header field: hello"}}
-> texbrdf/stats
<- {
     "id": 1,
     "result": {
       "requests": 2,
       "notifications": 0,
       "cancelled": 0,
       "errors": 1,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
raw "Content-Length: -1\r\n\r\n{}"
<- {
     "id": null,
     "error": {"code":-32700,"message":"unreadable input is skipped: Content-Length is no natural number: -1"}
   }
-> texbrdf/stats
<- {
     "id": 2,
     "result": {
       "requests": 3,
       "notifications": 0,
       "cancelled": 0,
       "errors": 2,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
raw "Content-Length: 99999999999\r\n\r\n{}"
<- {
     "id": null,
     "error": {
       "code": -32700,
       "message": "unreadable input is skipped: a message of 99999999999 bytes is longer than 268435456"
     }
   }
-> texbrdf/stats
<- {
     "id": 3,
     "result": {
       "requests": 4,
       "notifications": 0,
       "cancelled": 0,
       "errors": 3,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
raw "Content-Type: application/vscode-jsonrpc\r\n\r\n{}"
<- {"id":null,"error":{"code":-32700,"message":"unreadable input is skipped: header without Content-Length"}}
-> texbrdf/stats
<- {
     "id": 4,
     "result": {
       "requests": 5,
       "notifications": 0,
       "cancelled": 0,
       "errors": 4,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
# A length that is too short: the rest is garbage. One that is too long would take the next message with it.
raw "Content-Length: 5\r\n\r\n{\"jsonrpc\":\"2.0\"}"
<- {"id":null,"error":{"code":-32700,"message":"the message is not JSON"}}
-> texbrdf/stats
<- {
     "id": null,
     "error": {
       "code": -32700,
       "message": "unreadable input is skipped: no header field: nrpc\":\"2.0\"}Content-Length: 49"
     }
   }
<- {
     "id": 5,
     "result": {
       "requests": 6,
       "notifications": 0,
       "cancelled": 0,
       "errors": 6,
       "published": 0,
       "workspaceFolders": [],
       "documents": []
     }
   }
# Another field before the length, and a lower-case name.
raw "Content-Type: application/vscode-jsonrpc; charset=utf-8\r\ncontent-length: 61\r\n\r\n{\"jsonrpc\":\"2.0\",\"id\":\"last\",\"method\":\"shutdown\",\"params\":{}}"
<- {"id":"last","result":null}
=> exit status 0
