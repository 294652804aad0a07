// Which documents are scenes, or parts of one.

export const sceneKinds = ['scene', 'model', 'material', 'shader', 'primitive'] as const;

/** For VS Code's document filters. */
export const scenePattern = `**/*.{${sceneKinds.join(',')}}.json`;

const ending = new RegExp(`\\.(${sceneKinds.join('|')})\\.json$`);

export function isSceneFile(uri: string): boolean {
  return ending.test(uri);
}
