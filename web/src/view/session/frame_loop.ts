// Draws the newest frame once per animation frame of the browser, or less often if the budget of
// drawing demands it, and counts the dropped frames in between. Nothing is drawn while the page is hidden, because the browser then requests no
// animation frames.

export interface Work {
  drawn: number;
  dropped: number;
  usual: number; // ms of the page's own work, the middle of the last `remembered` frames
  most: number; // ms, of those
  drawing: number; // ms, the middle of what drawing in three dimensions took between two frames
}

/** The three-dimensional drawing adds its time here, in ms, and the number of its pictures. */
export const drawingClock = { time: 0, drawn: 0 };

const remembered = 120;

export class FrameLoop {
  private waiting: string | null = null;
  private requested = false;
  private drawn = 0;
  private dropped = 0;
  private drawing = 0; // of the clock, at the last frame
  private last = Number.NEGATIVE_INFINITY; // ms, of the last frame
  private readonly times = new Times();
  private readonly drawings = new Times();

  constructor(
    private readonly draw: (text: string) => void,
    private readonly report: (work: Work) => void,
    private readonly pause: () => number = () => 0, // ms, at least, between two frames
  ) {}

  /** Whether a frame is not drawn yet. */
  get isWaiting(): boolean {
    return this.waiting !== null;
  }

  take(text: string): void {
    if (this.waiting !== null) this.dropped += 1;
    this.waiting = text;
    this.request();
  }

  private request(): void {
    if (this.requested) return;
    this.requested = true;
    const wait = this.last + this.pause() - performance.now();
    if (wait > 0) window.setTimeout(() => this.requestPicture(), wait);
    else this.requestPicture();
  }

  private requestPicture(): void {
    window.requestAnimationFrame(() => this.picture());
  }

  private picture(): void {
    this.requested = false;
    const text = this.waiting;
    this.waiting = null;
    if (text === null) return;
    const [begin, drawing] = [performance.now(), drawingClock.time];
    this.last = begin;
    this.draw(text);
    const own = performance.now() - begin - (drawingClock.time - drawing);
    this.count(own, drawingClock.time - this.drawing);
    this.drawing = drawingClock.time;
  }

  private count(time: number, drawing: number): void {
    this.drawn += 1;
    this.times.add(time);
    this.drawings.add(drawing);
    const { drawn, dropped, times, drawings } = this;
    this.report({ drawn, dropped, usual: times.middle, most: times.most, drawing: drawings.middle });
  }
}

/** The newest of several times. */
class Times {
  private readonly all: number[] = [];

  add(time: number): void {
    this.all.push(time);
    if (this.all.length > remembered) this.all.shift();
  }

  get middle(): number {
    return [...this.all].sort((a, b) => a - b)[Math.floor(this.all.length / 2)] ?? 0;
  }

  get most(): number {
    return Math.max(...this.all);
  }
}
