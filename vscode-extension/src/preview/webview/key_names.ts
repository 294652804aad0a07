// What GLFW calls a key, without GLFW_KEY_, by the `code` that browsers give it: both name places on the keyboard.

const names: Record<string, string> = {
  Space: 'SPACE', Quote: 'APOSTROPHE', Comma: 'COMMA', Minus: 'MINUS', Period: 'PERIOD', Slash: 'SLASH',
  Semicolon: 'SEMICOLON', Equal: 'EQUAL', BracketLeft: 'LEFT_BRACKET', Backslash: 'BACKSLASH', BracketRight: 'RIGHT_BRACKET',
  Backquote: 'GRAVE_ACCENT', IntlBackslash: 'WORLD_1', Escape: 'ESCAPE', Enter: 'ENTER', Backspace: 'BACKSPACE',
  Insert: 'INSERT', Delete: 'DELETE', ArrowRight: 'RIGHT', ArrowLeft: 'LEFT', ArrowDown: 'DOWN', ArrowUp: 'UP',
  PageUp: 'PAGE_UP', PageDown: 'PAGE_DOWN', Home: 'HOME', End: 'END', CapsLock: 'CAPS_LOCK', ScrollLock: 'SCROLL_LOCK',
  NumLock: 'NUM_LOCK', PrintScreen: 'PRINT_SCREEN', Pause: 'PAUSE', NumpadDecimal: 'KP_DECIMAL', NumpadDivide: 'KP_DIVIDE',
  NumpadMultiply: 'KP_MULTIPLY', NumpadSubtract: 'KP_SUBTRACT', NumpadAdd: 'KP_ADD', NumpadEnter: 'KP_ENTER', NumpadEqual: 'KP_EQUAL',
  ShiftLeft: 'LEFT_SHIFT', ControlLeft: 'LEFT_CONTROL', AltLeft: 'LEFT_ALT', MetaLeft: 'LEFT_SUPER', ShiftRight: 'RIGHT_SHIFT',
  ControlRight: 'RIGHT_CONTROL', AltRight: 'RIGHT_ALT', MetaRight: 'RIGHT_SUPER', ContextMenu: 'MENU',
};

/** Undefined for Tab, which leads out of the picture, and for keys that GLFW does not know. */
export function glfwName(code: string): string | undefined {
  const numbered = /^(Key|Digit|Numpad|F)([A-Z]|\d{1,2})$/.exec(code);
  if (numbered === null) return Object.hasOwn(names, code) ? names[code] : undefined;
  const [, kind, which = ''] = numbered;
  if (kind === 'Numpad') return `KP_${which}`;
  return kind === 'F' ? code : which;
}
