// The range of the colours of the taxels: from 0 to a round number not below the largest value seen
// of the exploration or, while it is held, to what it was when it was held. Noise is no touch: the
// range has a least size where the unit tells.

const kLeast: Record<string, number | undefined> = { N: 1 };

export class ForceScale {
  private most = 0;
  private exploration = -1;
  held = false;
  unit = "";

  /** Told of every frame that is drawn. */
  see(exploration: number, values: readonly number[]): void {
    if (this.held) return;
    if (exploration !== this.exploration) this.most = 0;
    this.exploration = exploration;
    for (const value of values) this.most = Math.max(this.most, Math.abs(value) || 0);
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
