# Mistakes of scenes are told while they are typed, of all files that they name, open or not.
file ball.material.json
| {"name": "shiny", "base_shader": "ball.tex", "properties": [{"name": "k", "value": "blue"}]}
file ball.tex
| \begin{equation} k = 0.5 \end{equation}
| \begin{equation} f = k * \vec{1, 1, 1} \end{equation}
client {"rootUri": "file:///work"}
<- {"id":0,"positionEncoding":"utf-16"}
open ball.scene.json
| {
|   "materials": ["ball.material.json"],
|   "scene": [{"type": "Primitives/Sphare", "data": [0.5], "material_id": "shiny"}]
| }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 1,
       "diagnostics": [
         {
           "range": "3:22-3:41",
           "severity": 1,
           "source": "texbrdf",
           "message": "there is no object `Primitives/Sphare` (did you mean `Primitives/Sphere`?)"
         }
       ]
     }
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "diagnostics": [
         {
           "range": "1:84-1:90",
           "severity": 1,
           "source": "texbrdf",
           "message": "`blue` is neither a number nor several as in \"(0.5, 0.1, 0.5)\""
         }
       ]
     }
   }
change ball.scene.json 3:32-3:33 "e"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 2,
       "diagnostics": [
         {
           "range": "3:22-3:41",
           "severity": 1,
           "source": "texbrdf",
           "message": "there is no object `Primitivee/Sphare` (did you mean `Primitives/Sphere`?)"
         }
       ]
     }
   }
change ball.scene.json 3:33-3:33 "é"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 3,
       "diagnostics": [
         {
           "range": "3:22-3:42",
           "severity": 1,
           "source": "texbrdf",
           "message": "there is no object `Primitiveeé/Sphare` (did you mean `Primitives/Sphere`?)"
         }
       ]
     }
   }
change ball.scene.json "{\"scene\": []"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 4,
       "diagnostics": [
         {
           "range": "1:13-1:13",
           "severity": 1,
           "source": "texbrdf",
           "message": "no JSON: unexpected end of input; expected '}'"
         }
       ]
     }
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.material.json","diagnostics":[]}}
change ball.scene.json "{\"materials\": [\"ball.material.json\"], \"scene\": [{\"type\": \"Primitives/Sphere\"}]}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"ball.scene.json","version":5,"diagnostics":[]}
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "diagnostics": [
         {
           "range": "1:84-1:90",
           "severity": 1,
           "source": "texbrdf",
           "message": "`blue` is neither a number nor several as in \"(0.5, 0.1, 0.5)\""
         }
       ]
     }
   }
# The editor's text of a part counts, not that on the disk.
open ball.material.json
| {"name": "shiny", "base_shader": "ball.tex", "properties": [{"name": "k", "value": 0.25}, {"name": "m", "value": 1}]}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "version": 1,
       "diagnostics": [
         {
           "range": "1:100-1:103",
           "severity": 1,
           "source": "texbrdf",
           "message": "the shader ball.tex has no property `m`"
         }
       ]
     }
   }
change ball.material.json 1:106-1:107 "k"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "version": 2,
       "diagnostics": [
         {"range":"1:91-1:116","severity":1,"source":"texbrdf","message":"the key `value` is missing"},
         {
           "range": "1:100-1:103",
           "severity": 1,
           "source": "texbrdf",
           "message": "the shader ball.tex has no property `m`"
         },
         {
           "range": "1:105-1:112",
           "severity": 1,
           "source": "texbrdf",
           "message": "the key `kalue` is not known here (did you mean `value`?)"
         }
       ]
     }
   }
change ball.material.json "{\"name\": \"shiny\", \"base_shader\": \"ball.tex\", \"properties\": [{\"name\": \"k\", \"value\": 0.25}]}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"ball.material.json","version":3,"diagnostics":[]}
   }
# So does that of a document that gives a BRDF.
open ball.tex
| \begin{equation} f = \end{equation}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "version": 3,
       "diagnostics": [
         {
           "range": "1:34-1:44",
           "severity": 1,
           "source": "texbrdf",
           "message": "the document gives no BRDF: `f` cannot be used: it or something that it needs has an error"
         }
       ]
     }
   }
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.tex",
       "version": 1,
       "diagnostics": [
         {
           "range": "1:22-1:26",
           "severity": 1,
           "code": "E2001",
           "source": "texbrdf",
           "message": "expected an expression, found the end of the equation"
         }
       ]
     }
   }
change ball.tex "\\begin{equation} k = 1 \\end{equation} \\begin{equation} f = k * \\vec{1, 1, 1} \\end{equation}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {"uri":"ball.material.json","version":3,"diagnostics":[]}
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.tex","version":2,"diagnostics":[]}}
-> textDocument/didClose {"doc": "ball.material.json"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.material.json","diagnostics":[]}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.material.json",
       "diagnostics": [
         {
           "range": "1:84-1:90",
           "severity": 1,
           "source": "texbrdf",
           "message": "`blue` is neither a number nor several as in \"(0.5, 0.1, 0.5)\""
         }
       ]
     }
   }
# On the disk it was mended meanwhile.
file ball.material.json
| {"name": "shiny", "base_shader": "ball.tex"}
-> workspace/didChangeWatchedFiles {"changes": [{"uri": "file:///work/ball.material.json", "type": 2}]}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.material.json","diagnostics":[]}}
-> textDocument/hover {"doc": "ball.scene.json", "at": "1:1"}
<- {"id":1,"result":null}
-> textDocument/diagnostic {"doc": "ball.scene.json"}
<- {"id":2,"result":{"kind":"full","items":[]}}
-> textDocument/didSave {"doc": "ball.scene.json"}
change ball.scene.json "{\"materials\": [\"/secret.material.json\"], \"scene\": []}"
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 6,
       "diagnostics": [
         {
           "range": "1:16-1:39",
           "severity": 1,
           "source": "texbrdf",
           "message": "the file /secret.material.json is not in a folder of the workspace"
         }
       ]
     }
   }
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"diagnostics": false}}}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.scene.json","diagnostics":[]}}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.tex","diagnostics":[]}}
-> workspace/didChangeConfiguration {"settings": {"texbrdf": {"features": {"diagnostics": true}}}}
<- {
     "method": "textDocument/publishDiagnostics",
     "params": {
       "uri": "ball.scene.json",
       "version": 6,
       "diagnostics": [
         {
           "range": "1:16-1:39",
           "severity": 1,
           "source": "texbrdf",
           "message": "the file /secret.material.json is not in a folder of the workspace"
         }
       ]
     }
   }
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.tex","version":2,"diagnostics":[]}}
-> textDocument/didClose {"doc": "ball.scene.json"}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"ball.scene.json","diagnostics":[]}}
=> exit status 1
