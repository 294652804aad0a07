client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
# Everything that is there already is applied before anything is published: one publication for each document, of its
# last version, and requests in between see the text as it was at their place.
open a.tex
| \begin{equation}
|   f = 1
| \end{equation}
+ change a.tex 2:7-2:8 "zz"
+> textDocument/documentSymbol {"doc": "a.tex"}
+ open b.tex
| \begin{equation}
|   f = b
| \end{equation}
+ change a.tex 2:7-2:9 "g"
+ change a.tex 2:3-2:4 "h"
+> textDocument/documentSymbol {"doc": "a.tex"}
+ change b.tex 2:7-2:8 "2"
<- {"id":1,"result":[{"name":"f","kind":13,"location":{"uri":"a.tex","range":"2:3-2:9"}}]}
<- {"id":2,"result":[{"name":"h","kind":13,"location":{"uri":"a.tex","range":"2:3-2:8"}}]}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":4,"diagnostics":[]}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"b.tex","version":2,"diagnostics":[]}}

# Closed in the same burst: only the end is told.
change a.tex 2:7-2:8 "5"
+> textDocument/didClose {"doc": "a.tex"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","diagnostics":[]}}

# Closed and opened again: its diagnostics are those of the new text.
-> textDocument/didClose {"doc": "b.tex"}
+ open b.tex
| \begin{equation}
|   f = c
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "b.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:7-2:8",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `c` in the definition of `f`"
         }
       ]
     }
   }
=> exit status 1
