// The values over one exploration, moment by moment, for the strips over time: the history from the
// program, and the frames received since.

import type { NumberOrNull } from "../../parts/data";
import type { Frame, Strips } from "../data";

const kMost = 2000; // moments: a strip has fewer pixels, and a body may explore for days
const kMissing = 1; // s without frames, after which the program's history is requested again

export type Moment = Pick<Frame, "frame" | "time" | "channels">;

export class History {
  private exploration = -1;
  private frames: number | null = null; // of the exploration
  private moments: Moment[] = [];
  /** Whether the earlier history must still be requested from the program. */
  isLacking = true;
  /** Whether the whole exploration is included, and not only the received frames. */
  isWhole = false;
  /** The number of times that it has begun anew. */
  beginnings = 0;
  /** A number that changes with the content. */
  version = 0;

  get times(): number[] {
    return this.moments.map(({ time }) => time);
  }

  get end(): number {
    return this.moments.at(-1)?.time ?? 0;
  }

  /** The values of a channel at each moment; [] if it has none. */
  rows(channel: string): readonly (readonly NumberOrNull[])[] {
    return this.moments.map(({ channels }) => channels[channel] ?? []);
  }

  add({ exploration, frames, frame, time, channels }: Frame): void {
    const begunAnew = frames === null && this.differs({ frame, time, channels });
    if (exploration !== this.exploration || frames !== this.frames || begunAnew) this.clear();
    this.exploration = exploration;
    this.frames = frames;
    if (this.isWhole) return;
    if (this.misses({ frame, time })) this.isLacking = true;
    this.insert({ frame, time, channels });
  }

  /** The values of a channel at a time; null before the first moment. */
  at(time: number, channel: string): readonly NumberOrNull[] | null {
    let place = this.moments.length - 1;
    while (place >= 0 && this.moments[place]!.time > time + 1e-9) place -= 1;
    return this.moments[place]?.channels[channel] ?? null;
  }

  /**
   * Adds the history from the program; false if it belongs to another exploration. It may have been on
   * its way while frames were missed: then it is still lacking.
   */
  take(strips: Strips): boolean {
    if (strips.exploration !== this.exploration || strips.frames !== this.frames) return false;
    const seen = this.moments;
    this.moments = momentsOf(strips);
    this.isWhole = strips.frames !== null;
    const later = seen.find(({ frame }) => frame > (this.moments.at(-1)?.frame ?? frame));
    this.isLacking = !this.isWhole && later !== undefined && this.misses(later);
    this.version += 1;
    if (!this.isWhole) seen.forEach((moment) => this.insert(moment));
    return true;
  }

  /** Uses only the received frames, without the program's history. */
  doWithout(): void {
    this.isLacking = false;
  }

  clear(): void {
    this.moments = [];
    this.isLacking = true;
    this.isWhole = false;
    this.beginnings += 1;
    this.version += 1;
  }

  /** Whether frames were not received, as while the page was hidden. */
  private misses({ frame, time }: Pick<Moment, "frame" | "time">): boolean {
    const last = this.moments.at(-1);
    return last !== undefined && frame > last.frame + 1 && time - last.time > kMissing;
  }

  /** Whether an earlier frame was another one: the body explores anew under the same number. */
  private differs({ frame, time, channels }: Moment): boolean {
    if (frame >= (this.moments.at(-1)?.frame ?? 0)) return false;
    const known = this.moments[this.place(frame)];
    if (known?.frame !== frame) return false;
    const differ = ([name, values]: [string, readonly NumberOrNull[]]) =>
      String(values) !== String(channels[name]);
    return known.time !== time || Object.entries(known.channels).some(differ);
  }

  private insert(moment: Moment): void {
    const place = this.place(moment.frame);
    // Between grasps the last frame is sent again, with values that are not recorded.
    if (this.moments[place]?.frame === moment.frame) return;
    this.moments.splice(place, 0, moment);
    if (this.moments.length > kMost) this.thin();
    this.version += 1;
  }

  /** Half of the moments remain, evenly spaced over the exploration, and the last one. */
  private thin(): void {
    const [first, last] = [this.moments[0]!, this.moments.at(-1)!];
    const spacing = (2 * (last.frame - first.frame)) / kMost;
    let kept = Number.NEGATIVE_INFINITY;
    this.moments = this.moments.filter((moment) => {
      if (moment !== last && moment.frame - kept < spacing) return false;
      kept = moment.frame;
      return true;
    });
  }

  /** The position of the frame in the history, nearly always the end. */
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
