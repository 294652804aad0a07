// Between the linear colours of a document and the sRGB bytes of a colour picker.

/** What the picker shows for this colour: #rrggbb. */
export function pickerColour(linear: readonly number[]): string {
  return '#' + linear.map((value) => byteOf(value).toString(16).padStart(2, '0')).join('');
}

/** The linear colour that was picked; a channel that was left alone keeps its digits. */
export function pickedColour(picked: string, before: readonly number[]): number[] {
  return before.map((value, channel) => {
    const byte = parseInt(picked.slice(1 + 2 * channel, 3 + 2 * channel), 16);
    return byte === byteOf(value) ? value : Number(linearOf(byte).toFixed(3));
  });
}

function byteOf(linear: number): number {
  const value = Math.min(Math.max(linear, 0), 1);
  return Math.round(255 * (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055));
}

function linearOf(byte: number): number {
  const value = byte / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
