# URIs are keys as the client writes them: the same file by another spelling is another document. Any language is taken.
client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
-> textDocument/didOpen {"textDocument": {"uri": "untitled:Untitled-1", "languageId": "plaintext", "version": 0, "text": "\\begin{equation}f = a\\end{equation}"}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "untitled:Untitled-1",
       "version": 0,
       "diagnostics": [
         {
           "range": "1:21-1:22",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `a` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/didOpen {"textDocument": {"uri": "file:///c%3A/a%20b.tex", "languageId": "markdown", "version": -5, "text": "\\begin{equation}f = c\\end{equation}"}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "file:///c%3A/a%20b.tex",
       "version": -5,
       "diagnostics": [
         {
           "range": "1:21-1:22",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `c` in the definition of `f`"
         }
       ]
     }
   }
-> textDocument/hover {"textDocument": {"uri": "file:///c:/a b.tex"}, "position": {"line": 0, "character": 16}}
<- {"id":1,"error":{"code":-32602,"message":"/c:/a b.tex is not open"}}
-> textDocument/hover {"textDocument": {"uri": "file:///c%3A/a%20b.tex"}, "position": {"line": 0, "character": 16}}
<- {
     "id": 2,
     "result": {
       "contents": {"kind":"markdown","value":"`f`: `?`\n\n```latex\nf = c\n```\n\ndefined on line 1"},
       "range": "1:17-1:18"
     }
   }
-> textDocument/didClose {"textDocument": {"uri": "untitled:Untitled-1"}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"untitled:Untitled-1","diagnostics":[]}}
=> exit status 1
