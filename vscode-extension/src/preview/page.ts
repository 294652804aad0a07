// The HTML of the preview. Nothing but its own two files may run or be loaded; pictures arrive as data.

export interface PageParts {
  scriptUri: string;
  styleUri: string;
}

export interface WebviewParts extends PageParts {
  nonce: string;
  /** Where VS Code serves the two files from. */
  source: string;
}

export function contentSecurityPolicy({ nonce, source }: WebviewParts): string {
  return [`default-src 'none'`, `img-src data:`, `style-src ${source}`, `script-src 'nonce-${nonce}'`].join('; ');
}

/** Of a page that `texbrdf lsp --preview-port` serves; it sends a policy as well, which allows no more. */
export const browserPolicy = [`default-src 'none'`, `img-src data:`, `style-src 'self'`, `script-src 'self'`, `connect-src 'self'`].join('; ');

export function webviewPage(parts: WebviewParts): string {
  return previewPage(parts, contentSecurityPolicy(parts), ` nonce="${parts.nonce}"`);
}

export function browserPage(parts: PageParts): string {
  return previewPage(parts, browserPolicy, '');
}

function previewPage(parts: PageParts, policy: string, scriptAttributes: string): string {
  return `<!DOCTYPE html>
<html lang="en">
<head>
  <meta charset="utf-8">
  <meta http-equiv="Content-Security-Policy" content="${policy}">
  <meta name="viewport" content="width=device-width, initial-scale=1">
  <link rel="stylesheet" href="${parts.styleUri}">
  <title>texbrdf preview</title>
</head>
<body>
  <header>
    <span id="name"></span>
    <label id="rootChoice" hidden>definition <select id="root"></select></label>
    <label id="sceneChoice">view <select id="sceneView"></select></label>
    <label id="comparison" hidden>compare <select id="compare"><option value="beside">side by side</option><option value="over">overlaid</option></select></label>
    <label id="wipeLabel" hidden>pinned <input id="wipe" type="range" min="0" max="100" value="50"></label>
    <button id="pin" aria-pressed="false" title="Keep this picture, to compare it with what you type next">Pin</button>
    <button id="saveImage" title="Save this picture as PNG">Save image</button>
    <button id="copyImage" title="Copy this picture">Copy image</button>
  </header>
  <div id="views">
    <main>
      <div id="stage" tabindex="0" role="application" aria-describedby="keys"
           aria-label="Sphere made of the BRDF. Arrow keys turn the light, plus and minus zoom, 0 resets; W, A, S, D move the point that is read out.">
        <img id="picture" alt="The BRDF on a lit sphere" draggable="false" hidden>
        <img id="pinned" alt="The pinned picture" draggable="false" hidden>
        <svg id="marks" viewBox="0 0 1 1" aria-hidden="true">
          <circle id="probeMark" class="mark" r="0.012" visibility="hidden" />
          <circle id="badMark" class="mark bad" r="0.03" visibility="hidden" />
        </svg>
        <div id="sceneLayer" tabindex="0" role="application" aria-describedby="sceneHint sceneKeys" aria-label="The scene. Drag to look around; W, A, S, D and arrow keys move, R resets, 1 to 5 switch views." hidden></div>
        <p id="notice" role="status"></p>
      </div>
      <button id="showBad" title="Go to the definition that first makes a pixel bad, and mark the pixel" hidden>Bad pixels: show where</button>
      <p id="keys" class="hint">Drag, arrow keys: light · wheel, + −: zoom · double click, 0: reset · point, W A S D: values</p>
      <p id="sceneHint" class="hint">Drag: look around · wheel: nearer · W A S D, arrows, Q E: move · R: reset · 1–5: views</p>
      <p id="sceneKeys" class="hint"></p>
      <div id="readout">
        <output id="readoutDirections" aria-live="off" aria-label="Directions at the point"></output>
        <div>
          <output id="readoutValue" aria-label="Value of the BRDF"></output>
          <label id="definitionChoice" hidden>also <select id="definition" title="A definition whose value is shown too"></select></label>
          <output id="readoutDefinition" aria-live="off" aria-label="Value of the chosen definition"></output>
        </div>
      </div>
    </main>
    <details id="plots" open>
      <summary>Plots</summary>
      <div id="plotControls">
        <label>scale <select id="plotScale"><option>linear</option><option>log</option></select></label>
        <span id="channels" role="group" aria-label="Channels">
          <label class="check red"><input id="red" type="checkbox" checked> R</label>
          <label class="check green"><input id="green" type="checkbox" checked> G</label>
          <label class="check blue"><input id="blue" type="checkbox" checked> B</label>
          <label class="check grey"><input id="grey" type="checkbox"> luminance</label>
        </span>
        <button id="saveCurve" title="Save the numbers of these curves as CSV">Save CSV</button>
        <label>θₒ <input id="cursor" type="range" min="-90" max="90" step="0.5" value="0"></label>
      </div>
      <div id="figures">
        <svg id="polar" class="plot" role="img"></svg>
        <svg id="cartesian" class="plot" role="img"></svg>
      </div>
      <output id="cursorValue" aria-live="off" aria-label="Values at the cursor"></output>
      <output id="pinnedValue" aria-live="off" aria-label="Pinned values at the cursor" hidden></output>
      <div id="furtherControls">
        <label>also <select id="furtherKind">
          <option value="">nothing</option><option value="lobe">the lobe</option><option value="theta-h">f over θ_h</option>
          <option value="theta-d">f over θ_d</option><option value="albedo">the albedo</option><option value="slice">a slice θ_h × θ_d</option>
        </select></label>
        <label id="furtherFixedLabel" hidden><span id="furtherFixedName"></span> <input id="furtherFixed" type="number" min="0" max="90" step="5" value="0"></label>
        <label id="furtherPhiLabel" hidden>φ_d <input id="furtherPhi" type="number" min="-180" max="180" step="15" value="90"></label>
        <label id="furtherChannelLabel" hidden>of <select id="furtherChannel"><option>luminance</option><option>red</option><option>green</option><option>blue</option></select></label>
        <button id="saveFurther" title="Save the numbers of this plot as CSV" hidden>Save CSV</button>
      </div>
      <svg id="furtherCurve" class="plot" role="img" hidden></svg>
      <canvas id="furtherSurface" class="plot" role="img" tabindex="0" hidden></canvas>
      <output id="furtherValue" aria-live="off" aria-label="Values of the further plot under the pointer" hidden></output>
      <output id="furtherPinned" aria-live="off" aria-label="Pinned values of the further plot under the pointer" hidden></output>
    </details>
  </div>
  <output id="status" aria-live="off"></output>
  <section id="look" aria-label="Picture">
    <label>Exposure <input id="exposure" type="range" min="-8" max="8" step="0.01"><output id="exposureValue"></output></label>
    <label>Gamma <input id="gamma" type="range" min="1" max="4" step="0.01"><output id="gammaValue"></output></label>
    <label class="check"><input id="cosine" type="checkbox"> × N·L</label>
    <button id="resetLook">Reset picture</button>
    <div id="object" role="group" aria-label="Object and light">
      <label>Object <select id="shape"><option value="sphere">sphere</option><option value="teapot">teapot</option><option value="file">a .obj file</option></select></label>
      <label id="shapePathLabel" hidden>path <input id="shapePath" type="text" placeholder="models/cup.obj" spellcheck="false"></label>
      <label>Light <select id="lightSource"><option value="directional">directional</option><option value="sky">sky</option><option value="furnace">furnace</option><option value="file">a .hdr file</option></select></label>
      <label id="lightPathLabel" hidden>path <input id="lightPath" type="text" placeholder="lights/yard.hdr" spellcheck="false"></label>
      <label id="samplesLabel" hidden>samples <input id="samples" type="number" min="1" max="65536" step="1" required></label>
      <span id="sky" hidden>
        <label>sun at <input id="sunElevation" type="range" min="0" max="90" step="1"></label>
        <label>from <input id="sunAzimuth" type="range" min="-180" max="180" step="1"></label>
        <label>haze <input id="turbidity" type="range" min="2" max="10" step="0.1"></label>
      </span>
    </div>
  </section>
  <section id="parameters" aria-label="Parameters" hidden>
    <div id="sliders"></div>
    <button id="resetAll" title="All parameters as they were when this document was first drawn">Reset all</button>
  </section>
  <script${scriptAttributes} src="${parts.scriptUri}"></script>
</body>
</html>`;
}
