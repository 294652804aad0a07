client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
-> shutdown
<- {"id":1,"result":null}
=> exit status 0
