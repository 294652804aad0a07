# What a pane of a scene asks and is told beside its pictures.
client {"rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
-> texbrdf/openScene {"uri": "file:///work/ball.scene.json"}
<- {"id":1,"error":{"code":-32602,"message":"/work/ball.scene.json is not open"}}
open ball.scene.json
| {"scene": [{"name": "ball", "type": "Primitives/Sphere", "dynamic": {"keys": {"J": {"velocity": {"x": 1, "y": 0, "z": 0}}, "L": {"velocity": {"x": -1, "y": 0, "z": 0}}}}}]}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"ball.scene.json","version":1,"diagnostics":[]}
   }
-> texbrdf/openScene {"uri": "file:///work/ball.scene.json", "view": "upside down"}
<- {"id":2,"error":{"code":-32602,"message":"there is no view `upside down`"}}
-> texbrdf/openScene {"uri": "file:///work/ball.scene.json", "width": "wide"}
<- {"id":3,"error":{"code":-32602,"message":"`width` has to be a natural number"}}
-> texbrdf/openScene {"uri": "file:///work/ball.scene.json", "width": 64, "height": 64, "view": "normals", "gamma": 2}
<- {
     "id": 4,
     "result": {
       "preview": 1,
       "views": [
         {"name":"shaded","meaning":"the scene in its lights"},
         {"name":"normals","meaning":"0.5 + 0.5 N"},
         {
           "name": "depth",
           "meaning": "how far the surface is: white near, grey at the camera's target, black where nothing is"
         },
         {"name":"steps","meaning":"how many steps the ray took: white is max_steps"},
         {
           "name": "lipschitz",
           "meaning": "where the distance function is steeper than 1: orange, red at 2, white from 4 on"
         }
       ]
     }
   }
<- {
     "method": "texbrdf/previewState",
     "params": {
       "preview": 1,
       "uri": "ball.scene.json",
       "version": 1,
       "state": "good",
       "message": "",
       "keys": [{"object":"ball","keys":["J","L"]}]
     }
   }
-> texbrdf/sceneInput {"preview": 1, "held": ["J"], "seconds": 0.1, "pressed": ["2"], "drag": {"right": 0.1, "down": 0}, "wheel": 1}
-> texbrdf/updateScene {"preview": 1, "view": "depth", "width": 100000}
-> texbrdf/updateScene {"preview": 2, "view": "depth"}
-> texbrdf/sceneInput {"preview": 2}
# A broken file is told of, and then that it is none any more.
change ball.scene.json "{\"scene\": [{\"type\": \"Primitives/Sphare\"}]}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 2,
       "diagnostics": [
         {
           "range": "1:21-1:40",
           "severity": 1,
           "source": "texbrdf",
           "message": "there is no object `Primitives/Sphare` (did you mean `Primitives/Sphere`?)"
         }
       ]
     }
   }
<- {
     "method": "texbrdf/previewState",
     "params": {
       "preview": 1,
       "uri": "ball.scene.json",
       "version": 2,
       "state": "errors",
       "message": "line 1: there is no object `Primitives/Sphare` (did you mean `Primitives/Sphere`?)",
       "keys": [{"object":"ball","keys":["J","L"]}]
     }
   }
change ball.scene.json "{\"scene\": [{\"type\": \"Primitives/Sphere\"}]}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"ball.scene.json","version":3,"diagnostics":[]}
   }
<- {
     "method": "texbrdf/previewState",
     "params": {"preview":1,"uri":"ball.scene.json","version":3,"state":"good","message":"","keys":[]}
   }
-> texbrdf/frameShown {"preview": 1}
-> texbrdf/closePreview {"preview": 1}
-> texbrdf/sceneInput {"preview": 1}
=> exit status 1
