# A client that just goes away.
client {"capabilities": {}}
<- {"id":0,"positionEncoding":"utf-16"}
=> exit status 1
