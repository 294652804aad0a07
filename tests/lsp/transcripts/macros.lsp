client {"capabilities": {"textDocument": {"definition": {"linkSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \newcommand{\sq}[1]{(#1)^2}
| \newcommand{\NoH}{\mathbf n\cdot\mathbf h + q}
| \begin{equation}
|   a = 0.5
| \end{equation}
| \begin{equation}
|   f = \sq{a} \sq a + \sq{\NoH}
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "7:26-7:30",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `q` in the definition of `f`"
         }
       ]
     }
   }
# What a macro makes is reported at its use.
-> textDocument/definition {"doc": "a.tex", "at": "7:8"}
<- {
     "id": 1,
     "result": [
       {
         "originSelectionRange": "7:7-7:10",
         "targetUri": "a.tex",
         "targetRange": "1:1-1:28",
         "targetSelectionRange": "1:13-1:16"
       }
     ]
   }
-> textDocument/definition {"doc": "a.tex", "at": "7:11"}
<- {
     "id": 2,
     "result": [
       {
         "originSelectionRange": "7:11-7:12",
         "targetUri": "a.tex",
         "targetRange": "4:3-4:10",
         "targetSelectionRange": "4:3-4:4"
       }
     ]
   }
-> textDocument/references {"doc": "a.tex", "at": "7:8", "context": {"includeDeclaration": true}}
<- {
     "id": 3,
     "result": [
       {"uri":"a.tex","range":"1:13-1:16"},
       {"uri":"a.tex","range":"7:7-7:10"},
       {"uri":"a.tex","range":"7:14-7:17"},
       {"uri":"a.tex","range":"7:22-7:25"}
     ]
   }
-> textDocument/hover {"doc": "a.tex", "at": "7:28"}
<- {
     "id": 4,
     "result": {
       "contents": {
         "kind": "markdown",
         "value": "```latex\n\\newcommand{\\NoH}{\\mathbf n\\cdot\\mathbf h + q}\n```\n\nmacro, defined on line 2"
       },
       "range": "7:26-7:30"
     }
   }
-> textDocument/documentHighlight {"doc": "a.tex", "at": "1:14"}
<- {
     "id": 5,
     "result": [
       {"range":"1:13-1:16","kind":3},
       {"range":"7:7-7:10","kind":2},
       {"range":"7:14-7:17","kind":2},
       {"range":"7:22-7:25","kind":2}
     ]
   }
-> textDocument/semanticTokens/full {"doc": "a.tex"}
<- {
     "id": 6,
     "result": {
       "resultId": "1",
       "data": [3,2,1,1,2,0,2,1,4,0,0,2,3,3,0,3,2,1,1,2,0,2,1,4,0,0,2,3,6,0,0,4,1,1,0,0,3,3,6,0,0,4,1,1,0,0,2,1,4,0,0,2,3,6,0,0,4,4,6,0]
     }
   }
# An argument without braces gets some.
-> textDocument/rename {"doc": "a.tex", "at": "4:3", "newName": "wide"}
<- {
     "id": 7,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"4:3-4:4","newText":"wide"},
           {"range":"7:11-7:12","newText":"wide"},
           {"range":"7:18-7:19","newText":"{wide}"}
         ]
       }
     }
   }
# What a macro writes cannot be renamed: it is the macro that stands there.
-> textDocument/rename {"doc": "a.tex", "at": "7:28", "newName": "wide"}
<- {
     "id": 8,
     "result": {
       "changes": {
         "file:///work/a.tex": [{"range":"2:13-2:17","newText":"\\wide"},{"range":"7:26-7:30","newText":"\\wide"}]
       }
     }
   }
=> exit status 1
