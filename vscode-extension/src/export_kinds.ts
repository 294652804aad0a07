// What can be exported, and the command line that makes it.

export interface Picture {
  size: number;
  exposure: number;
  gamma: number;
}

export interface ExportKind {
  label: string;
  description: string;
  extension: string;
  arguments: (picture: Picture) => string[];
  /** More arguments for a second try where there is no renderer (exit status 3). */
  withoutRenderer?: string[];
}

export const exportKinds: ExportKind[] = [
  { label: 'Disney BRDF Explorer', description: '.brdf', extension: 'brdf', arguments: () => ['compile', '--target', 'disney'] },
  { label: 'GLSL', description: '.glsl', extension: 'glsl', arguments: () => ['compile', '--target', 'glsl'] },
  {
    label: 'Picture of a sphere', description: '.png', extension: 'png',
    arguments: ({ size, exposure, gamma }) => ['render', '--size', `${size}`, '--exposure', `${exposure}`, '--gamma', `${gamma}`],
    withoutRenderer: ['--device', 'cpu'],
  },
  { label: 'Syntax trees', description: '.svg', extension: 'svg', arguments: () => ['ast', '--format', 'svg'] },
];

export const noRenderer = 3;
