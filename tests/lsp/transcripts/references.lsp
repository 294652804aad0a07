client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = x_{1} + g(x_1) + \theta_h
| \end{equation}
| \begin{equation}
|   g(x) = x * x + x_1 * \theta_h
| \end{equation}
| \begin{equation}
|   x_1 = 2
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}

# Every spelling of the name, with and without its definition.
-> textDocument/references {"doc": "a.tex", "at": "8:3", "context": {"includeDeclaration": true}}
<- {
     "id": 1,
     "result": [
       {"uri":"a.tex","range":"2:7-2:12"},
       {"uri":"a.tex","range":"2:17-2:20"},
       {"uri":"a.tex","range":"5:18-5:21"},
       {"uri":"a.tex","range":"8:3-8:6"}
     ]
   }
-> textDocument/references {"doc": "a.tex", "at": "2:8", "context": {"includeDeclaration": false}}
<- {
     "id": 2,
     "result": [
       {"uri":"a.tex","range":"2:7-2:12"},
       {"uri":"a.tex","range":"2:17-2:20"},
       {"uri":"a.tex","range":"5:18-5:21"}
     ]
   }
# A parameter stays in its function.
-> textDocument/references {"doc": "a.tex", "at": "5:10", "context": {"includeDeclaration": true}}
<- {
     "id": 3,
     "result": [
       {"uri":"a.tex","range":"5:5-5:6"},
       {"uri":"a.tex","range":"5:10-5:11"},
       {"uri":"a.tex","range":"5:14-5:15"}
     ]
   }
-> textDocument/references {"doc": "a.tex", "at": "5:10", "context": {"includeDeclaration": false}}
<- {"id":4,"result":[{"uri":"a.tex","range":"5:10-5:11"},{"uri":"a.tex","range":"5:14-5:15"}]}
# A convention, and nothing.
-> textDocument/references {"doc": "a.tex", "at": "2:26", "context": {"includeDeclaration": true}}
<- {"id":5,"result":[{"uri":"a.tex","range":"2:24-2:32"},{"uri":"a.tex","range":"5:24-5:32"}]}
-> textDocument/references {"doc": "a.tex", "at": "2:5", "context": {"includeDeclaration": true}}
<- {"id":6,"result":[]}
=> exit status 1
