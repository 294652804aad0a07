# What cannot be included is told where it is.
file main.tex
| \input{missing}
file loop.tex
| \input{main}
file ../outside.tex
| \begin{equation} z = 1 \end{equation}
link inside.tex ../outside.tex
client {"capabilities": {"workspace": {"didChangeWatchedFiles": {"dynamicRegistration": true}}}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
-> initialized {}
<- {
     "id": 1,
     "method": "client/registerCapability",
     "params": {
       "registrations": [
         {
           "id": "workspace/didChangeWatchedFiles",
           "method": "workspace/didChangeWatchedFiles",
           "registerOptions": {
             "watchers": [{"globPattern":"**/*.tex"},{"globPattern":"**/*.{scene,model,material,shader,primitive}.json"}]
           }
         }
       ]
     }
   }
open main.tex
| \input{missing}
| \include{loop}
| \input{../outside}
| \input{inside}
| % \input{comment}
| \begin{verbatim}\input{verbatim}\end{verbatim}
| \newcommand{\part}[1]{\input{#1}}
| \begin{equation} f = \theta_h * g \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "main.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "8:33-8:34",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `g` in the definition of `f`"
         },
         {
           "range": "1:1-1:16",
           "severity": 2,
           "code": "E0002",
           "source": "texbrdf",
           "message": "`missing` cannot be read"
         },
         {
           "range": "2:1-2:15",
           "severity": 1,
           "code": "E0003",
           "source": "texbrdf",
           "message": "`loop` includes itself"
         },
         {
           "range": "3:1-3:19",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`../outside` is not in a folder of the workspace"
         },
         {
           "range": "4:1-4:15",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`inside` is not in a folder of the workspace"
         }
       ]
     }
   }
# The missing file comes, is changed, and goes.
file missing.tex
| \begin{equation} g = 2 \end{equation}
-> workspace/didChangeWatchedFiles {"changes": [{"uri": "file:///work/missing.tex", "type": 1}]}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "main.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:1-2:15",
           "severity": 1,
           "code": "E0003",
           "source": "texbrdf",
           "message": "`loop` includes itself"
         },
         {
           "range": "3:1-3:19",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`../outside` is not in a folder of the workspace"
         },
         {
           "range": "4:1-4:15",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`inside` is not in a folder of the workspace"
         }
       ]
     }
   }
file missing.tex
| \begin{equation} g = 2 + \end{equation}
-> workspace/didChangeWatchedFiles {"changes": [{"uri": "file:///work/missing.tex", "type": 2}]}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "main.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "2:1-2:15",
           "severity": 1,
           "code": "E0003",
           "source": "texbrdf",
           "message": "`loop` includes itself"
         },
         {
           "range": "3:1-3:19",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`../outside` is not in a folder of the workspace"
         },
         {
           "range": "4:1-4:15",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`inside` is not in a folder of the workspace"
         }
       ]
     }
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "missing.tex",
       "diagnostics": [
         {
           "range": "1:26-1:30",
           "severity": 1,
           "code": "E2001",
           "source": "texbrdf",
           "message": "expected an expression, found the end of the equation"
         }
       ]
     }
   }
remove missing.tex
-> workspace/didChangeWatchedFiles {"changes": [{"uri": "file:///work/missing.tex", "type": 3}]}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"missing.tex","diagnostics":[]}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "main.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "8:33-8:34",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `g` in the definition of `f`"
         },
         {
           "range": "1:1-1:16",
           "severity": 2,
           "code": "E0002",
           "source": "texbrdf",
           "message": "`missing` cannot be read"
         },
         {
           "range": "2:1-2:15",
           "severity": 1,
           "code": "E0003",
           "source": "texbrdf",
           "message": "`loop` includes itself"
         },
         {
           "range": "3:1-3:19",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`../outside` is not in a folder of the workspace"
         },
         {
           "range": "4:1-4:15",
           "severity": 2,
           "code": "E0004",
           "source": "texbrdf",
           "message": "`inside` is not in a folder of the workspace"
         }
       ]
     }
   }
=> exit status 1
