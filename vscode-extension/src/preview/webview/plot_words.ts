// What a plot says to those who do not see it, and the values at its cursor.
import type { Plot } from '../messages';
import { sampleAt } from './plot_shapes';
import { valueText } from './readout_words';

const channelNames = ['R', 'G', 'B'];

export function quantity(root: string, { cosine }: Plot): string {
  return cosine ? `${root} · cos θₒ` : root;
}

/** "R 0.12 · G 0.3 · B ∞" */
export function valuesAt({ angles, values }: Plot, angle: number): string {
  const index = sampleAt(angles, angle);
  if (values.some((list) => list[index] === null)) return 'below the surface';
  const texts = values.map((list) => valueText(list[index] ?? 'nan'));
  return texts.length === 1 ? texts.join('') : texts.map((text, channel) => `${channelNames[channel]} ${text}`).join(' · ');
}

export function plotDescription(kind: string, root: string, plot: Plot): string {
  const peak = highest(plot);
  const largest = peak === undefined ? plot.problem ?? 'no values' : `largest ${valueText(peak.value)} at ${peak.angle}°`;
  return `${kind} plot of ${quantity(root, plot)} over the viewer's angle, light at ${plot.light.theta.toFixed(0)}°; ${largest}`;
}

function highest({ angles, values }: Plot): { value: number; angle: number } | undefined {
  let best: { value: number; angle: number } | undefined;
  for (const list of values) {
    list.forEach((value, index) => {
      if (typeof value === 'number' && (best === undefined || value > best.value)) best = { value, angle: angles[index] ?? 0 };
    });
  }
  return best;
}
