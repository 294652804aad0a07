# The numbers beside a picture: values at a point of it, in the plane of incidence, and where a bad one comes from.
client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   \rho = \vec{0.75, 0.5, 0.25}
| \end{equation}
| \begin{equation}
|   m = 2
| \end{equation}
| \begin{equation}
|   s(x) = m * x
| \end{equation}
| \begin{equation}
|   c = s(\vec{n} \cdot \vec{\omega_i})
| \end{equation}
| \begin{equation}
|   f = \rho * c
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> texbrdf/definitions {"uri": "file:///work/a.tex"}
<- {
     "id": 1,
     "result": [
       {"name":"f","label":"f","type":"colour"},
       {"name":"m","label":"m","type":"real"},
       {"name":"c","label":"c","type":"real"},
       {"name":"\\rho","label":"\\rho","type":"colour"}
     ]
   }
-> texbrdf/definitions {"uri": "file:///work/a.tex", "root": "c"}
<- {"id":2,"result":[{"name":"c","label":"c","type":"real"},{"name":"m","label":"m","type":"real"}]}
-> texbrdf/definitions {"uri": "file:///work/a.tex", "root": "zq"}
<- {"id":3,"result":[]}
# Nothing is open yet.
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":4,"error":{"code":-32602,"message":"there is no preview 1"}}
-> texbrdf/badPixels {"preview": 1}
<- {"id":5,"error":{"code":-32602,"message":"there is no preview 1"}}
-> texbrdf/plot {"preview": 1, "kind": "polar"}
<- {"id":6,"error":{"code":-32602,"message":"there is no preview 1"}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "width": 64, "height": 64, "light": {"theta": 0, "phi": 0}}
<- {"id":7,"result":{"preview":1,"root":"f"}}
# The middle of the sphere looks at the light and at the viewer.
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":8,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[1.5,1,0.5]}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "c"}
<- {
     "id": 9,
     "result": {
       "light": {"theta":0,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": [1.5,1,0.5],
       "definition": {"name":"c","type":"real","value":[2]}
     }
   }
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "\\rho"}
<- {
     "id": 10,
     "result": {
       "light": {"theta":0,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": [1.5,1,0.5],
       "definition": {"name":"\\rho","type":"colour","value":[0.75,0.5,0.25]}
     }
   }
# A function has no value of its own, and the corner shows no sphere.
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "s"}
<- {"id":11,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[1.5,1,0.5]}}
-> texbrdf/probe {"preview": 1, "x": 0.01, "y": 0.01}
<- {"id":12,"result":null}
# With the value of a slider, and then without.
-> texbrdf/setParameter {"preview": 1, "name": "m", "value": [4]}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "m"}
<- {
     "id": 13,
     "result": {
       "light": {"theta":0,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": [3,2,1],
       "definition": {"name":"m","type":"real","value":[4]}
     }
   }
-> texbrdf/setParameter {"preview": 1, "name": "m", "value": null}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":14,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[1.5,1,0.5]}}
# Halfway to the left N is (-1/2, 0, √3/2), and the light comes from there; zoomed, that is another place.
-> texbrdf/updatePreview {"preview": 1, "light": {"theta": 90, "phi": 180}}
-> texbrdf/probe {"preview": 1, "x": 0.275, "y": 0.5}
<- {"id":15,"result":{"light":{"theta":60,"phi":180},"view":{"theta":30,"phi":0},"value":[0.75,0.5,0.25]}}
-> texbrdf/updatePreview {"preview": 1, "zoom": 2}
-> texbrdf/probe {"preview": 1, "x": 0.05, "y": 0.5}
<- {"id":16,"result":{"light":{"theta":60,"phi":180},"view":{"theta":30,"phi":0},"value":[0.75,0.5,0.25]}}
# From behind the light reaches only definitions.
-> texbrdf/updatePreview {"preview": 1, "zoom": 1, "light": {"theta": 180, "phi": 0}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "c"}
<- {
     "id": 17,
     "result": {
       "light": {"theta":180,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": null,
       "definition": {"name":"c","type":"real","value":[-2]}
     }
   }
-> texbrdf/plot {"preview": 1, "kind": "polar"}
<- {
     "id": 18,
     "result": {"light":{"theta":180},"angles":[],"values":[],"cosine":true,"problem":"the light is behind the surface"}
   }
-> texbrdf/updatePreview {"preview": 1, "light": {"theta": 0, "phi": 0}}
-> texbrdf/badPixels {"preview": 1}
<- {"id":19,"result":{"size":64,"nan":0,"infinite":0,"negative":0,"first":null}}
# The document's numbers while it can be drawn; then those that were last.
change a.tex 5:7-5:8 "0.5"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":2,"diagnostics":[]}}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":20,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[0.375,0.25,0.125]}}
change a.tex 5:3-5:4 "q"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 3,
       "diagnostics": [
         {"range":"5:3-5:4","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `q`"},
         {
           "range": "8:10-8:11",
           "severity": 1,
           "code": "E3001",
           "source": "texbrdf",
           "message": "undefined name `m` in the definition of `s`"
         }
       ]
     }
   }
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":21,"result":{"light":{"theta":0,"phi":0},"view":{"theta":0,"phi":0},"value":[0.375,0.25,0.125]}}
change a.tex 5:3-5:4 "m"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":4,"diagnostics":[]}}
# A negative number: of a definition, then of a parameter that a function uses.
change a.tex 11:7-11:38 "-s(\\vec{n} \\cdot \\vec{\\omega_i})"
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":5,"diagnostics":[]}}
-> texbrdf/badPixels {"preview": 1}
<- {
     "id": 22,
     "result": {
       "size": 64,
       "nan": 0,
       "infinite": 0,
       "negative": 2684,
       "first": {
         "x": 0.4000562692924648,
         "y": 0.06178518074388406,
         "kind": "negative",
         "definition": "c",
         "label": "c",
         "location": {"uri":"a.tex","range":"11:3-11:4"}
       }
     }
   }
