// The scale of touch: from 0 to a round number that the strongest touch of nine of ten touched
// sensors does not exceed, so that one sensor does not darken all others. It covers the exploration
// so far, or is fixed while it is held. Noise is not touch, so that the scale has a minimum for known
// units.

import type { NumberOrNull } from "../parts/data";

const kLeast: Record<string, number | undefined> = { N: 1 };
const kShare = 0.9; // of the touched sensors
const kNoise = 0.02; // of the strongest: a sensor below is not touched

export class ForceScale {
  private most: number[] = []; // of each sensor
  private exploration = -1;
  private known: number | null = null;
  held = false;
  private measure = "";

  set unit(unit: string) {
    if (unit !== this.measure) this.known = null;
    this.measure = unit;
  }

  /** Called for every frame that is drawn. */
  see(exploration: number, values: readonly NumberOrNull[]): void {
    if (this.held) return;
    if (exploration !== this.exploration) this.clear();
    this.exploration = exploration;
    values.forEach((value, i) => {
      const size = Math.abs(value ?? 0) || 0;
      if (size <= (this.most[i] ?? 0)) return;
      this.most[i] = size;
      this.known = null;
    });
  }

  get end(): number {
    this.known ??= roundNumber(Math.max(usual(this.most), kLeast[this.measure] ?? 0));
    return this.known;
  }

  share(value: number): number {
    return Math.min(1, Math.max(0, Math.abs(value) / this.end || 0));
  }

  private clear(): void {
    this.most = [];
    this.known = null;
  }
}

/** The maximum of nine of ten of the touched sensors. */
function usual(most: readonly number[]): number {
  const strongest = Math.max(0, ...most.filter((one) => one > 0));
  const touched = most.filter((one) => one > kNoise * strongest).sort((a, b) => a - b);
  return touched[Math.ceil(kShare * touched.length) - 1] ?? 0;
}

/** 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten, not below `value`; 1 for nothing. */
export function roundNumber(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const times = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((digit) => digit * power >= value * (1 - 1e-9)) ?? 10;
  return Number((times * power).toPrecision(3));
}
