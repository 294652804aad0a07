// The preview of a scene: what the page does goes to the server, which keeps camera and objects.
import type { FrameParams, OpenSceneResult, PreviewStateParams, SceneInput, SceneKeys, SceneView } from '../protocol';
import type { ShownPreview } from './shown_preview';

export class ScenePart {
  private views: SceneView[] = [];
  private view: string | undefined;
  private keys: SceneKeys[] = [];

  constructor(private readonly shown: ShownPreview) {}

  async open(uri: string, side: number): Promise<number> {
    const { preview, views }: OpenSceneResult = await this.shown.api.openScene({
      uri, width: side, height: side, ...(this.view === undefined ? {} : { view: this.view }),
    });
    this.views = views;
    this.view ??= views[0]?.name;
    this.post();
    return preview;
  }

  input(input: SceneInput): void {
    const preview = this.shown.id();
    if (preview !== undefined) this.shown.api.sceneInput({ preview, ...input });
  }

  choose(view: string): void {
    this.view = view;
    const preview = this.shown.id();
    if (preview !== undefined) this.shown.api.updateScene({ preview, view });
    this.post();
  }

  /** A key may have switched the view. */
  frameArrived({ view }: FrameParams): void {
    if (view === undefined || view === this.view) return;
    this.view = view;
    this.post();
  }

  stateArrived({ keys }: PreviewStateParams): void {
    this.keys = keys ?? [];
    this.post();
  }

  /** Null: what is shown is no scene. */
  post(): void {
    this.shown.post({ type: 'scene', views: this.views, view: this.view ?? null, keys: this.keys });
  }

  forget(): void {
    this.keys = [];
    this.view = undefined;
  }
}
