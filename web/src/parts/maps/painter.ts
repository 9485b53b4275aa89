// Paints values in colours: as cells of an SVG picture, of which only those that change are touched,
// or as pixels of a small canvas that is stretched over its place.
//
//   const paint = painter(cells, sequenceColour);
//   paint(values, low, high);
//
//   const colour = scaled(pixelRamp(sequenceColour), low, high);
//   const image = pixelImage(box, columns, rows, (x, y) => colour(values[y]?.[x]));

import { hex, parsed, type Colour } from "./colour_maps";
import { rounded, shape, type Box } from "../svg";

type Value = number | null | undefined;

/** The results of `made` for 0 to 1, made once for `steps` equal steps; shares outside count as the ends. */
export function ramp<T>(made: (share: number) => T, steps: number): (share: number) => T {
  const table = Array.from({ length: steps + 1 }, (_, step) => made(step / steps));
  return (share) => table[Math.round(Math.min(1, Math.max(0, share || 0)) * steps)]!;
}

/** Maps a value between `low` and `high` to `made` of its share of that range; null for a missing value. */
export function scaled<T>(made: (share: number) => T, low: number, high: number): (value: Value) => T | null {
  const scale = high > low ? 1 / (high - low) : 0;
  return (value) => {
    const share = ((value ?? Number.NaN) - low) * scale;
    return Number.isFinite(share) ? made(share) : null;
  };
}

// A change of less than a step is not drawn.
const kCellSteps = 128;

export type Paint = (values: readonly Value[], low: number, high: number) => void;

export function painter(cells: readonly SVGPathElement[], colour: (share: number) => string): Paint {
  const colours = ramp(colour, kCellSteps);
  const painted: string[] = [];
  return (values, low, high) => {
    const fillOf = scaled(colours, low, high);
    cells.forEach((cell, i) => {
      const fill = fillOf(values[i]) ?? "none";
      if (painted[i] === fill) return;
      painted[i] = fill;
      cell.setAttribute("fill", fill);
    });
  };
}

const kPixelSteps = 255;

/** Maps 0 to 1 to the value of a pixel. */
export function pixelRamp(colour: (share: number) => string, steps = kPixelSteps): (share: number) => number {
  return ramp((share) => pixel(parsed(colour(share))), steps);
}

/** Opaque, as the bytes red, green, blue and opacity of image data on little-endian machines. */
export function pixel([red, green, blue]: Colour): number {
  return (0xff000000 | (blue << 16) | (green << 8) | red) >>> 0;
}

/** The pixel in column x of row y; null is transparent. */
export type PixelAt = (x: number, y: number) => number | null;

/** The pixels row after row. */
export function pixelsOf(columns: number, rows: number, at: PixelAt): Uint32Array<ArrayBuffer> {
  const pixels = new Uint32Array(columns * rows);
  for (let y = 0; y < rows; y += 1)
    for (let x = 0; x < columns; x += 1) pixels[y * columns + x] = at(x, y) ?? 0;
  return pixels;
}

export function paintPixels(canvas: HTMLCanvasElement, columns: number, rows: number, at: PixelAt): void {
  const context = canvas.getContext("2d");
  if (context === null || columns === 0 || rows === 0) return;
  canvas.width = columns;
  canvas.height = rows;
  const bytes = new Uint8ClampedArray(pixelsOf(columns, rows, at).buffer);
  context.putImageData(new ImageData(bytes, columns, rows), 0, 0);
}

export interface Pixels {
  box: Box;
  columns: number;
  rows: number;
  at: PixelAt;
}

const drawn = new WeakMap<Element, Pixels>();

/** The pixels as a part of a picture, stretched over `box`. */
export function pixelImage(box: Box, columns: number, rows: number, at: PixelAt): SVGImageElement {
  const canvas = document.createElement("canvas");
  paintPixels(canvas, columns, rows, at);
  const href = canvas.toDataURL("image/png");
  const crisp = { preserveAspectRatio: "none", "image-rendering": "pixelated" };
  const image = shape("image", { ...box, href, ...crisp });
  drawn.set(image, { box, columns, rows, at });
  return image;
}

/** The pixels that pixelImage() drew as rectangles: a path for each colour, because viewers smooth images. */
export function pixelPaths(image: Element): SVGGElement | null {
  const pixels = drawn.get(image);
  if (!pixels) return null;
  const paths = [...outlines(pixels)].map(([value, d]) => shape("path", { d, fill: cssOf(value) }));
  return shape("g", { "shape-rendering": "crispEdges" }, paths);
}

/** For each value of a pixel the outlines of its runs in rows. */
function outlines({ box, columns, rows, at }: Pixels): Map<number, string> {
  const found = new Map<number, string>();
  const x = (column: number) => rounded(box.x + (column * box.width) / columns);
  const y = (row: number) => rounded(box.y + (row * box.height) / rows);
  for (let row = 0; row < rows; row += 1) {
    for (let from = 0, to = 0; from < columns; from = to) {
      const value = at(from, row);
      for (to = from + 1; to < columns && at(to, row) === value; ) to += 1;
      if (value === null) continue;
      const d = `M${x(from)} ${y(row)}H${x(to)}V${y(row + 1)}H${x(from)}Z`;
      found.set(value, (found.get(value) ?? "") + d);
    }
  }
  return found;
}

function cssOf(value: number): string {
  return hex([value & 0xff, (value >> 8) & 0xff, (value >> 16) & 0xff]);
}
