# A client without any capability: locations, flat symbols, diagnostics without links and related places.
client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   g(x, \vec{v}) = x * \vec{v}
| \end{equation}
| \begin{equation}
|   f = g(2, \vec{n})
| \end{equation}
| \begin{equation}
|   f = 3
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "8:3-8:4",
           "severity": 1,
           "code": "E3006",
           "source": "texbrdf",
           "message": "`f` is defined more than once; another definition is in force"
         }
       ]
     }
   }
-> textDocument/definition {"doc": "a.tex", "at": "5:7"}
<- {"id":1,"result":{"uri":"a.tex","range":"2:3-2:4"}}
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {
     "id": 2,
     "result": [
       {"name":"g","kind":12,"location":{"uri":"a.tex","range":"2:3-2:30"}},
       {"name":"x","kind":26,"location":{"uri":"a.tex","range":"2:5-2:6"},"containerName":"g"},
       {"name":"\\vec{v}","kind":26,"location":{"uri":"a.tex","range":"2:8-2:15"},"containerName":"g"},
       {"name":"f","kind":13,"location":{"uri":"a.tex","range":"5:3-5:20"}},
       {"name":"f","kind":13,"location":{"uri":"a.tex","range":"8:3-8:8"}}
     ]
   }
=> exit status 1
