// The frames of one exploration that have been seen, in their order, for the strips over time.

import type { Frame } from "./data";

export class History {
  private exploration = -1;
  private readonly frames: Frame[] = [];

  get times(): number[] {
    return this.frames.map((frame) => frame.time);
  }

  /** Of each frame seen the values of a channel; [] where it has none. */
  rows(channel: string): readonly (readonly number[])[] {
    return this.frames.map((frame) => frame.channels[channel] ?? []);
  }

  add(frame: Frame): void {
    if (frame.exploration !== this.exploration) this.clear();
    this.exploration = frame.exploration;
    const place = this.place(frame.frame);
    const known = this.frames[place]?.frame === frame.frame ? 1 : 0;
    // Modules and maps are not kept: they are large.
    this.frames.splice(place, known, { ...frame, modules: {}, maps: {}, poses: [] });
  }

  clear(): void {
    this.frames.length = 0;
  }

  /** Where the frame stands or would stand; nearly always at the end. */
  private place(frame: number): number {
    let place = this.frames.length;
    while (place > 0 && (this.frames[place - 1]?.frame ?? -1) >= frame) place -= 1;
    return place;
  }
}
