// Positions of the elements of a channel on an unfolded hand, derived from their names:
// "finger1_proximal_3" is the third element of the proximal segment of finger1. Fingers are side
// by side, distal above proximal, elements in rows as in models/lucs_haptic_hand_2.xml and _3.xml
// (the lower the number, the nearer to the palm). Lengths are in distances between elements.

import type { Box } from "../svg";

export interface HandLayout {
  kind: "hand" | "placed" | "grid"; // "placed": by a layout file (skin_layout.ts)
  width: number;
  height: number;
  dots: { x: number; y: number }[]; // by element
  segments: (Box & { name: string })[]; // or groups
  fingers: { name: string; x: number; y: number }[]; // where the names stand
  background?: (Box & { image: string }) | undefined;
}

interface Part {
  finger: string;
  segment: string;
  number: number;
  element: number;
}

const kSegments = ["proximal", "middle", "distal", "tip"];
const kPad = 0.28;
const kBetweenSegments = 0.2;
const kBetweenFingers = 0.75;

/** Null if the names do not describe a hand. */
export function handLayout(elements: readonly string[]): HandLayout | null {
  const parts = elements.map(partOf);
  if (elements.length < 2 || parts.some((part) => part === null)) return null;
  return laidOut(
    parts.filter((part) => part !== null),
    elements.length,
  );
}

/** Consecutive elements of one finger, such as the rows of a table of all elements; [] if they are of no hand. */
export function fingerRuns(elements: readonly string[]): { name: string; from: number; to: number }[] {
  if (handLayout(elements) === null) return [];
  const runs: { name: string; from: number; to: number }[] = [];
  elements.forEach((element, i) => {
    const name = partOf(element, i)?.finger ?? "";
    const last = runs.at(-1);
    if (last?.name === name) last.to = i + 1;
    else runs.push({ name, from: i, to: i + 1 });
  });
  return runs;
}

function partOf(name: string, element: number): Part | null {
  const match = /^(?:taxel_)?(.+)_(proximal|middle|distal|tip)(?:_(\d+))?$/.exec(name);
  if (!match) return null;
  return { finger: match[1] ?? "", segment: match[2] ?? "", number: Number(match[3] ?? 1), element };
}

function laidOut(parts: Part[], count: number): HandLayout {
  const layout: HandLayout = { kind: "hand", width: 0, height: 0, dots: new Array(count), segments: [], fingers: [] };
  const tallest = Math.max(...fingersOf(parts).map((finger) => heightOf(segmentsOf(parts, finger))));
  let x = 0;
  for (const finger of fingersOf(parts)) {
    const segments = segmentsOf(parts, finger);
    const width = Math.max(...segments.map((segment) => widthOf(segment.rows))) + 2 * kPad;
    placeFinger(layout, segments, x, width, tallest);
    layout.fingers.push({ name: finger, x: x + width / 2, y: tallest });
    x += width + kBetweenFingers;
  }
  return { ...layout, width: x - kBetweenFingers, height: tallest };
}

interface Segment {
  name: string;
  rows: Part[][];
}

/** Sorted by name, with the thumb first. */
function fingersOf(parts: Part[]): string[] {
  const names = [...new Set(parts.map((part) => part.finger))];
  return [...names.filter((name) => name === "thumb"), ...names.filter((name) => name !== "thumb")];
}

function segmentsOf(parts: Part[], finger: string): Segment[] {
  const own = parts.filter((part) => part.finger === finger);
  const names = kSegments.filter((name) => own.some((part) => part.segment === name));
  return names.map((name) => ({
    name,
    rows: rowsOf(
      own.filter((part) => part.segment === name),
      name,
    ),
  }));
}

/** From the palm outwards. */
function rowsOf(parts: Part[], segment: string): Part[][] {
  const sorted = [...parts].sort((one, other) => one.number - other.number);
  let from = 0;
  return rowSizes(sorted.length, segment).map((size) => sorted.slice(from, (from += size)));
}

export function rowSizes(count: number, segment: string): number[] {
  if (count === 7) return [2, 3, 2];
  if (count === 8) return [3, 2, 3];
  if (count === 3 && segment === "distal") return [2, 1];
  if (count <= 3) return new Array<number>(count).fill(1);
  const columns = Math.ceil(Math.sqrt(count));
  const rows = Math.ceil(count / columns);
  return Array.from({ length: rows }, (_, row) => Math.floor((count + row) / rows));
}

const widthOf = (rows: Part[][]) => Math.max(...rows.map((row) => row.length));
const segmentHeight = (segment: Segment) => segment.rows.length + 2 * kPad;

function heightOf(segments: Segment[]): number {
  return segments.reduce(
    (sum, segment) => sum + segmentHeight(segment) + kBetweenSegments,
    -kBetweenSegments,
  );
}

function placeFinger(layout: HandLayout, segments: Segment[], x: number, width: number, floor: number): void {
  let bottom = floor;
  for (const segment of segments) {
    const height = segmentHeight(segment);
    layout.segments.push({ name: segment.name, x, y: bottom - height, width, height });
    segment.rows.forEach((row, i) => placeRow(layout, row, x + width / 2, bottom - kPad - i - 0.5));
    bottom -= height + kBetweenSegments;
  }
}

function placeRow(layout: HandLayout, row: Part[], middle: number, y: number): void {
  row.forEach((part, i) => {
    layout.dots[part.element] = { x: middle + i - (row.length - 1) / 2, y };
  });
}
