client {"capabilities": {}, "rootUri": "file:///old", "workspaceFolders": [{"uri": "file:///work/one", "name": "one"}, {"uri": "file:///work/two", "name": "two"}, {"name": "none"}, 3]}
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
       "workspaceFolders": ["one","two"],
       "documents": []
     }
   }
-> workspace/didChangeWorkspaceFolders {"event": {"added": [{"uri": "file:///work/three", "name": "three"}], "removed": [{"uri": "file:///work/one", "name": "one"}]}}
-> workspace/didChangeWorkspaceFolders {"event": {"added": [], "removed": [{"uri": "file:///work/nowhere", "name": "x"}]}}
-> workspace/didChangeWorkspaceFolders {"event": 3}
-> texbrdf/stats
<- {
     "id": 2,
     "result": {
       "requests": 3,
       "notifications": 3,
       "cancelled": 0,
       "errors": 0,
       "published": 0,
       "workspaceFolders": ["two","three"],
       "documents": []
     }
   }
=> exit status 1
