client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
-> exit
-> textDocument/hover {"doc": "never-handled.tex", "at": "1:1"}
=> exit status 1
