// The time of a moment of an exploration.

import type { MomentChannel } from "./data";

export function momentTime(of: MomentChannel): number {
  return of.time ?? (of.rate > 0 ? of.frame / of.rate : (of.times.at(-1) ?? 0));
}

/** The frame of the time series nearest to the moment. */
export function momentIndex(of: MomentChannel): number {
  const away = of.times.map((time) => Math.abs(time - momentTime(of)));
  return Math.max(0, away.indexOf(Math.min(...away)));
}
