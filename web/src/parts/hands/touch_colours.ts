// The scale of touch and its colours: grey at rest; above a threshold from orange to bright yellow,
// so that what is touched stands out. A larger mark is the second sign besides the colour.

import { between, hex, type Colour } from "../maps/colour_maps";

/** Share of the scale from which a sensor counts as touched. */
export const kTouched = 0.04;

export const kRest: Colour = [0x9a, 0xa1, 0xa6];

const kLit: readonly Colour[] = [
  [0xe8, 0x6a, 0x10],
  [0xff, 0x9d, 0x1c],
  [0xff, 0xc9, 0x2e],
  [0xff, 0xf0, 0x6a],
];

export function isTouched(share: number): boolean {
  return share >= kTouched;
}

/** The colour of a share of the scale, 0 to 1. */
export function touchColour(share: number): string {
  return hex(isTouched(share) ? between(kLit, (share - kTouched) / (1 - kTouched)) : kRest);
}

const kLeast: Record<string, number | undefined> = { N: 1 };
const kShare = 0.9; // of the touched sensors
const kNoise = 0.02; // of the strongest: a sensor below is not touched

/** The end of the scale for the strongest touch of each sensor: a round number that nine of ten
 * touched sensors do not exceed, so that one sensor does not darken all others. Noise is not touch,
 * so that the end has a minimum for known units. */
export function touchEnd(most: readonly number[], unit: string): number {
  return roundNumber(Math.max(usual(most), kLeast[unit] ?? 0));
}

/** The maximum of nine of ten of the touched sensors. */
function usual(most: readonly number[]): number {
  const strongest = Math.max(0, ...most.filter((one) => one > 0));
  const touched = most.filter((one) => one > kNoise * strongest).sort((a, b) => a - b);
  return touched[Math.ceil(kShare * touched.length) - 1] ?? 0;
}

/** 1, 1.5, 2, 3, 4, 5, 6 or 8 times a power of ten, not below `value`; 1 for nothing. */
export function roundNumber(value: number): number {
  if (!(value > 0) || !Number.isFinite(value)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const times = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((digit) => digit * power >= value * (1 - 1e-9)) ?? 10;
  return Number((times * power).toPrecision(3));
}
