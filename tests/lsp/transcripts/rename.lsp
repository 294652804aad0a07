client {"capabilities": {"textDocument": {"rename": {"prepareSupport": true}}}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = \cos\omega_1 * \omega_{1} + g(2)
| \end{equation}
| \begin{equation}
|   \omega_{ 1 } = 2
| \end{equation}
| \begin{equation}
|   g(x) = x * \theta_i + \omega_1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}

# The name as it is written at the place, or why it has to stay.
-> textDocument/prepareRename {"doc": "a.tex", "at": "2:22"}
<- {"id":1,"result":{"range":"2:22-2:32","placeholder":"\\omega_{1}"}}
-> textDocument/prepareRename {"doc": "a.tex", "at": "5:3"}
<- {"id":2,"result":{"range":"5:3-5:15","placeholder":"\\omega_{ 1 }"}}
-> textDocument/prepareRename {"doc": "a.tex", "at": "8:5"}
<- {"id":3,"result":{"range":"8:5-8:6","placeholder":"x"}}
-> textDocument/prepareRename {"doc": "a.tex", "at": "2:5"}
<- {"id":4,"result":null}
-> textDocument/prepareRename {"doc": "a.tex", "at": "8:15"}
<- {"id":5,"error":{"code":-32803,"message":"`\\theta_i` is a convention of the language and keeps its name"}}

# All spellings; a letter does not join the command before it.
-> textDocument/rename {"doc": "a.tex", "at": "2:22", "newName": "s"}
<- {
     "id": 6,
     "result": {
       "changes": {
         "file:///work/a.tex": [
           {"range":"2:11-2:19","newText":" s"},
           {"range":"2:22-2:32","newText":"s"},
           {"range":"5:3-5:15","newText":"s"},
           {"range":"8:25-8:33","newText":"s"}
         ]
       }
     }
   }
# A parameter only in its function.
-> textDocument/rename {"doc": "a.tex", "at": "8:10", "newName": "y_{12}"}
<- {
     "id": 7,
     "result": {
       "changes": {
         "file:///work/a.tex": [{"range":"8:5-8:6","newText":"y_{12}"},{"range":"8:10-8:11","newText":"y_{12}"}]
       }
     }
   }
# Conflicts, and names that are none.
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "g"}
<- {"id":8,"error":{"code":-32803,"message":"`g` is defined already, on line 8"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "x"}
<- {"id":9,"error":{"code":-32803,"message":"on line 8 the parameter `x` of `g` would hide it"}}
-> textDocument/rename {"doc": "a.tex", "at": "8:10", "newName": "\\omega_1"}
<- {"id":10,"error":{"code":-32803,"message":"`\\omega_1` is used in `g`, where the parameter would hide it"}}
-> textDocument/rename {"doc": "a.tex", "at": "8:10", "newName": "\\vec{x}"}
<- {"id":11,"error":{"code":-32803,"message":"`x` is no vector, `\\vec{x}` would be one"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "a b"}
<- {"id":12,"error":{"code":-32803,"message":"`a b` is not a name"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "\\exp"}
<- {"id":13,"error":{"code":-32803,"message":"`\\exp` is a command, not a name"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "exp"}
<- {"id":14,"error":{"code":-32803,"message":"`exp` is a reserved word"}}
-> textDocument/rename {"doc": "a.tex", "at": "5:3", "newName": "\\theta_i"}
<- {"id":15,"error":{"code":-32803,"message":"`\\theta_i` is a convention of the language"}}
-> textDocument/rename {"doc": "a.tex", "at": "2:3", "newName": "y"}
<- {"id":16,"error":{"code":-32803,"message":"`f` is the BRDF because of its name, `y` would not be"}}
-> textDocument/rename {"doc": "a.tex", "at": "8:15", "newName": "y"}
<- {
     "id": 17,
     "error": {"code":-32803,"message":"`\\theta_i` is a convention of the language and keeps its name"}
   }
-> textDocument/rename {"doc": "a.tex", "at": "2:5", "newName": "y"}
<- {"id":18,"error":{"code":-32803,"message":"no name stands here"}}
-> textDocument/rename {"doc": "none.tex", "at": "2:5", "newName": "y"}
<- {"id":19,"error":{"code":-32602,"message":"/work/none.tex is not open"}}
-> textDocument/rename {"doc": "a.tex", "at": "2:5"}
<- {"id":20,"error":{"code":-32602,"message":"`newName` has to be a string"}}
=> exit status 1
