// A server and a page that only remember what they were told.
import type { WorkspaceEdit } from 'vscode-languageserver-protocol';
import { Session } from '../src/preview/session';
import { Api } from '../src/protocol';
import type {
  BadPixelsFound, Connection, Definition, FrameParams, Location, Notifications, Parameter, Plot, Probed, Requests, Surface,
} from '../src/protocol';
import type { TextChange } from '../src/text_changes';
import type { ToPage } from '../src/preview/messages';

export const look = { light: { theta: 30, phi: 150 }, zoom: 1, exposure: 0, gamma: 2, cosine: true };
export const nowhere = { start: { line: 0, character: 0 }, end: { line: 0, character: 1 } };

export function real(name: string, value: number, uri = 'file:///a.tex'): Parameter {
  return { name, label: name, type: 'real', value: [value], low: 0, high: 1, location: { uri, range: nowhere } };
}

export function definition(name: string): Definition {
  return { name, label: name, type: 'real' };
}

export const somePlot: Plot = { light: { theta: 30 }, angles: [-90, 0, 90], values: [[1, 2, 3]], cosine: false };

export class Fake implements Connection {
  readonly asked: [string, unknown][] = [];
  readonly told: [string, unknown][] = [];
  readonly posted: ToPage[] = [];
  readonly applied: TextChange[][] = [];
  readonly reports: string[] = [];
  readonly tables: [string, string][] = [];
  readonly revealed: Location[] = [];
  parameters: Parameter[] = [];
  definitions: Definition[] = [];
  plot: Plot | Surface | null = somePlot;
  bad: BadPixelsFound | null = { nan: 0, infinite: 0, negative: 0, first: null };
  probed: () => Promise<Probed | null> = () => Promise.resolve(null);
  /** Answers of apply, true when they are used up. */
  applies: boolean[] = [];
  /** Of parameterEdit; else one that tells what was asked. */
  edit: WorkspaceEdit | undefined;
  private previews = 0;

  readonly session = new Session({
    api: new Api(this),
    post: (message) => this.posted.push(message),
    apply: (changes) => {
      this.applied.push(changes);
      return Promise.resolve(this.applies.shift() ?? true);
    },
    reveal: (place) => this.revealed.push(place),
    saveImage: () => undefined,
    saveTable: (table, fileName) => this.tables.push([table, fileName]),
    roots: () => Promise.resolve({ root: 'f', candidates: ['f', 'g'] }),
    report: (problem) => this.reports.push(problem),
    standardLook: () => look,
  });

  request<M extends keyof Requests>(method: M, params: Requests[M][0]): Promise<Requests[M][1]> {
    this.asked.push([method, params]);
    const answers: Partial<{ [K in keyof Requests]: () => Requests[K][1] | Promise<Requests[K][1]> }> = {
      'texbrdf/openPreview': () => ({ preview: ++this.previews, root: 'f' }),
      'texbrdf/openScene': () => ({ preview: ++this.previews, views: [{ name: 'shaded', meaning: 'lit' }, { name: 'normals', meaning: '' }] }),
      'texbrdf/parameters': () => this.parameters,
      'texbrdf/definitions': () => this.definitions,
      'texbrdf/probe': () => this.probed(),
      'texbrdf/plot': () => this.plot,
      'texbrdf/badPixels': () => this.bad,
      'texbrdf/parameterEdit': () => this.edit ?? ({
        documentChanges: [{ textDocument: { uri: 'file:///a.tex', version: 1 }, edits: [{ range: nowhere, newText: JSON.stringify(params) }] }],
      }),
    };
    const answer = answers[method];
    return answer === undefined ? Promise.reject(new Error(method)) : Promise.resolve(answer());
  }

  notify<M extends keyof Notifications>(method: M, params: Notifications[M]): void {
    this.told.push([method, params]);
  }

  ofType<T extends ToPage['type']>(type: T): (ToPage & { type: T })[] {
    return this.posted.filter((message): message is ToPage & { type: T } => message.type === type);
  }

  askedOf(method: keyof Requests): unknown[] {
    return this.asked.filter(([name]) => name === method).map(([, params]) => params);
  }

  /** Probes wait until the returned function answers them, one after the other. */
  holdProbes(): (answer: Probed | null) => void {
    const waiting: ((answer: Probed | null) => void)[] = [];
    this.probed = () => new Promise((resolve) => waiting.push(resolve));
    return (answer) => waiting.shift()?.(answer);
  }

  toldOf(method: string): unknown[] {
    return this.told.filter(([name]) => name === method).map(([, params]) => params);
  }

  async show(name: string): Promise<void> {
    await this.session.show({ uri: `file:///${name}`, name, version: 1, root: undefined });
  }
}

/** A session whose page is there and shows a document. */
export async function opened({ parameters = [real('m', 0.25)], definitions = [] as Definition[] } = {}): Promise<Fake> {
  const fake = new Fake();
  fake.parameters = parameters;
  fake.definitions = definitions;
  await fake.show('a.tex');
  await fake.session.pageSays({ type: 'ready' });
  await fake.session.pageSays({ type: 'size', side: 512 });
  return fake;
}

export function frame(preview: number, version = 1): FrameParams {
  return {
    preview, uri: 'file:///a.tex', version, source: 'cpu', width: 64, height: 64, png: 'AAAA', milliseconds: 1,
    badPixels: { nan: 0, infinite: 0, negative: 0 }, current: true,
  };
}
