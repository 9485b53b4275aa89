// Draws the newest of what has come, once for each picture of the browser, and counts what came in
// between and was dropped. Nothing is drawn while nobody sees it, since the browser then asks for no
// pictures.

export interface Work {
  drawn: number;
  dropped: number;
  last: number; // ms, of the page's own work for the last frame
  usual: number; // ms, the middle of the last `remembered` frames
  most: number; // ms, of those
}

const remembered = 120;

export class FrameLoop {
  private waiting: string | null = null;
  private asked = false;
  private drawn = 0;
  private dropped = 0;
  private readonly times: number[] = [];

  constructor(
    private readonly draw: (text: string) => void,
    private readonly tell: (work: Work) => void,
  ) {}

  take(text: string): void {
    if (this.waiting !== null) this.dropped += 1;
    this.waiting = text;
    this.ask();
  }

  private ask(): void {
    if (this.asked) return;
    this.asked = true;
    window.requestAnimationFrame(() => this.picture());
  }

  private picture(): void {
    this.asked = false;
    const text = this.waiting;
    this.waiting = null;
    if (text === null) return;
    const begin = performance.now();
    this.draw(text);
    this.count(performance.now() - begin);
  }

  private count(time: number): void {
    this.drawn += 1;
    this.times.push(time);
    if (this.times.length > remembered) this.times.shift();
    const sorted = [...this.times].sort((a, b) => a - b);
    const usual = sorted[Math.floor(sorted.length / 2)] ?? time;
    this.tell({ drawn: this.drawn, dropped: this.dropped, last: time, usual, most: sorted.at(-1) ?? time });
  }
}
