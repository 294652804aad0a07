# Requests that wait behind others are cancelled before they are begun, whatever they ask; an edit that waits between
# two requests is seen by the second only.
client {"capabilities": {"textDocument": {"documentSymbol": {"hierarchicalDocumentSymbolSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation} f = b \end{equation}
| \begin{equation} b = 1 \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> textDocument/references {"doc": "a.tex", "at": "2:18", "context": {"includeDeclaration": true}}
+> textDocument/references {"doc": "a.tex", "at": "2:18", "context": {"includeDeclaration": true}}
+> textDocument/rename {"doc": "a.tex", "at": "2:18", "newName": "c"}
+> textDocument/documentSymbol {"doc": "a.tex"}
+> textDocument/semanticTokens/full {"doc": "a.tex"}
+ change a.tex 1:18-1:23 "f = b + b"
+> textDocument/references {"doc": "a.tex", "at": "2:18", "context": {"includeDeclaration": true}}
+> textDocument/rename {"doc": "a.tex", "at": "2:18", "newName": "c"}
+> $/cancelRequest {"id": 5}
+> $/cancelRequest {"id": 4}
+> $/cancelRequest {"id": 3}
+> $/cancelRequest {"id": 2}
<- {"id":1,"result":[{"uri":"a.tex","range":"1:22-1:23"},{"uri":"a.tex","range":"2:18-2:19"}]}
<- {"id":2,"error":{"code":-32800,"message":"cancelled by the client"}}
<- {"id":3,"error":{"code":-32800,"message":"cancelled by the client"}}
<- {"id":4,"error":{"code":-32800,"message":"cancelled by the client"}}
<- {"id":5,"error":{"code":-32800,"message":"cancelled by the client"}}
<- {
     "id": 6,
     "result": [
       {"uri":"a.tex","range":"1:22-1:23"},
       {"uri":"a.tex","range":"1:26-1:27"},
       {"uri":"a.tex","range":"2:18-2:19"}
     ]
   }
<- {
     "id": 7,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"1:22-1:23","newText":"c"},
           {"range":"1:26-1:27","newText":"c"},
           {"range":"2:18-2:19","newText":"c"}
         ]
       }
     }
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
# Semantic tokens that nobody got are no base for a delta.
-> textDocument/semanticTokens/full/delta {"doc": "a.tex", "previousResultId": "1"}
<- {
     "id": 8,
     "result": {
       "resultId": "1",
       "data": [0,17,1,1,2,0,2,1,4,0,0,2,1,1,0,0,2,1,4,0,0,2,1,1,0,1,17,1,1,2,0,2,1,4,0,0,2,1,3,0]
     }
   }
=> exit status 1
