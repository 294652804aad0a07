# The root is found from a file that it includes: by its comment, or because it includes it.
file book/main.tex
| \subfile{chapters/one}
| \subimport{chapters/}{two}
| \begin{equation} f = a + b \end{equation}
file book/chapters/one.tex
| \begin{equation} a = c \end{equation}
file book/chapters/two.tex
| \begin{equation} b = \theta_h \end{equation}
file other.tex
| \begin{equation} f = q \end{equation}
client {"capabilities": {}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open book/chapters/two.tex
| \begin{equation} b = \theta_h \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"book/chapters/two.tex","version":1,"diagnostics":[]}
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "book/chapters/one.tex",
       "diagnostics": [
         {
           "range": "1:22-1:23",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `c` in the definition of `a`"
         }
       ]
     }
   }
-> textDocument/references {"doc": "book/chapters/two.tex", "at": "1:18", "context": {"includeDeclaration": true}}
<- {
     "id": 1,
     "result": [{"uri":"book/main.tex","range":"3:26-3:27"},{"uri":"book/chapters/two.tex","range":"1:18-1:19"}]
   }
open book/chapters/one.tex
| % !TeX root = ../main.tex
| \begin{equation} a = c \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "book/chapters/one.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:22-2:23",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `c` in the definition of `a`"
         }
       ]
     }
   }
-> textDocument/references {"doc": "book/chapters/one.tex", "at": "2:18", "context": {"includeDeclaration": true}}
<- {
     "id": 2,
     "result": [{"uri":"book/main.tex","range":"3:22-3:23"},{"uri":"book/chapters/one.tex","range":"2:18-2:19"}]
   }
# A file of its own.
open other.tex
| \begin{equation} f = q \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "other.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "1:22-1:23",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `q` in the definition of `f`"
         }
       ]
     }
   }
change book/chapters/one.tex 2:22-2:23 "2"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"book/chapters/one.tex","version":2,"diagnostics":[]}
   }
=> exit status 1
