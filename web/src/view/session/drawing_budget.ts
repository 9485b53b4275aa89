// The budget of drawing: if the browser draws a moving body less than thirty times per second, the
// panels show fewer frames, and the picture of the body has fewer pixels. A body that rests has all
// its pixels.

interface Level {
  pause: number; // ms, at least, between two frames that the panels show
  resolution: number; // share of the finest
}

const kLevels: readonly Level[] = [
  { pause: 30, resolution: 1 },
  { pause: 100, resolution: 1 },
  { pause: 200, resolution: 0.9 },
  { pause: 300, resolution: 0.75 },
];
const kWindow = 500; // ms over which pictures are counted
const kSlow = 30; // pictures per second
const kFast = 45;
const kPatience = 6; // fast windows, before more is drawn

export class DrawingBudget {
  private level = 0;
  private begun: number | null = null; // ms, of the window
  private pictures = 0;
  private fast = 0;
  /** ms from a picture to the next, as it was in the last window; null before the first. */
  interval: number | null = null;

  get pause(): number {
    return kLevels[this.level]!.pause;
  }

  get resolution(): number {
    return kLevels[this.level]!.resolution;
  }

  /** Called with each picture of a movement; `now` in ms. */
  follow(now: number): void {
    this.begun ??= now;
    const passed = now - this.begun;
    if (passed >= kWindow) {
      this.interval = passed / this.pictures;
      this.judge(1000 / this.interval);
      this.begun = now;
      this.pictures = 0;
    }
    this.pictures += 1;
  }

  /** Nothing moves: the time until the next picture does not count. */
  rest(): void {
    this.begun = null;
    this.pictures = 0;
  }

  private judge(rate: number): void {
    this.fast = rate > kFast ? this.fast + 1 : 0;
    const isFast = this.fast >= kPatience;
    if (isFast) this.fast = 0;
    const step = rate < kSlow ? 1 : isFast ? -1 : 0;
    this.level = Math.min(kLevels.length - 1, Math.max(0, this.level + step));
  }
}
