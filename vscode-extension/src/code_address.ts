// The address of generated code: what it is made of, and a name that people can read.
import type { Target } from './protocol';

export interface CodeAddress {
  uri: string;
  target: Target;
  root?: string;
}

const extensions: Record<Target, string> = { glsl: 'glsl', disney: 'brdf' };

/** The path and query of a virtual document's address. */
export function codeAddress(address: CodeAddress): { path: string; query: string } {
  const file = decodeURIComponent(address.uri.slice(address.uri.lastIndexOf('/') + 1));
  const which = address.root === undefined ? '' : ` (${address.root.replaceAll('/', ' ')})`;
  return { path: `/${file.replace(/\.\w+$/, '')}${which}.${extensions[address.target]}`, query: JSON.stringify(address) };
}

export function codeSource(query: string): CodeAddress {
  return JSON.parse(query) as CodeAddress;
}

/** The code, or what was good last below a line that says why there is no newer. */
export function shownCode(text: string | null | undefined, problem: string | undefined, last: string | undefined): string {
  if (text !== null && text !== undefined) return text;
  const why = `// ${(problem ?? 'the document has errors').replaceAll('\n', ' ')}\n`;
  return last === undefined ? why : `${why}// What follows is of an earlier version of the document.\n\n${last}`;
}
