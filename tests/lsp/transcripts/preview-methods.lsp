# What a pane asks beside its pictures: parameters, the edits that write them, the definitions that may be drawn, and generated code.
client {}
open a.tex
| \begin{equation}
|   \rho_d = \vec{0.5, 0.25, 0} % range [0, 1]
| \end{equation}
| \begin{equation}
|   m = .30 % range [0.01, 2]
| \end{equation}
| \begin{equation}
|   f_s = \rho_d * \cos{\theta_h} / m
| \end{equation}
| \begin{equation}
|   f_d = \rho_d / \pi
| \end{equation}
-> texbrdf/roots {"uri": "file:///work/a.tex"}
-> texbrdf/parameters {"uri": "file:///work/a.tex"}
-> texbrdf/parameters {"uri": "file:///work/a.tex", "root": "f_d"}
-> texbrdf/parameterEdit {"uri": "file:///work/a.tex", "name": "m", "value": [0.4567]}
-> texbrdf/parameterEdit {"uri": "file:///work/a.tex", "name": "\\rho_d", "value": [0.5, 0.125, 1]}
-> texbrdf/parameterEdit {"uri": "file:///work/a.tex", "name": "zq", "value": [1]}
-> texbrdf/emit {"uri": "file:///work/a.tex", "target": "glsl", "root": "f_d"}
-> texbrdf/emit {"uri": "file:///work/a.tex", "target": "glsl", "root": "zq"}
-> texbrdf/emit {"uri": "file:///work/a.tex", "target": "basic"}
-> texbrdf/openPreview {"uri": "file:///work/gone.tex", "width": 64, "height": 64}
-> texbrdf/openPreview {"uri": "file:///work/a.tex", "width": 64, "height": 64, "gamma": 0}
