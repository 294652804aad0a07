// The page of the preview: hands what arrives to what shows it.
import type { ToPage } from '../messages';
import { markBadPixel, watchBadPixels } from './bad_pixels';
import { element, keep, oncePerFrame, tell } from './host';
import { showLook, watchLook } from './look';
import { forgetFurther, showFurther, watchFurther } from './further_plot';
import { forgetPicture, pictureBlob, showPicture, showState, showVersion } from './picture';
import { showPin, watchPin } from './pin';
import { forgetPlot, nameRoot, showPlot, watchPlots } from './plots';
import { clearReadout, showDefinitions, showReadout, showRoot, watchReadout } from './readout';
import { showKind, showScene, watchScene } from './scene';
import { showParameters, watchSliders } from './sliders';

const rootChoice = element<HTMLSelectElement>('root');
let shownUri = '';

function showDocument({ uri, name, version, roots, root, isScene }: ToPage & { type: 'document' }): void {
  if (uri !== shownUri) {
    forgetPicture();
    clearReadout();
    forgetPlot();
    forgetFurther();
  }
  shownUri = uri;
  showKind(isScene);
  element('name').textContent = name;
  element('rootChoice').hidden = roots.length < 2;
  rootChoice.replaceChildren(...roots.map((candidate) => new Option(candidate, candidate, false, candidate === root)));
  showVersion(version);
  showRoot(root);
  nameRoot(root);
}

function receive(message: ToPage): void {
  switch (message.type) {
    case 'document': showDocument(message); break;
    case 'version': showVersion(message.version); break;
    case 'look': showLook(message.look, message.standard); break;
    case 'scene': showScene(message); break;
    case 'picture': void showPicture(message.picture); break;
    case 'state': showState(message.state, message.message); break;
    case 'parameters': showParameters(message.parameters); break;
    case 'definitions': showDefinitions(message.definitions, message.chosen); break;
    case 'probed': showReadout(message.readout); break;
    case 'plot': showPlot(message.plot); break;
    case 'furtherPlot': showFurther(message.further); break;
    case 'badPixel': markBadPixel(message.pixel); break;
    case 'pinned': showPin(message.pin); break;
    case 'remember': keep({ session: message.memory }); break;
  }
}

function watchSize(): void {
  const stage = element('stage');
  const send = oncePerFrame(() => {
    const side = Math.min(stage.clientWidth, stage.clientHeight);
    if (side > 0) tell({ type: 'size', side: side * devicePixelRatio });
  });
  new ResizeObserver(() => { send(undefined); }).observe(stage);
  const watchRatio = () => {
    send(undefined);
    matchMedia(`(resolution: ${devicePixelRatio}dppx)`).addEventListener('change', watchRatio, { once: true });
  };
  watchRatio();
}

async function copyImage(): Promise<void> {
  await navigator.clipboard.write([new ClipboardItem({ 'image/png': pictureBlob() })]);
}

window.addEventListener('message', (event: MessageEvent<ToPage>) => { if (event.origin === window.origin) receive(event.data); });
rootChoice.addEventListener('change', () => { tell({ type: 'root', root: rootChoice.value }); });
element('saveImage').addEventListener('click', () => { tell({ type: 'saveImage' }); });
element('copyImage').addEventListener('click', () => { copyImage().catch((error: unknown) => { showState('none', `Cannot copy: ${String(error)}`); }); });
watchLook();
watchSliders();
watchPin();
watchReadout();
watchPlots();
watchFurther();
watchBadPixels();
watchScene();
watchSize();
tell({ type: 'ready' });
