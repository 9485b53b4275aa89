// Small pictures that are made pixel by pixel, to be stretched over their place.

import { parsed } from "../parts/colour_maps";

const kSteps = 255;

/** A colour of 0 to 1 as a pixel has it. */
export function pixelColours(colour: (share: number) => string): (share: number) => number {
  const table = Array.from({ length: kSteps + 1 }, (_, i) => packed(colour(i / kSteps)));
  return (share) => table[Math.round(Math.min(1, Math.max(0, share || 0)) * kSteps)] ?? 0;
}

function packed(text: string): number {
  const [red, green, blue] = parsed(text);
  return 0xff000000 | (blue << 16) | (green << 8) | red;
}

export class Pixels {
  readonly canvas = document.createElement("canvas");
  private readonly context = this.canvas.getContext("2d");

  /** Anew, row after row, from pixels through which one sees. */
  paint(columns: number, rows: number, colour: (pixels: Uint32Array) => void): void {
    if (this.context === null || columns === 0 || rows === 0) return;
    this.canvas.width = columns;
    this.canvas.height = rows;
    const image = this.context.createImageData(columns, rows);
    colour(new Uint32Array(image.data.buffer));
    this.context.putImageData(image, 0, 0);
  }
}
