# An object in the place of the sphere, and its light: what cannot be is told, and values at a point are those of the sphere alone.
client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = 0.3 * 1
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "object": {"shape": "teapot", "yaw": "left"}}
<- {"id":1,"error":{"code":-32602,"message":"`yaw` has to be a number"}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "object": {"shape": "teapot", "samples": 0}}
<- {"id":2,"error":{"code":-32602,"message":"`samples` is 1 to 65536"}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "object": {"light": "sky", "turbidity": 1}}
<- {"id":3,"error":{"code":-32602,"message":"turbidity is 2 to 10, not 1"}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "object": 3}
<- {"id":4,"error":{"code":-32602,"message":"`object` has to be an object"}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "object": {"shape": "teapot", "light": "sky", "yaw": -30, "pitch": 20, "samples": 16, "sun": {"elevation": 20, "azimuth": 90}, "turbidity": 4}}
<- {"id":5,"result":{"preview":1,"root":"f"}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":6,"result":null}
-> texbrdf/badPixels {"preview": 1}
<- {"id":7,"result":null}
-> texbrdf/updatePreview {"preview": 1, "object": {"shape": "sphere", "light": "directional"}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":8,"result":{"light":{"theta":33.8941,"phi":145.826},"view":{"theta":0,"phi":0},"value":[0.3]}}
=> exit status 1
