client {"capabilities": {"textDocument": {"completion": {"completionItem": {"snippetSupport": true}}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open notes.md
| # A model
| 
| It costs 5% more, `$x = 1$` is code.
| 
| $$
| m = 0.3
| $$
| 
| ```
| $$f = 1$$
| ```
| 
| $$f = m \cos\theta_h + q$$
| $$\newcommand{\half}{0.5} f_0 = \half$$ is 5% of $\half$, `\half` is code.
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "notes.md",
       "version": 1,
       "diagnostics": [
         {
           "range": "13:24-13:25",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `q` in the definition of `f`"
         },
         {"range":"14:27-14:30","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `f_0`"}
       ]
     }
   }
-> textDocument/hover {"doc": "notes.md", "at": "13:7"}
<- {
     "id": 1,
     "result": {
       "contents": {"kind":"markdown","value":"`m`: `ℝ`\n\n```latex\nm = 0.3\n```\n\nvalue 0.3 · defined on line 6"},
       "range": "13:7-13:8"
     }
   }
# In prose and in code nothing is known.
-> textDocument/hover {"doc": "notes.md", "at": "10:3"}
<- {"id":2,"result":null}
-> textDocument/definition {"doc": "notes.md", "at": "13:7"}
<- {"id":3,"result":{"uri":"notes.md","range":"6:1-6:2"}}
change notes.md 13:24-13:25 "\\the"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "notes.md",
       "version": 2,
       "diagnostics": [
         {
           "range": "13:24-13:28",
           "severity": 1,
           "code": "E3003",
           "source": "texbrdf",
           "message": "unknown command `\\the`"
         },
         {"range":"14:27-14:30","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `f_0`"}
       ]
     }
   }
-> textDocument/completion {"doc": "notes.md", "at": "13:28"}
<- {
     "id": 4,
     "result": {
       "isIncomplete": false,
       "items": [
         {
           "label": "\\theta_i",
           "kind": 12,
           "detail": "ℝ",
           "sortText": "03",
           "textEdit": {"range":"13:24-13:28","newText":"\\theta_i"},
           "data": {"uri":"notes.md","kind":"convention"}
         },
         {
           "label": "\\theta_o",
           "kind": 12,
           "detail": "ℝ",
           "sortText": "03",
           "textEdit": {"range":"13:24-13:28","newText":"\\theta_o"},
           "data": {"uri":"notes.md","kind":"convention"}
         },
         {
           "label": "\\theta_h",
           "kind": 12,
           "detail": "ℝ",
           "sortText": "03",
           "textEdit": {"range":"13:24-13:28","newText":"\\theta_h"},
           "data": {"uri":"notes.md","kind":"convention"}
         },
         {
           "label": "\\theta_d",
           "kind": 12,
           "detail": "ℝ",
           "sortText": "03",
           "textEdit": {"range":"13:24-13:28","newText":"\\theta_d"},
           "data": {"uri":"notes.md","kind":"convention"}
         }
       ]
     }
   }
-> textDocument/completion {"doc": "notes.md", "at": "3:5"}
<- {"id":5,"result":null}
change notes.md 13:24-13:28 "m"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "notes.md",
       "version": 3,
       "diagnostics": [{"range":"14:27-14:30","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `f_0`"}]
     }
   }
-> textDocument/rename {"doc": "notes.md", "at": "6:1", "newName": "rough"}
<- {
     "id": 6,
     "result": {
       "changes": {
         "file:///work/notes.md": [
           {"range":"6:1-6:2","newText":"rough"},
           {"range":"13:7-13:8","newText":"rough"},
           {"range":"13:24-13:25","newText":"rough"}
         ]
       }
     }
   }
-> textDocument/references {"doc": "notes.md", "at": "14:17", "context": {"includeDeclaration": true}}
<- {
     "id": 7,
     "result": [
       {"uri":"notes.md","range":"14:15-14:20"},
       {"uri":"notes.md","range":"14:33-14:38"},
       {"uri":"notes.md","range":"14:51-14:56"}
     ]
   }
=> exit status 1
