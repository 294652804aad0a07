client {"capabilities": {"textDocument": {"hover": {"contentFormat": ["plaintext", "markdown"]}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = a * \pi
| \end{equation}
| \begin{equation}
|   a = 1 / 3
| \end{equation}
| \begin{equation}
|   a = 2
| \end{equation}
| \begin{equation}
|   \theta_i = nowhere
| \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "8:3-8:4",
           "severity": 1,
           "code": "E3006",
           "source": "texbrdf",
           "message": "`a` is defined more than once; another definition is in force"
         },
         {
           "range": "11:3-11:11",
           "severity": 4,
           "code": "E3008",
           "source": "texbrdf",
           "message": "`\\theta_i` takes the place of the convention: polar angle of the incident direction"
         },
         {
           "range": "11:3-11:11",
           "severity": 4,
           "code": "E3013",
           "source": "texbrdf",
           "message": "nothing uses `\\theta_i`"
         },
         {
           "range": "11:14-11:21",
           "severity": 4,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `nowhere` in the definition of `\\theta_i`"
         }
       ]
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:7"}
<- {
     "id": 1,
     "result": {
       "contents": {"kind":"plaintext","value":"a: ℝ\n\na = 1 / 3\n\nvalue 0.3333333 · defined on line 5"},
       "range": "2:7-2:8"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "2:11"}
<- {
     "id": 2,
     "result": {
       "contents": {
         "kind": "plaintext",
         "value": "\\pi: ℝ = 3.141592653589793\n\nthe circle number\n\na convention of the language"
       },
       "range": "2:11-2:14"
     }
   }
# A definition that is not in force, one that hides a convention, and a name that nothing defines.
-> textDocument/hover {"doc": "a.tex", "at": "8:3"}
<- {
     "id": 3,
     "result": {
       "contents": {
         "kind": "plaintext",
         "value": "a: ℝ\n\na = 2\n\ndefined on line 8\n\nthe definition on line 5 is in force"
       },
       "range": "8:3-8:4"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "11:3"}
<- {
     "id": 4,
     "result": {
       "contents": {
         "kind": "plaintext",
         "value": "\\theta_i: ?\n\n\\theta_i = nowhere\n\ndefined on line 11\n\nhides the convention of the same name"
       },
       "range": "11:3-11:11"
     }
   }
-> textDocument/hover {"doc": "a.tex", "at": "11:16"}
<- {"id":5,"result":null}
=> exit status 1
