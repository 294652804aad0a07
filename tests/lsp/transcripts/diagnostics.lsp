client {"capabilities": {"textDocument": {"publishDiagnostics": {"relatedInformation": true, "codeDescriptionSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}

# No equation and no result: a document without f.
open good.tex
| \documentclass{article}
| \begin{document}
| \begin{equation}
|   f = \frac{\rho_d}{\pi}
| \end{equation}
| \begin{equation}
|   \rho_d = \vec{0.5, 0.5, 0.25}
| \end{equation}
| \end{document}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"good.tex","version":1,"diagnostics":[]}}

# Two errors in two blocks, with a related place.
open bad.tex
| \begin{equation}
|   a = 1 + \rho_s
| \end{equation}
| \begin{equation}
|   a = 2
| \end{equation}
| \begin{equation}
|   f = a
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "bad.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:11-2:17",
           "severity": 1,
           "code": "E3001",
           "codeDescription": {"href":"docs#E3001"},
           "source": "texbrdf",
           "message": "undefined name `\\rho_s` in the definition of `a`"
         },
         {
           "range": "5:3-5:4",
           "severity": 1,
           "code": "E3006",
           "codeDescription": {"href":"docs#E3006"},
           "source": "texbrdf",
           "message": "`a` is defined more than once; another definition is in force",
           "relatedInformation": [{"location":{"uri":"bad.tex","range":"2:3-2:4"},"message":"this one is in force"}]
         }
       ]
     }
   }

# One mended, the other still there.
change bad.tex 2:11-2:17 "2"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "bad.tex",
       "version": 2,
       "diagnostics": [
         {
           "range": "5:3-5:4",
           "severity": 1,
           "code": "E3006",
           "codeDescription": {"href":"docs#E3006"},
           "source": "texbrdf",
           "message": "`a` is defined more than once; another definition is in force",
           "relatedInformation": [{"location":{"uri":"bad.tex","range":"2:3-2:4"},"message":"this one is in force"}]
         }
       ]
     }
   }
change bad.tex 5:3-5:4 "b"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "bad.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "5:3-5:4",
           "severity": 4,
           "code": "E3013",
           "codeDescription": {"href":"docs#E3013"},
           "source": "texbrdf",
           "message": "nothing uses `b`"
         }
       ]
     }
   }
-> textDocument/didSave {"doc": "bad.tex"}
# What was shown is taken away.
-> textDocument/didClose {"doc": "bad.tex"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"bad.tex","diagnostics":[]}}

# Opened again while it is open: the new text counts.
open good.tex
| \begin{equation}
|   f = )
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "good.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:7-2:8",
           "severity": 1,
           "code": "E2004",
           "codeDescription": {"href":"docs#E2004"},
           "source": "texbrdf",
           "message": "`)` closes nothing"
         }
       ]
     }
   }
=> exit status 1
