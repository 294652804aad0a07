client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
change a.tex "\\begin{equation}\r\n  f = 1 + zz\r\n\\end{equation}\r\n"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 2,
       "diagnostics": [
         {
           "range": "2:11-2:13",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `f`"
         }
       ]
     }
   }

# Within a line that ends in CRLF; a column behind the line's end is its end, before the CR.
change a.tex 2:11-2:13 "a"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {
           "range": "2:11-2:12",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `a` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:11-2:900 "2"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":4,"diagnostics":[]}}
# A new line is put in, also with a lone CR; then taken out with its CRLF.
change a.tex 2:7-2:7 "\r3 +\r\n  "
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":5,"diagnostics":[]}}
change a.tex 2:1-3:1 "  f =\r\n  oops "
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 6,
       "diagnostics": [
         {
           "range": "3:3-3:7",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `oops` in the definition of `f`"
         }
       ]
     }
   }
change a.tex 2:6-4:3 " "
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":7,"diagnostics":[]}}
# Lines behind the end are the end; a reversed range is turned round.
change a.tex 900:5-901:9 "\\begin{equation} g = zz \\end{equation}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 8,
       "diagnostics": [
         {"range":"4:18-4:19","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `g`"},
         {
           "range": "4:22-4:24",
           "severity": 4,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `zz` in the definition of `g`"
         }
       ]
     }
   }
change a.tex 4:24-4:22 "2"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 9,
       "diagnostics": [{"range":"4:18-4:19","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `g`"}]
     }
   }
# The whole text anew.
change a.tex "\\begin{equation}f = q\\end{equation}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 10,
       "diagnostics": [
         {
           "range": "1:21-1:22",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `q` in the definition of `f`"
         }
       ]
     }
   }
change a.tex ""
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":11,"diagnostics":[]}}
# Several changes in one message come one after the other.
-> textDocument/didChange {"textDocument": {"uri": "file:///work/a.tex", "version": 20}, "contentChanges": [{"text": "\\begin{equation}f = a\\end{equation}"}, {"range": {"start": {"line": 0, "character": 20}, "end": {"line": 0, "character": 21}}, "text": "bcd"}, {"range": {"start": {"line": 0, "character": 21}, "end": {"line": 0, "character": 22}}, "text": ""}]}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 20,
       "diagnostics": [
         {
           "range": "1:21-1:23",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `bd` in the definition of `f`"
         }
       ]
     }
   }
# A message that is not understood changes nothing.
-> textDocument/didChange {"textDocument": {"uri": "file:///work/a.tex", "version": 21}, "contentChanges": [{"text": "lost"}, {"text": 5}]}
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {"id":1,"result":[{"name":"f","kind":13,"location":{"uri":"a.tex","range":"1:17-1:23"}}]}
=> exit status 1
