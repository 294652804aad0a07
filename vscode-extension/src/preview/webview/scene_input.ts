// What a person does to a scene, gathered until it is sent. Knows nothing of the page, so that tests can run it.
import type { SceneInput } from '../messages';
import { glfwName } from './key_names';

/** A wheel's notch, in the pixels that browsers count. */
const notch = 100;

export class SceneHands {
  private readonly held = new Set<string>();
  private pressed: string[] = [];
  private drag = { right: 0, down: 0 };
  private wheel = 0;

  /** False for a key that is not the scene's to have. */
  keyDown(code: string, isRepeated: boolean): boolean {
    const name = glfwName(code);
    if (name === undefined) return false;
    if (!isRepeated) this.pressed.push(name);
    this.held.add(name);
    return true;
  }

  keyUp(code: string): void {
    const name = glfwName(code);
    if (name !== undefined) this.held.delete(name);
  }

  /** The window has lost the keyboard: nobody tells of keys that go up now. */
  release(): void {
    this.held.clear();
  }

  /** In heights of the picture. */
  dragBy(right: number, down: number): void {
    this.drag = { right: this.drag.right + right, down: this.drag.down + down };
  }

  /** As a wheel event has it: positive towards the person. */
  turnWheel(pixels: number): void {
    this.wheel -= pixels / notch;
  }

  get isHolding(): boolean {
    return this.held.size > 0;
  }

  /** What is to be sent after so many seconds; undefined where nothing happened. */
  take(seconds: number): SceneInput | undefined {
    const { pressed, drag, wheel } = this;
    // A key that is up again already was down for a moment.
    const held = [...new Set([...this.held, ...pressed])];
    if (held.length === 0 && drag.right === 0 && drag.down === 0 && wheel === 0) return undefined;
    this.pressed = [];
    this.drag = { right: 0, down: 0 };
    this.wheel = 0;
    return { held, seconds, pressed, drag, wheel };
  }
}
