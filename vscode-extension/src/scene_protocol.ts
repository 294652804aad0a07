// What requests about previews of scenes carry (docs/lsp.md); protocol.ts names their methods.

/** Device pixels. */
interface Size {
  width: number;
  height: number;
}

/** Of a preview of a scene. */
export interface SceneChange extends Partial<Size> {
  view?: string;
  exposure?: number;
  gamma?: number;
}

export interface OpenSceneParams extends SceneChange {
  uri: string;
}

export interface SceneView {
  name: string;
  /** What a pixel shows. */
  meaning: string;
}

export interface OpenSceneResult {
  preview: number;
  views: SceneView[];
}

export interface UpdateSceneParams extends SceneChange {
  preview: number;
}

/** What a person did since the last of these. */
export interface SceneInput {
  /** Keys that are down, called as GLFW calls them, without GLFW_KEY_. */
  held: string[];
  /** For which they were. */
  seconds: number;
  /** Keys that went down. */
  pressed: string[];
  /** Of the pointer, in heights of the picture. */
  drag: { right: number; down: number };
  /** Notches, away from the person. */
  wheel: number;
}

export interface SceneInputParams extends SceneInput {
  preview: number;
}

/** What moves an object. */
export interface SceneKeys {
  object: string;
  keys: string[];
}
