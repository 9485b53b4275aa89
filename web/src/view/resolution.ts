// The resolution of the three-dimensional picture: while it moves, it is lowered until the browser
// draws often enough; a picture that stands still has the full resolution.

const kSteps = [1, 0.8, 0.65, 0.5];
const kSlow = 42; // ms between pictures
const kFast = 20;
const kPatience = 8; // pictures

export class Resolution {
  private step = 0;
  private last = 0;
  private slow = 0;

  constructor(private readonly finest: number) {}

  /** Pixels per CSS pixel of a picture that is followed by others. */
  get moving(): number {
    return this.finest * (kSteps[this.step] ?? 1);
  }

  get still(): number {
    return this.finest;
  }

  /** Called with each picture of a movement; `now` in ms. True if the resolution changes. */
  follow(now: number): boolean {
    const pause = now - this.last;
    this.last = now;
    if (pause > 400) return false; // it stood still
    this.slow = pause > kSlow ? this.slow + 1 : pause < kFast ? this.slow - 1 : this.slow;
    if (Math.abs(this.slow) < kPatience) return false;
    const next = Math.min(kSteps.length - 1, Math.max(0, this.step + Math.sign(this.slow)));
    this.slow = 0;
    const changes = next !== this.step;
    this.step = next;
    return changes;
  }
}
