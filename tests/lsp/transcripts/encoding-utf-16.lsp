# Without a choice, columns count UTF-16 units: the sign before the error is two of them.
client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = \text{𝔹é} + zz
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:7-2:17",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{𝔹é}` in the definition of `f`"
         },
         {
           "range": "2:20-2:22",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:20-2:22 "1"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {
           "range": "2:7-2:17",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{𝔹é}` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:13-2:15 ""
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "2:7-2:15",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{é}` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {"id":1,"result":[{"name":"f","kind":13,"location":{"uri":"a.tex","range":"2:3-2:19"}}]}
=> exit status 1
