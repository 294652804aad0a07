# A client from before there were several folders.
client {"capabilities": {}, "rootUri": "file:///work/one", "rootPath": "/work/two"}
<- {"id":0,"positionEncoding":"utf-16"}
-> texbrdf/stats
<- {
     "id": 1,
     "result": {
       "requests": 2,
       "notifications": 0,
       "cancelled": 0,
       "errors": 0,
       "published": 0,
       "workspaceFolders": ["one"],
       "documents": []
     }
   }
=> exit status 1
