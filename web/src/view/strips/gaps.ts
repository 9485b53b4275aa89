// Frames that were dropped in between do not make a gap in a strip; a jump does, and a pause in which
// nothing was recorded.

import type { History } from "./history";

const kShare = 0.06; // of the whole that may be missing,
const kTime = 1.5; // or s
const kUsual = 4; // or so many times the usual step, where all is known

/** Whether there is a gap between the moments `at` and `at` + 1; `end` is the total duration. */
export function gapsOf(history: History, end: number): (at: number) => boolean {
  const { times } = history;
  const usual = history.isWhole ? history.end / Math.max(1, times.length - 1) : 0;
  const most = Math.max(kTime, kShare * end, kUsual * usual);
  return (at) => (times[at + 1] ?? 0) - (times[at] ?? 0) > most;
}
