// The range of the taxels' colours: from 0 to a round number not below the largest value of the
// exploration so far, or fixed while the scale is held. Noise is not touch, so the range has a
// minimum size for known units.

import type { NumberOrNull } from "../parts/data";

const kLeast: Record<string, number | undefined> = { N: 1 };

export class ForceScale {
  private most = 0;
  private exploration = -1;
  held = false;
  unit = "";

  /** Called for every frame that is drawn. */
  see(exploration: number, values: readonly NumberOrNull[]): void {
    if (this.held) return;
    if (exploration !== this.exploration) this.most = 0;
    this.exploration = exploration;
    for (const value of values) this.most = Math.max(this.most, Math.abs(value ?? 0) || 0);
  }

  get end(): number {
    return roundNumber(Math.max(this.most, kLeast[this.unit] ?? 0));
  }

  share(value: number): number {
    return Math.min(1, Math.max(0, Math.abs(value) / this.end || 0));
  }
}

/** 1, 2 or 5 times a power of ten, not below `value`; 1 for nothing. */
export function roundNumber(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const times = [1, 2, 5, 10].find((digit) => digit * power >= value * (1 - 1e-9)) ?? 10;
  return Number((times * power).toPrecision(3));
}
