client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}

# What is no JSON, no message, or no message of this version.
frame "{bad json"
<- {"id":null,"error":{"code":-32700,"message":"the message is not JSON"}}
frame ""
<- {"id":null,"error":{"code":-32700,"message":"the message is not JSON"}}
frame "17"
<- {"id":null,"error":{"code":-32600,"message":"the message is not an object"}}
frame "[]"
<- {"id":null,"error":{"code":-32600,"message":"batches are not part of the protocol"}}
frame "[{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"shutdown\"}]"
<- {"id":null,"error":{"code":-32600,"message":"batches are not part of the protocol"}}
frame "{\"id\":\"x\",\"method\":\"shutdown\"}"
<- {"id":"x","error":{"code":-32600,"message":"`jsonrpc` is not \"2.0\""}}
frame "{\"jsonrpc\":\"2.0\",\"id\":\"x\"}"
<- {"id":"x","error":{"code":-32600,"message":"the message has no `method`"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":\"x\",\"method\":3}"
<- {"id":"x","error":{"code":-32600,"message":"`method` is not a string"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":[1],\"method\":\"shutdown\"}"
<- {"id":null,"error":{"code":-32600,"message":"`id` is no string or integer"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":1.5,\"method\":\"shutdown\"}"
<- {"id":null,"error":{"code":-32600,"message":"`id` is no string or integer"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":9,\"method\":\"shutdown\",\"params\":\"none\"}"
<- {"id":9,"error":{"code":-32600,"message":"`params` is no object or array"}}

# Ids are given back as they came: strings, negative, huge, null.
frame "{\"jsonrpc\":\"2.0\",\"id\":\"a \\\"b\\\" \\u211d\",\"method\":\"no/such\"}"
<- {"id":"a \"b\" ℝ","error":{"code":-32601,"message":"no method no/such"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":-7,\"method\":\"no/such\"}"
<- {"id":-7,"error":{"code":-32601,"message":"no method no/such"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":18446744073709551615,\"method\":\"no/such\"}"
<- {"id":18446744073709551615,"error":{"code":-32601,"message":"no method no/such"}}
frame "{\"jsonrpc\":\"2.0\",\"id\":null,\"method\":\"no/such\"}"
<- {"id":null,"error":{"code":-32601,"message":"no method no/such"}}

# Unknown requests are answered, unknown notifications are not.
-> no/such/method {}
<- {"id":1,"error":{"code":-32601,"message":"no method no/such/method"}}
-> $/no/such
frame "{\"jsonrpc\":\"2.0\",\"id\":11,\"method\":\"$/noSuchRequest\"}"
<- {"id":11,"error":{"code":-32601,"message":"no method $/noSuchRequest"}}
-> notify/nobody {}

# Responses that nobody waits for.
frame "{\"jsonrpc\":\"2.0\",\"id\":5,\"result\":null}"
frame "{\"jsonrpc\":\"2.0\",\"id\":null,\"error\":{\"code\":-32600,\"message\":\"?\"}}"

# Parameters that do not fit.
-> textDocument/hover
<- {"id":2,"error":{"code":-32602,"message":"`params` has to be an object"}}
-> textDocument/hover []
<- {"id":3,"error":{"code":-32602,"message":"`params` has to be an object"}}
-> textDocument/hover {}
<- {"id":4,"error":{"code":-32602,"message":"`textDocument` has to be an object"}}
-> textDocument/hover {"doc": "a.tex"}
<- {"id":5,"error":{"code":-32602,"message":"`position` has to be an object"}}
-> textDocument/hover {"doc": "a.tex", "position": {"line": -1, "character": 0}}
<- {"id":6,"error":{"code":-32602,"message":"`line` has to be a natural number"}}
-> textDocument/hover {"doc": "a.tex", "position": {"line": "1", "character": 0}}
<- {"id":7,"error":{"code":-32602,"message":"`line` has to be a natural number"}}
-> textDocument/references {"doc": "a.tex", "at": "1:1"}
<- {"id":8,"error":{"code":-32602,"message":"`context` has to be an object"}}

# A document that is not open.
-> textDocument/hover {"doc": "never opened.tex", "at": "1:1"}
<- {"id":9,"error":{"code":-32602,"message":"/work/never opened.tex is not open"}}
-> textDocument/definition {"doc": "never opened.tex", "at": "1:1"}
<- {"id":10,"error":{"code":-32602,"message":"/work/never opened.tex is not open"}}
-> textDocument/references {"doc": "never opened.tex", "at": "1:1", "context": {"includeDeclaration": true}}
<- {"id":11,"error":{"code":-32602,"message":"/work/never opened.tex is not open"}}
-> textDocument/documentSymbol {"doc": "never opened.tex"}
<- {"id":12,"error":{"code":-32602,"message":"/work/never opened.tex is not open"}}
change never-opened.tex "x"
-> textDocument/didClose {"doc": "never-opened.tex"}
-> textDocument/didSave {"doc": "never-opened.tex"}
-> shutdown
<- {"id":13,"result":null}
-> exit
=> exit status 0
