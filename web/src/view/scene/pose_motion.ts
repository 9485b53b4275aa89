// The poses between two frames: frames come several times per second, the screen is drawn more
// often. Bodies move from the poses that are shown to those of the newest frame in the time that
// passes between frames, but at once for the eye, because the skin shows the newest frame already; they
// jump if the frame is not one that follows.

import type { NumberOrNull } from "../../parts/data";
import type { Frame } from "../data";

const kLongest = 400; // ms, of a movement
const kTogether = 100; // ms, within which what is seen seems to happen at once
const kNext = 60; // frames: more is a jump
const kPoseLength = 7; // x, y, z, and the quaternion w, x, y, z

type Moment = Pick<Frame, "exploration" | "frame" | "poses">;

export class PoseMotion {
  private from: readonly NumberOrNull[] = [];
  private to: readonly NumberOrNull[] = [];
  private last: Moment | null = null;
  private begun = 0;
  private lasting = 0;

  /** `longest`: ms; with 0, bodies jump. */
  constructor(private readonly longest = kLongest) {}

  /** A new frame; `now` in ms. */
  take(moment: Moment, now: number): void {
    if (moment === this.last) return; // it is drawn again
    const follows = this.last !== null && isNext(this.last, moment) && this.to.length === moment.poses.length;
    this.from = follows ? this.at(now) : moment.poses;
    this.lasting = follows ? Math.min(this.longest, now - this.begun) : 0;
    this.to = moment.poses;
    this.begun = now;
    this.last = moment;
  }

  /** Until the next frame is expected: the budget of drawing counts the pictures of this time. */
  isMoving(now: number): boolean {
    return now < this.begun + this.lasting && this.from !== this.to;
  }

  at(now: number): readonly NumberOrNull[] {
    const lasting = Math.min(kTogether, this.lasting);
    const share = lasting > 0 ? (now - this.begun) / lasting : 1;
    return share >= 1 ? this.to : mixed(this.from, this.to, Math.max(0, share));
  }
}

function isNext(before: Moment, after: Moment): boolean {
  const frames = after.frame - before.frame;
  return before.exploration === after.exploration && frames >= 0 && frames <= kNext;
}

/** Quaternions are mixed linearly and normalized: they are near each other. */
function mixed(from: readonly NumberOrNull[], to: readonly NumberOrNull[], share: number): number[] {
  const all = to.map((end, i) => {
    const start = from[i] ?? 0;
    const isTurn = i % kPoseLength >= 3;
    return start + share * (sign(from, to, isTurn ? i : -1) * (end ?? 0) - start);
  });
  for (let turn = 3; turn + 4 <= all.length; turn += kPoseLength) normalize(all, turn);
  return all;
}

/** A quaternion and its negative are one rotation: the nearer one is used. */
function sign(from: readonly NumberOrNull[], to: readonly NumberOrNull[], at: number): 1 | -1 {
  if (at < 0) return 1;
  const turn = at - (at % kPoseLength) + 3;
  let product = 0;
  for (let i = turn; i < turn + 4; i += 1) product += (from[i] ?? 0) * (to[i] ?? 0);
  return product < 0 ? -1 : 1;
}

function normalize(values: number[], at: number): void {
  const [w, x, y, z] = values.slice(at, at + 4) as [number, number, number, number];
  const length = Math.hypot(w, x, y, z) || 1;
  for (let i = at; i < at + 4; i += 1) values[i] = values[i]! / length;
}
