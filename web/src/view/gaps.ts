// Frames that were dropped in between do not make a gap in a strip; a jump does.

const kShare = 0.06; // of the whole that may be missing,
const kTime = 1.5; // or s

/** Whether between the frames `at` and `at` + 1 of `times` nobody has looked; `end` is the whole. */
export function isGap(times: readonly number[], at: number, end: number): boolean {
  const [before, after] = [times[at], times[at + 1]];
  return before !== undefined && after !== undefined && after - before > Math.max(kTime, kShare * end);
}
