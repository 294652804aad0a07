-> initialize {"capabilities": {"textDocument": {"codeAction": {"codeActionLiteralSupport": {"codeActionKind": {"valueSet": ["quickfix"]}}, "isPreferredSupport": true}}}}
<- {
     "id": 0,
     "result": {
       "capabilities": {
         "positionEncoding": "utf-16",
         "textDocumentSync": {"openClose":true,"change":2,"save":true},
         "hoverProvider": true,
         "definitionProvider": true,
         "referencesProvider": {"workDoneProgress":true},
         "documentSymbolProvider": true,
         "renameProvider": {"workDoneProgress":true},
         "documentHighlightProvider": true,
         "foldingRangeProvider": true,
         "semanticTokensProvider": {
           "legend": {
             "tokenTypes": ["function","variable","parameter","number","operator","keyword","macro"],
             "tokenModifiers": ["declaration","definition","defaultLibrary"]
           },
           "range": true,
           "full": {"delta":true}
         },
         "inlayHintProvider": true,
         "codeLensProvider": {"resolveProvider":true},
         "completionProvider": {"triggerCharacters":["\\","{","_"],"resolveProvider":true},
         "signatureHelpProvider": {"triggerCharacters":["(",","]},
         "codeActionProvider": {"codeActionKinds":["quickfix"]},
         "workspace": {"workspaceFolders":{"supported":true,"changeNotifications":true}},
         "experimental": {"texbrdf":{"preview":true}}
       },
       "serverInfo": {"name":"texbrdf","version":"0.0"}
     }
   }
open a.tex
| \begin{equation}
|   \rho_d = 0.5
| \end{equation}
| \begin{equation}
|   f = rho_d * exp(1) + 2 3.0
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {"range":"2:3-2:9","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `\\rho_d`"},
         {
           "range": "5:7-5:12",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `rho_d` in the definition of `f`; did you mean `\\rho_d`?"
         },
         {
           "range": "5:15-5:18",
           "severity": 2,
           "code": "E2022",
           "source": "texbrdf",
           "message": "`exp` is read as `\\exp`"
         },
         {"range":"5:26-5:29","severity":1,"code":"E3012","source":"texbrdf","message":"missing operator"}
       ]
     }
   }

# The nearest name, or a new equation.
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 4, "character": 6}, "end": {"line": 4, "character": 6}}, "context": {"diagnostics": []}}
<- {
     "id": 1,
     "result": [
       {
         "title": "replace by `\\rho_d`",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "5:7-5:12",
             "severity": 1,
             "code": "E3001",
             "source": "texbrdf",
             "message": "undefined name `rho_d` in the definition of `f`; did you mean `\\rho_d`?"
           }
         ],
         "isPreferred": true,
         "edit": {"changes":{"file:///work/a.tex":[{"range":"5:7-5:12","newText":"\\rho_d"}]}}
       },
       {
         "title": "define `rho_d` in a new equation",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "5:7-5:12",
             "severity": 1,
             "code": "E3001",
             "source": "texbrdf",
             "message": "undefined name `rho_d` in the definition of `f`; did you mean `\\rho_d`?"
           }
         ],
         "edit": {
           "changes": {
             "file:///work/a.tex": [{"range":"4:1-4:1","newText":"\\begin{equation}\n  rho_d = 1\n\\end{equation}\n"}]
           }
         }
       }
     ]
   }
# A whole line; the kinds that are asked for hold the one that there is.
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 4, "character": 14}, "end": {"line": 4, "character": 40}}, "context": {"diagnostics": [], "only": ["quickfix"]}}
<- {
     "id": 2,
     "result": [
       {
         "title": "write `\\exp`",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "5:15-5:18",
             "severity": 2,
             "code": "E2022",
             "source": "texbrdf",
             "message": "`exp` is read as `\\exp`"
           }
         ],
         "isPreferred": true,
         "edit": {"changes":{"file:///work/a.tex":[{"range":"5:15-5:15","newText":"\\"}]}}
       },
       {
         "title": "insert `\\cdot`",
         "kind": "quickfix",
         "diagnostics": [{"range":"5:26-5:29","severity":1,"code":"E3012","source":"texbrdf","message":"missing operator"}],
         "isPreferred": true,
         "edit": {"changes":{"file:///work/a.tex":[{"range":"5:26-5:26","newText":"\\cdot "}]}}
       }
     ]
   }
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 4, "character": 14}, "end": {"line": 4, "character": 18}}, "context": {"diagnostics": [], "only": [""]}}
<- {
     "id": 3,
     "result": [
       {
         "title": "write `\\exp`",
         "kind": "quickfix",
         "diagnostics": [
           {
             "range": "5:15-5:18",
             "severity": 2,
             "code": "E2022",
             "source": "texbrdf",
             "message": "`exp` is read as `\\exp`"
           }
         ],
         "isPreferred": true,
         "edit": {"changes":{"file:///work/a.tex":[{"range":"5:15-5:15","newText":"\\"}]}}
       }
     ]
   }
# Other kinds, and a range without problems.
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 4, "character": 0}, "end": {"line": 4, "character": 40}}, "context": {"diagnostics": [], "only": ["refactor", "source.organizeImports", "quick"]}}
<- {"id":4,"result":[]}
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 40}}, "context": {"diagnostics": []}}
<- {"id":5,"result":[]}
-> textDocument/codeAction {"doc": "a.tex", "range": {"start": {"line": 0, "character": 0}, "end": {"line": 1, "character": 40}}}
<- {"id":6,"error":{"code":-32602,"message":"`context` has to be an object"}}
=> exit status 1
