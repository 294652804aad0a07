# A definition in another file, on the disk.
file paper.tex
| \input{parts/terms}
| \begin{equation}
|   f = g(m) * \rho
| \end{equation}
file parts/terms.tex
| \begin{equation}
|   g(x) = x * \theta_h
| \end{equation}
| \begin{equation}
|   m = 0.3
| \end{equation}
client {"capabilities": {"textDocument": {"publishDiagnostics": {"relatedInformation": true}}}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open paper.tex
| \input{parts/terms}
| \begin{equation}
|   f = g(m) * \rho
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "paper.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "3:14-3:18",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\rho` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/definition {"doc": "paper.tex", "at": "3:7"}
<- {"id":1,"result":{"uri":"parts/terms.tex","range":"2:3-2:4"}}
-> textDocument/hover {"doc": "paper.tex", "at": "3:9"}
<- {
     "id": 2,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "`m`: `ℝ`\n\n```latex\nm = 0.3\n```\n\nvalue 0.3 · defined on line 5 of another file"
       },
       "range": "3:9-3:10"
     }
   }
-> textDocument/references {"doc": "paper.tex", "at": "3:9", "context": {"includeDeclaration": true}}
<- {"id":3,"result":[{"uri":"paper.tex","range":"3:9-3:10"},{"uri":"parts/terms.tex","range":"5:3-5:4"}]}
-> textDocument/documentSymbol {"doc": "paper.tex"}
<- {"id":4,"result":[{"name":"f","kind":13,"location":{"uri":"paper.tex","range":"3:3-3:18"}}]}
# The buffer of an included file wins over the disk; its edit mends the root.
open parts/terms.tex
| \begin{equation}
|   g(x) = x * \theta_h
| \end{equation}
| \begin{equation}
|   m = 0.3
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"parts/terms.tex","version":1,"diagnostics":[]}
   }
change parts/terms.tex 6:15-6:15 "\n\\begin{equation}\n  \\rho = 0.5\n\\end{equation}\n"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"parts/terms.tex","version":2,"diagnostics":[]}
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"paper.tex","version":1,"diagnostics":[]}}
-> textDocument/references {"doc": "parts/terms.tex", "at": "8:4", "context": {"includeDeclaration": true}}
<- {"id":5,"result":[{"uri":"paper.tex","range":"3:14-3:18"},{"uri":"parts/terms.tex","range":"8:3-8:7"}]}
-> textDocument/rename {"doc": "parts/terms.tex", "at": "8:4", "newName": "\\rho_d"}
<- {
     "id": 6,
     "result": {
       "changes": {
         "file:///work/paper.tex": [{"range":"3:14-3:18","newText":"\\rho_d"}],
         "file:///work/parts/terms.tex": [{"range":"8:3-8:7","newText":"\\rho_d"}]
       }
     }
   }
-> textDocument/documentSymbol {"doc": "parts/terms.tex"}
<- {
     "id": 7,
     "result": [
       {"name":"g","kind":12,"location":{"uri":"parts/terms.tex","range":"2:3-2:22"}},
       {"name":"x","kind":26,"location":{"uri":"parts/terms.tex","range":"2:5-2:6"},"containerName":"g"},
       {"name":"m","kind":13,"location":{"uri":"parts/terms.tex","range":"5:3-5:10"}},
       {"name":"\\rho","kind":13,"location":{"uri":"parts/terms.tex","range":"8:3-8:13"}}
     ]
   }
-> textDocument/foldingRange {"doc": "parts/terms.tex"}
<- {
     "id": 8,
     "result": [
       {"startLine":0,"startCharacter":16,"endLine":2,"endCharacter":0},
       {"startLine":3,"startCharacter":16,"endLine":5,"endCharacter":0},
       {"startLine":6,"startCharacter":16,"endLine":8,"endCharacter":0}
     ]
   }
-> textDocument/semanticTokens/full {"doc": "parts/terms.tex"}
<- {
     "id": 9,
     "result": {
       "resultId": "1",
       "data": [1,2,1,0,2,0,2,1,2,1,0,3,1,4,0,0,2,1,2,0,0,2,1,4,0,0,2,8,1,4,3,2,1,1,2,0,2,1,4,0,0,2,3,3,0,3,2,4,1,2,0,5,1,4,0,0,2,3,3,0]
     }
   }
# An error made there is shown there.
change parts/terms.tex 5:7-5:10 "0.3 +"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "parts/terms.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "6:1-6:5",
           "severity": 1,
           "code": "E2001",
           "source": "texbrdf",
           "message": "expected an expression, found the end of the equation"
         }
       ]
     }
   }
change parts/terms.tex 5:7-5:12 "0.3"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"parts/terms.tex","version":4,"diagnostics":[]}
   }
# Closed without being saved: the file on the disk counts again.
-> textDocument/didClose {"doc": "parts/terms.tex"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/terms.tex","diagnostics":[]}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "paper.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "3:14-3:18",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `\\rho` in the definition of `f`"
         }
       ]
     }
   }
=> exit status 1
