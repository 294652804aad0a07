# A subfile belongs to the project of the file that its class option names, wherever that is.
file book/main.tex
| \documentclass{article}
| \begin{document}
| \subfile{../parts/one}
| \begin{equation} f = a + b \end{equation}
| \begin{equation} b = 2 \end{equation}
| \end{document}
file parts/one.tex
client {"capabilities": {}, "rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open parts/one.tex
| \documentclass[../book/main.tex]{subfiles}
| \begin{document}
| \begin{equation} a = b * \theta_h \end{equation}
| \end{document}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/one.tex","version":1,"diagnostics":[]}}
-> textDocument/definition {"doc": "parts/one.tex", "at": "3:22"}
<- {"id":1,"result":{"uri":"book/main.tex","range":"5:18-5:19"}}
# Another class: a document of its own.
change parts/one.tex 1:34-1:42 "article"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/one.tex","version":2,"diagnostics":[]}}
-> textDocument/definition {"doc": "parts/one.tex", "at": "3:22"}
<- {"id":2,"result":null}
change parts/one.tex 1:34-1:41 "subfiles"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/one.tex","version":3,"diagnostics":[]}}
-> textDocument/definition {"doc": "parts/one.tex", "at": "3:22"}
<- {"id":3,"result":{"uri":"book/main.tex","range":"5:18-5:19"}}
# A main file that does not include it does not make it a part.
change parts/one.tex 1:16-1:32 "../book/other.tex"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"parts/one.tex","version":4,"diagnostics":[]}}
-> textDocument/definition {"doc": "parts/one.tex", "at": "3:22"}
<- {"id":4,"result":null}
=> exit status 1
