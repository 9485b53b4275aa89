// Colours of touch: grey at rest; above a threshold from orange to bright yellow, so that what is
// touched stands out. A larger mark is the second sign besides the colour.

import { between, hex, type Colour } from "./colour_maps";

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