-> texbrdf/setParameter {"preview": 1, "name": "m", "value": [-1]}
change a.tex 11:7-11:8 ""
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":6,"diagnostics":[]}}
-> texbrdf/badPixels {"preview": 1}
<- {
     "id": 23,
     "result": {
       "size": 64,
       "nan": 0,
       "infinite": 0,
       "negative": 2684,
       "first": {
         "x": 0.4000562692924648,
         "y": 0.06178518074388406,
         "kind": "negative",
         "definition": "m",
         "label": "m",
         "location": {"uri":"a.tex","range":"5:3-5:4"}
       }
     }
   }
# A value that is none, and one without bounds.
change a.tex 11:7-11:38 "\\ln{-m}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "a.tex",
       "version": 7,
       "diagnostics": [{"range":"8:3-8:4","severity":4,"code":"E3013","source":"texbrdf","message":"nothing uses `s`"}]
     }
   }
-> texbrdf/setParameter {"preview": 1, "name": "m", "value": [1]}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5, "definition": "c"}
<- {
     "id": 24,
     "result": {
       "light": {"theta":0,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": ["nan","nan","nan"],
       "definition": {"name":"c","type":"real","value":["nan"]}
     }
   }
-> texbrdf/badPixels {"preview": 1}
<- {
     "id": 25,
     "result": {
       "size": 64,
       "nan": 2684,
       "infinite": 0,
       "negative": 0,
       "first": {
         "x": 0.4000562692924648,
         "y": 0.06178518074388406,
         "kind": "nan",
         "definition": "c",
         "label": "c",
         "location": {"uri":"a.tex","range":"11:3-11:4"}
       }
     }
   }
-> texbrdf/setParameter {"preview": 1, "name": "m", "value": [0]}
-> texbrdf/badPixels {"preview": 1}
<- {
     "id": 26,
     "result": {
       "size": 64,
       "nan": 0,
       "infinite": 2684,
       "negative": 0,
       "first": {
         "x": 0.4000562692924648,
         "y": 0.06178518074388406,
         "kind": "infinite",
         "definition": "c",
         "label": "c",
         "location": {"uri":"a.tex","range":"11:3-11:4"}
       }
     }
   }
# A BRDF that calls too much.
open b.tex
| \begin{equation}
|   g(x) = x * x * x * x * x * x * x * x
| \end{equation}
| \begin{equation}
|   h(x) = g(x+1) + g(x+2) + g(x+3) + g(x+4) + g(x+5) + g(x+6) + g(x+7) + g(x+8)
| \end{equation}
| \begin{equation}
|   k(x) = h(x+1) + h(x+2) + h(x+3) + h(x+4) + h(x+5) + h(x+6) + h(x+7) + h(x+8)
| \end{equation}
| \begin{equation}
|   l(x) = k(x+1) + k(x+2) + k(x+3) + k(x+4) + k(x+5) + k(x+6) + k(x+7) + k(x+8)
| \end{equation}
| \begin{equation}
|   f = l(\theta_h)
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"b.tex","version":1,"diagnostics":[]}}
-> texbrdf/openPreview {"uri": "file:///work/b.tex", "width": 64, "height": 64, "light": {"theta": 0, "phi": 0}, "cosine": false}
<- {"id":27,"result":{"preview":2,"root":"f"}}
-> texbrdf/probe {"preview": 2, "x": 0.5, "y": 0.5, "definition": "f"}
<- {
     "id": 28,
     "result": {
       "light": {"theta":0,"phi":0},
       "view": {"theta":0,"phi":0},
       "value": null,
       "problem": "the equations are too large for values at a point"
     }
   }
-> texbrdf/plot {"preview": 2, "kind": "cartesian"}
<- {
     "id": 29,
     "result": {
       "light": {"theta":0},
       "angles": [],
       "values": [],
       "cosine": false,
       "problem": "the equations are too large for values at a point"
     }
   }
-> texbrdf/badPixels {"preview": 2}
<- {
     "id": 30,
     "result": {
       "size": 0,
       "nan": 0,
       "infinite": 0,
       "negative": 0,
       "first": null,
       "problem": "the equations are too large for values at a point"
     }
   }
# Nothing that can be drawn.
-> texbrdf/openPreview {"uri": "file:///work/b.tex", "width": 64, "height": 64, "root": "zq"}
<- {"id":31,"result":{"preview":3,"root":"f"}}
-> texbrdf/probe {"preview": 3, "x": 0.5, "y": 0.5}
<- {"id":32,"result":null}
-> texbrdf/plot {"preview": 3, "kind": "polar"}
<- {"id":33,"result":null}
-> texbrdf/badPixels {"preview": 3}
<- {"id":34,"result":null}
# What the pane may get wrong.
-> texbrdf/probe {"preview": 1, "x": 0.5}
<- {"id":35,"error":{"code":-32602,"message":"`y` has to be a number"}}
-> texbrdf/probe {"preview": 7, "x": 0.5, "y": 0.5}
<- {"id":36,"error":{"code":-32602,"message":"there is no preview 7"}}
-> texbrdf/plot {"preview": 1, "kind": "round"}
<- {
     "id": 37,
     "error": {
       "code": -32602,
       "message": "`kind` has to be cartesian, lobe, polar, theta-o, theta-h, theta-d, albedo, slice"
     }
   }
-> texbrdf/closePreview {"preview": 1}
-> texbrdf/probe {"preview": 1, "x": 0.5, "y": 0.5}
<- {"id":38,"error":{"code":-32602,"message":"there is no preview 1"}}
=> exit status 1
