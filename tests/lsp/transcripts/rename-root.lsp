# The name of the root in an instruction is a place of the name, in whatever file it stands.
file paper.tex
| % texbrdf: root = s_{ 1}
| \input{part}
| \begin{equation} f = s_1 \end{equation}
file part.tex
| \begin{equation} s_{1} = \theta_h \end{equation}
client {"capabilities": {}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open part.tex
| \begin{equation} s_{1} = \theta_h \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"part.tex","version":1,"diagnostics":[]}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "paper.tex",
       "diagnostics": [{"range":"3:18-3:19","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `f`"}]
     }
   }
-> textDocument/rename {"doc": "part.tex", "at": "1:18", "newName": "\\rho_d"}
<- {
     "id": 1,
     "result": {
       "changes": {
         "file:///work/paper.tex": [{"range":"1:19-1:25","newText":"\\rho_d"},{"range":"3:22-3:25","newText":"\\rho_d"}],
         "file:///work/part.tex": [{"range":"1:18-1:23","newText":"\\rho_d"}]
       }
     }
   }
open paper.tex
| % texbrdf: root = s_{ 1}
| \input{part}
| \begin{equation} f = s_1 \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "paper.tex",
       "version": 1,
       "diagnostics": [{"range":"3:18-3:19","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `f`"}]
     }
   }
-> textDocument/prepareRename {"doc": "paper.tex", "at": "1:19"}
<- {"id":2,"result":{"range":"1:19-1:25","placeholder":"s_{ 1}"}}
-> textDocument/rename {"doc": "paper.tex", "at": "1:19", "newName": "f_r"}
<- {
     "id": 3,
     "result": {
       "changes": {
         "file:///work/paper.tex": [{"range":"1:19-1:25","newText":"f_r"},{"range":"3:22-3:25","newText":"f_r"}],
         "file:///work/part.tex": [{"range":"1:18-1:23","newText":"f_r"}]
       }
     }
   }
-> textDocument/rename {"doc": "paper.tex", "at": "1:19", "newName": "f"}
<- {"id":4,"error":{"code":-32803,"message":"`f` is defined already, on line 3"}}
change paper.tex 1:19-1:25 "f"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"paper.tex","version":2,"diagnostics":[]}}
-> textDocument/rename {"doc": "paper.tex", "at": "3:18", "newName": "g"}
<- {
     "id": 5,
     "result": {
       "changes": {"file:///work/paper.tex":[{"range":"1:19-1:20","newText":"g"},{"range":"3:18-3:19","newText":"g"}]}
     }
   }
=> exit status 1
