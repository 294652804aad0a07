client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
# NUL, a lone surrogate, control characters, an unfinished block; each gets an answer.
-> textDocument/didOpen {"textDocument": {"uri": "file:///work/a.tex", "languageId": "latex", "version": 1, "text": "\\begin{equation}\u0000 f = \u0001 \u202e"}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
frame "{\"jsonrpc\":\"2.0\",\"method\":\"textDocument/didOpen\",\"params\":{\"textDocument\":{\"uri\":\"file:///work/b.tex\",\"languageId\":\"latex\",\"version\":1,\"text\":\"\\\\begin{equation}f = \\ud83d + c\\\\end{equation}\"}}}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "b.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "1:21-1:22",
           "severity": 1,
           "code": "E1001",
           "source": "texbrdf",
           "message": "unexpected character `�`"
         },
         {
           "range": "1:25-1:26",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `c` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/documentSymbol {"doc": "a.tex"}
<- {"id":1,"result":[]}
=> exit status 1
