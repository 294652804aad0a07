# The number of a parameter may stand in another file: its place and the edit that writes it name that file.
file parts/terms.tex
| \begin{equation}
|   m = 0.25 % range [0, 1]
| \end{equation}
client {"capabilities": {"workspace": {"workspaceEdit": {"documentChanges": true}}}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open paper.tex
| \input{parts/terms}
| \begin{equation}
|   k = 2 % range [0, 4]
| \end{equation}
| \begin{equation}
|   f = k * m
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"paper.tex","version":1,"diagnostics":[]}}
-> texbrdf/parameters {"uri": "file:///work/paper.tex"}
<- {
     "id": 1,
     "result": [
       {
         "name": "k",
         "label": "k",
         "type": "real",
         "value": [2],
         "low": 0,
         "high": 4,
         "location": {"uri":"paper.tex","range":"3:7-3:8"}
       },
       {
         "name": "m",
         "label": "m",
         "type": "real",
         "value": [0.25],
         "low": 0,
         "high": 1,
         "location": {"uri":"parts/terms.tex","range":"2:7-2:11"}
       }
     ]
   }
-> texbrdf/parameterEdit {"uri": "file:///work/paper.tex", "name": "m", "value": [0.5]}
<- {
     "id": 2,
     "result": {
       "documentChanges": [
         {
           "textDocument": {"uri":"parts/terms.tex","version":null},
           "edits": [{"range":"2:7-2:11","newText":"0.5"}]
         }
       ]
     }
   }
# What the editor has of that file counts, and is named with its version.
open parts/terms.tex
| % edited
| \begin{equation}
|   m = 0.75 % range [0, 1]
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"parts/terms.tex","version":1,"diagnostics":[]}
   }
-> texbrdf/parameters {"uri": "file:///work/paper.tex"}
<- {
     "id": 3,
     "result": [
       {
         "name": "k",
         "label": "k",
         "type": "real",
         "value": [2],
         "low": 0,
         "high": 4,
         "location": {"uri":"paper.tex","range":"3:7-3:8"}
       },
       {
         "name": "m",
         "label": "m",
         "type": "real",
         "value": [0.75],
         "low": 0,
         "high": 1,
         "location": {"uri":"parts/terms.tex","range":"3:7-3:11"}
       }
     ]
   }
-> texbrdf/parameterEdit {"uri": "file:///work/paper.tex", "name": "m", "value": [0.5]}
<- {
     "id": 4,
     "result": {
       "documentChanges": [{"textDocument":{"uri":"parts/terms.tex","version":1},"edits":[{"range":"3:7-3:11","newText":"0.5"}]}]
     }
   }
# Seen from that file, the other number is the one elsewhere.
-> texbrdf/parameters {"uri": "file:///work/parts/terms.tex"}
<- {
     "id": 5,
     "result": [
       {
         "name": "k",
         "label": "k",
         "type": "real",
         "value": [2],
         "low": 0,
         "high": 4,
         "location": {"uri":"paper.tex","range":"3:7-3:8"}
       },
       {
         "name": "m",
         "label": "m",
         "type": "real",
         "value": [0.75],
         "low": 0,
         "high": 1,
         "location": {"uri":"parts/terms.tex","range":"3:7-3:11"}
       }
     ]
   }
=> exit status 1
