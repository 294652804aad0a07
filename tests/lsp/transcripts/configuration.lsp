# A client that sends its settings. What it gives to `initialize` holds until it sets something else.
client {"capabilities": {"workspace": {"inlayHint": {"refreshSupport": true}, "codeLens": {"refreshSupport": true}}}, "initializationOptions": {"texbrdf": {"features": {"definition": false}}}}
<- {"id":0,"positionEncoding":"utf-16"}
-> initialized {}
open a.tex
| \begin{equation}
|   f = \pi * \theta_i
| \end{equation}
| \begin{equation}
|   \theta_i = 2
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "5:3-5:11",
           "severity": 4,
           "code": "E3008",
           "source": "texbrdf",
           "message": "`\\theta_i` takes the place of the convention: polar angle of the incident direction"
         }
       ]
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 1,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`f`: `ℝ`\n\n```latex\nf = \\pi * \\theta_i\n```\n\nvalue 6.283185 · defined on line 2"
       },
       "range": "2:3-2:4"
     }
   }
-> textDocument/definition {"doc": "a.tex", "at": "2:14"}
<- {"id":2,"result":null}

# Switched off: an answer without content, at once.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"hover": false}}}}
+> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {"id":3,"result":null}
# Hints as warnings, or not at all.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"diagnostics": {"hints": "warning"}}}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "5:3-5:11",
           "severity": 2,
           "code": "E3008",
           "source": "texbrdf",
           "message": "`\\theta_i` takes the place of the convention: polar angle of the incident direction"
         }
       ]
     }
   }
-> workspace/didChangeConfiguration {"settings": {"diagnostics.hints": "off"}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
# No diagnostics at all: what was shown is taken away. And back.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"diagnostics": false}}}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","diagnostics":[]}}
-> workspace/didChangeConfiguration {"settings": {"texbrdf": null}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "5:3-5:11",
           "severity": 4,
           "code": "E3008",
           "source": "texbrdf",
           "message": "`\\theta_i` takes the place of the convention: polar angle of the incident direction"
         }
       ]
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 4,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`f`: `ℝ`\n\n```latex\nf = \\pi * \\theta_i\n```\n\nvalue 6.283185 · defined on line 2"
       },
       "range": "2:3-2:4"
     }
   }
# Clients that keep hints and lenses are told to ask again.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"inlayHint": {"definitionTypes": false}, "codeLens": {"uses": false}}}}
<- {"id":1,"method":"workspace/inlayHint/refresh"}
<- {"id":2,"method":"workspace/codeLens/refresh"}
# What is not understood changes nothing.
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"hovver": false, "hover": 3}, "inlayHint": {"definitionTypes": false}, "codeLens": {"uses": false}}}}
-> workspace/didChangeConfiguration {"settings": 3}
-> workspace/didChangeConfiguration {}
<- {"id":3,"method":"workspace/inlayHint/refresh"}
<- {"id":4,"method":"workspace/codeLens/refresh"}
-> textDocument/hover {"doc": "a.tex", "at": "2:3"}
<- {
     "id": 5,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`f`: `ℝ`\n\n```latex\nf = \\pi * \\theta_i\n```\n\nvalue 6.283185 · defined on line 2"
       },
       "range": "2:3-2:4"
     }
   }
=> exit status 1
