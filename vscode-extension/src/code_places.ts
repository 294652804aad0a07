// Which equation made which lines of generated code.
import type { Position, Range } from 'vscode-languageserver-protocol';
import type { Place } from './protocol';

/** The equation in which a place of a document lies; of several the shortest. */
export function placeAt(places: readonly Place[], uri: string, position: Position): Place | undefined {
  const around = places.filter((place) => place.uri === uri && contains(place.range, position));
  return around.sort((a, b) => lineCount(a) - lineCount(b))[0];
}

/** The equation that made a line of the code. */
export function placeOfLine(places: readonly Place[], line: number): Place | undefined {
  return places.find(({ lines: [first, last] }) => first <= line && line <= last);
}

function contains({ start, end }: Range, position: Position): boolean {
  return !isBefore(position, start) && !isBefore(end, position);
}

function isBefore(a: Position, b: Position): boolean {
  return a.line < b.line || (a.line === b.line && a.character < b.character);
}

function lineCount({ range }: Place): number {
  return range.end.line - range.start.line;
}
