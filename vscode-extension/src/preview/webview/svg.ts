// Shapes into the page.
import type { Shape } from './plot_shapes';

const namespace = 'http://www.w3.org/2000/svg';

export function drawShapes(svg: SVGElement, shapes: readonly Shape[]): void {
  svg.replaceChildren(...shapes.map(nodeOf));
}

function nodeOf({ tag, className, attributes, text }: Shape): SVGElement {
  const node = document.createElementNS(namespace, tag);
  node.setAttribute('class', className);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, String(value));
  if (text === undefined) return node;
  if (tag === 'text') node.textContent = text;
  else node.appendChild(titleOf(text));
  return node;
}

/** What is shown when the pointer rests on a shape. */
function titleOf(text: string): SVGElement {
  const title = document.createElementNS(namespace, 'title');
  title.textContent = text;
  return title;
}
