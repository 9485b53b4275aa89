// What has been told over one exploration, moment by moment, for the strips over time: what the program
// knew when it was asked, and the frames that were seen since.

import type { Frame, Strips } from "./data";

export type Moment = Pick<Frame, "frame" | "time" | "channels">;

export class History {
  private exploration = -1;
  private frames: number | null = null; // of the exploration
  private moments: Moment[] = [];
  /** Whether the program still has to be asked what came before anybody looked. */
  isLacking = true;
  /** Whether all of the exploration is in it, and not only what was seen. */
  isWhole = false;
  /** Another whenever what is in it has changed. */
  version = 0;

  get times(): number[] {
    return this.moments.map(({ time }) => time);
  }

  get end(): number {
    return this.moments.at(-1)?.time ?? 0;
  }

  /** Of each moment the values of a channel; [] where it has none. */
  rows(channel: string): readonly (readonly number[])[] {
    return this.moments.map(({ channels }) => channels[channel] ?? []);
  }

  add({ exploration, frames, frame, time, channels }: Frame): void {
    // A body never goes back: it has begun anew.
    const begunAnew = frames === null && frame < (this.moments.at(-1)?.frame ?? 0);
    if (exploration !== this.exploration || frames !== this.frames || begunAnew) this.clear();
    this.exploration = exploration;
    this.frames = frames;
    if (!this.isWhole) this.insert({ frame, time, channels });
  }

  /** What the program knows; false where that is another exploration. */
  take(strips: Strips): boolean {
    if (strips.exploration !== this.exploration || strips.frames !== this.frames) return false;
    const seen = this.moments;
    this.moments = momentsOf(strips);
    this.isLacking = false;
    this.isWhole = strips.frames !== null;
    this.version += 1;
    if (!this.isWhole) seen.forEach((moment) => this.insert(moment));
    return true;
  }

  /** Whatever the program knows, what is seen has to do. */
  doWithout(): void {
    this.isLacking = false;
  }

  clear(): void {
    this.moments = [];
    this.isLacking = true;
    this.isWhole = false;
    this.version += 1;
  }

  private insert(moment: Moment): void {
    const place = this.place(moment.frame);
    // Between grasps the last frame is told again, with what is not recorded.
    if (this.moments[place]?.frame === moment.frame) return;
    this.moments.splice(place, 0, moment);
    this.version += 1;
  }

  /** Where the frame stands or would stand; nearly always at the end. */
  private place(frame: number): number {
    let place = this.moments.length;
    while (place > 0 && (this.moments[place - 1]?.frame ?? -1) >= frame) place -= 1;
    return place;
  }
}

function momentsOf(strips: Strips): Moment[] {
  const channels = Object.entries(strips.channels);
  return strips.frame.map((frame, i) => ({
    frame,
    time: strips.time[i] ?? 0,
    channels: Object.fromEntries(channels.map(([name, values]) => [name, values[i] ?? []])),
  }));
}
