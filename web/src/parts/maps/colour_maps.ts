// Colours for numbers and classes that can be distinguished with colour vision deficiency.
//
//   sequenceColour(share)   0 dark blue to 1 light yellow: lightness rises evenly
//   divergingColour(share)  0 blue, 0.5 light grey, 1 brown: for numbers on both sides of a centre
//   classColour(number)     a CSS colour that goes with the theme, for SVG and HTML
//   classHex(number)        the same as "#rrggbb" in the light theme, for WebGL
//
// Sequence and classes are those of src/maps/svg/colours.cc, so that pictures agree.

export type Colour = readonly [number, number, number]; // 0 to 255

export const kSequence: readonly Colour[] = [
  [0x0f, 0x1c, 0x54],
  [0x17, 0x38, 0x61],
  [0x23, 0x53, 0x6b],
  [0x36, 0x6f, 0x73],
  [0x52, 0x8a, 0x7a],
  [0x76, 0xa5, 0x80],
  [0xa0, 0xbf, 0x85],
  [0xd0, 0xd7, 0x89],
  [0xff, 0xef, 0x8c],
];

// Lightness rises to the middle and falls again in even steps; blue and brown are distinguishable
// with colour vision deficiency.
const kDiverging: readonly Colour[] = [
  [0x0b, 0x3c, 0x6f],
  [0x2f, 0x68, 0x9c],
  [0x6f, 0x9c, 0xc4],
  [0xb3, 0xcb, 0xde],
  [0xf0, 0xee, 0xea],
  [0xe0, 0xc1, 0x9b],
  [0xc3, 0x8d, 0x53],
  [0x96, 0x5a, 0x20],
  [0x62, 0x31, 0x05],
];

const kClasses = ["#0072b2", "#e69f00", "#009e73", "#d55e00", "#56b4e9", "#cc79a7", "#f0e442", "#000000"];

export const kClassColours = kClasses.length;

export function sequenceColour(share: number): string {
  return hex(between(kSequence, share));
}

export function divergingColour(share: number): string {
  return hex(between(kDiverging, share));
}

export function classColour(number: number): string {
  return `var(--class-${number % kClasses.length})`;
}

export function classHex(number: number): string {
  return kClasses[number % kClasses.length] ?? "#000000";
}

/** The colour at `share` of the way through a table; shares outside 0 to 1 count as the ends. */
export function between(table: readonly Colour[], share: number): Colour {
  const place = Math.min(1, Math.max(0, share || 0)) * (table.length - 1);
  const from = table[Math.floor(place)] ?? table[0]!;
  const to = table[Math.ceil(place)] ?? from;
  const rest = place - Math.floor(place);
  const mixed = (i: 0 | 1 | 2) => Math.round(from[i] + (to[i] - from[i]) * rest);
  return [mixed(0), mixed(1), mixed(2)];
}

export function hex(colour: Colour): string {
  return `#${colour.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
}

export function parsed(text: string): Colour {
  const part = (at: number) => Number.parseInt(text.slice(at, at + 2), 16);
  return [part(1), part(3), part(5)];
}

/** Lightness as CIELAB has it, 0 to 100. */
export function lightness([red, green, blue]: Colour): number {
  const luminance = 0.2126 * linear(red) + 0.7152 * linear(green) + 0.0722 * linear(blue);
  return luminance <= 216 / 24389 ? (luminance * 24389) / 27 : 116 * Math.cbrt(luminance) - 16;
}

function linear(part: number): number {
  const value = part / 255;
  return value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
}
