# A client that pulls and asks that nothing is pushed.
client {"capabilities": {"textDocument": {"diagnostic": {}}}, "initializationOptions": {"diagnostics": {"delivery": "pull"}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = zz
| \end{equation}
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
-> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "1"}
<- {"id":2,"result":{"kind":"unchanged","resultId":"1"}}
# An edit that changes no diagnostic leaves the client's result good.
change a.tex 2:9-2:9 " "
+> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "1"}
<- {"id":3,"result":{"kind":"unchanged","resultId":"1"}}
# One that does gives another, for the text as it is in front of the request.
change a.tex 2:7-2:9 "1"
+> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "1"}
+ change a.tex 2:7-2:8 "("
+> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "2"}
<- {"id":4,"result":{"kind":"full","resultId":"2","items":[]}}
<- {
     "id": 5,
     "result": {
       "kind": "full",
       "resultId": "3",
       "items": [{"range":"2:7-2:8","severity":1,"code":"E2003","source":"texbrdf","message":"`(` is never closed"}]
     }
   }
# A result of a document that was closed is not good for the one that is opened again.
-> textDocument/didClose {"doc": "a.tex"}
-> textDocument/diagnostic {"doc": "a.tex"}
<- {"id":6,"error":{"code":-32602,"message":"/work/a.tex is not open"}}
open a.tex
| \begin{equation}
|   f = 1
| \end{equation}
-> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "3"}
<- {"id":7,"result":{"kind":"full","resultId":"4","items":[]}}
-> textDocument/diagnostic {"doc": "a.tex", "previousResultId": "made up"}
<- {"id":8,"result":{"kind":"full","resultId":"4","items":[]}}
-> textDocument/diagnostic {}
<- {"id":9,"error":{"code":-32602,"message":"`textDocument` has to be an object"}}
=> exit status 1
