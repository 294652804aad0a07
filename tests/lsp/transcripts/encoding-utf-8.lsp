# The first encoding of the client that is known: columns count bytes, four for the sign before the error.
client {"capabilities": {"general": {"positionEncodings": ["latin-1", "utf-8", "utf-16"]}}}
<- {"id":0,"positionEncoding":"utf-8"}
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
           "range": "2:7-2:20",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{𝔹é}` in the definition of `f`"
         },
         {
           "range": "2:23-2:25",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:23-2:25 "1"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {
           "range": "2:7-2:20",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{𝔹é}` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:13-2:17 ""
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "2:7-2:16",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\text{é}` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {"id":1,"result":[{"name":"f","kind":13,"location":{"uri":"a.tex","range":"2:3-2:20"}}]}
=> exit status 1
