// The exploration whose sensor readings are shown, and the time in it: its figures follow both, and
// it plays as fast as it was recorded.

import type { MomentChannel, MomentData } from "../page/unpacked";

export function momentTime(of: MomentChannel): number {
  return of.time ?? (of.rate > 0 ? of.frame / of.rate : (of.times.at(-1) ?? 0));
}

/** The frame of the time series nearest to `time`. */
export function frameAt(of: MomentChannel, time: number): number {
  const away = of.times.map((one) => Math.abs(one - time));
  return Math.max(0, away.indexOf(Math.min(...away)));
}

export class Exploration {
  time: number;
  private isPlaying = false;
  private readonly listeners: (() => void)[] = [];

  constructor(
    readonly moment: MomentData,
    readonly name: string,
  ) {
    this.time = Math.max(0, ...this.moment.channels.slice(0, 1).map(momentTime));
    const touch = moment.channels.find(({ channel }) => channel.name === "touch");
    if (touch) this.time = momentTime(touch);
  }

  get times(): [from: number, to: number] {
    const all = this.moment.channels.flatMap(({ times }) => [times[0] ?? 0, times.at(-1) ?? 0]);
    return [Math.min(...all), Math.max(...all)];
  }

  get plays(): boolean {
    return this.isPlaying;
  }

  setTime(time: number): void {
    this.time = time;
    this.listeners.forEach((listener) => listener());
  }

  playFromStart(): void {
    this.setTime(this.times[0]);
    this.play();
  }

  /** From the beginning if the end is reached; plays until it is stopped, or until the end. */
  play(): void {
    const [from, to] = this.times;
    if (this.isPlaying || to <= from) return;
    this.isPlaying = true;
    const begun = this.time >= to ? from : this.time;
    let first: number | null = null;
    const step = (now: number) => {
      if (!this.isPlaying) return;
      first ??= now;
      const time = Math.min(to, begun + (now - first) / 1000);
      this.isPlaying = time < to;
      this.setTime(time);
      if (this.isPlaying) requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
  }

  stop(): void {
    this.isPlaying = false;
    this.setTime(this.time);
  }

  listen(listener: () => void): void {
    this.listeners.push(listener);
  }
}
