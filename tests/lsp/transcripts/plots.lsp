# Plots of every kind. The BRDF is slow, so that there are few numbers.
client {}
<- {"id":0,"positionEncoding":"utf-16"}
open a.tex
| \begin{equation}
|   f = \vec{1, 2, 4} * \sum_{i=1}^{30000} \frac{\vec{n} \cdot \vec{\omega_i}}{30000}
| \end{equation}
<- {"method":"textDocument/publishDiagnostics","params":{"uri":"a.tex","version":1,"diagnostics":[]}}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "width": 64, "height": 64, "light": {"theta": 60, "phi": 10}, "cosine": false}
<- {"id":1,"result":{"preview":1,"root":"f"}}
-> texbrdf/plot {"preview": 1, "kind": "theta-o"}
<- {
     "id": 2,
     "result": {
       "light": {"theta":60},
       "angles": [-90,-60,-30,0,30,60,90],
       "values": [
         [0.4999999999999498,0.4999999999999498,0.4999999999999498,0.4999999999999498,0.4999999999999498,0.4999999999999498,0.4999999999999498],
         [0.9999999999998996,0.9999999999998996,0.9999999999998996,0.9999999999998996,0.9999999999998996,0.9999999999998996,0.9999999999998996],
         [1.9999999999997993,1.9999999999997993,1.9999999999997993,1.9999999999997993,1.9999999999997993,1.9999999999997993,1.9999999999997993]
       ],
       "cosine": false
     }
   }
-> texbrdf/plot {"preview": 1, "kind": "theta-h", "thetaD": 30, "phiD": 0}
<- {
     "id": 3,
     "result": {
       "light": {"theta":60},
       "angles": [0,10,20,30,40,50,60,70,80,90],
       "values": [
         [
           0.8660254037838386,
           0.7660444431190063,
           0.6427876096862085,
           0.4999999999999498,
           0.34202014332564756,
           0.17364817766701338,
           0,
           null,
           null,
           null
         ],
         [
           1.7320508075676773,
           1.5320888862380126,
           1.285575219372417,
           0.9999999999998996,
           0.6840402866512951,
           0.34729635533402675,
           0,
           null,
           null,
           null
         ],
         [
           3.4641016151353545,
           3.0641777724760253,
           2.571150438744834,
           1.9999999999997993,
           1.3680805733025903,
           0.6945927106680535,
           0,
           null,
           null,
           null
         ]
       ],
       "cosine": false
     }
   }
-> texbrdf/plot {"preview": 1, "kind": "theta-d", "thetaH": 60}
<- {
     "id": 4,
     "result": {
       "light": {"theta":60},
       "angles": [0,10,20,30,40,50,60,70,80,90],
       "values": [
         [0.4999999999999498,0.49240387650631207,0.469846310393034,0.4330127018919193,0.38302222155950316,0.32139380484310426,0.2499999999999749,0.17101007166282378,0.08682408883350669,0],
         [0.9999999999998996,0.9848077530126241,0.939692620786068,0.8660254037838386,0.7660444431190063,0.6427876096862085,0.4999999999999498,0.34202014332564756,0.17364817766701338,0],
         [1.9999999999997993,1.9696155060252483,1.879385241572136,1.7320508075676773,1.5320888862380126,1.285575219372417,0.9999999999998996,0.6840402866512951,0.34729635533402675,0]
       ],
       "cosine": false
     }
   }
-> texbrdf/plot {"preview": 1, "kind": "slice", "phiD": 0}
<- {
     "id": 5,
     "result": {
       "light": {"theta":60},
       "rows": [9,27,45,63,81],
       "columns": [9,27,45,63,81],
       "values": [
         [
           0.9510565162947143,
           0.8090169943753971,
           0.5877852522925751,
           0.3090169943748341,
           0,
           0.8090169943753971,
           0.5877852522925751,
           0.3090169943748341,
           0,
           null,
           0.5877852522925751,
           0.3090169943748341,
           0,
           null,
           null,
           0.3090169943748341,
           0,
           null,
           null,
           null,
           0,
           null,
           null,
           null,
           null
         ],
         [
           1.9021130325894287,
           1.6180339887507942,
           1.1755705045851501,
           0.6180339887496682,
           0,
           1.6180339887507942,
           1.1755705045851501,
           0.6180339887496682,
           0,
           null,
           1.1755705045851501,
           0.6180339887496682,
           0,
           null,
           null,
           0.6180339887496682,
           0,
           null,
           null,
           null,
           0,
           null,
           null,
           null,
           null
         ],
         [
           3.8042260651788573,
           3.2360679775015884,
           2.3511410091703002,
           1.2360679774993364,
           0,
           3.2360679775015884,
           2.3511410091703002,
           1.2360679774993364,
           0,
           null,
           2.3511410091703002,
           1.2360679774993364,
           0,
           null,
           null,
           1.2360679774993364,
           0,
           null,
           null,
           null,
           0,
           null,
           null,
           null,
           null
         ]
       ],
       "cosine": false
     }
   }
# Too slow for so many numbers.
-> texbrdf/plot {"preview": 1, "kind": "lobe"}
<- {
     "id": 6,
     "result": {
       "light": {"theta":60,"phi":10},
       "rows": [],
       "columns": [],
       "values": [],
       "cosine": false,
       "problem": "the BRDF is too slow to be plotted"
     }
   }
-> texbrdf/plot {"preview": 1, "kind": "albedo"}
<- {
     "id": 7,
     "result": {
       "light": {"theta":60},
       "angles": [],
       "values": [],
       "cosine": false,
       "problem": "the BRDF is too slow to be plotted"
     }
   }
# What the pane may get wrong.
-> texbrdf/plot {"preview": 1, "kind": "theta-h", "thetaD": 91}
<- {"id":8,"error":{"code":-32602,"message":"theta-d has to be an angle of 0 to 90 degrees, got 91"}}
-> texbrdf/plot {"preview": 1, "kind": "theta-h", "thetaD": "x"}
<- {"id":9,"error":{"code":-32602,"message":"`thetaD` has to be a number"}}
=> exit status 1
