// Draws the values of a module on a canvas.

import { divergingColour, sequenceColour } from "../parts/colour_maps";
import { pixelColours, type Pixels } from "./pixels";
import { themeColour } from "./theme_colours";

const sequence = pixelColours(sequenceColour);
const diverging = pixelColours(divergingColour);

export function drawBars(context: CanvasRenderingContext2D, values: readonly number[], ratio: number): void {
  const { width, height } = context.canvas;
  const low = Math.min(0, ...values);
  const high = Math.max(0, ...values, low + 1e-9);
  const y = (value: number) => ((high - value) / (high - low)) * (height - 2) + 1;
  const step = width / Math.max(1, values.length);
  const bar = Math.max(1, Math.min(step - ratio, 26 * ratio));
  context.fillStyle = themeColour("accent");
  values.forEach((value, i) =>
    context.fillRect(i * step + (step - bar) / 2, Math.min(y(value), y(0)), bar, Math.abs(y(value) - y(0))),
  );
  context.fillStyle = themeColour("line-strong");
  context.fillRect(0, Math.round(y(0)), width, 1);
}

export function drawCells(
  context: CanvasRenderingContext2D,
  picture: Pixels,
  values: readonly number[],
  shape: readonly number[],
): void {
  const [rows, columns] = arrangement(values.length, shape, context.canvas);
  picture.paint(columns, rows, (pixels) => colour(pixels, values));
  context.imageSmoothingEnabled = columns > context.canvas.width || rows > context.canvas.height;
  context.drawImage(picture.canvas, 0, 0, context.canvas.width, context.canvas.height);
}

/** Its own rows and columns; one long row is broken to fill the place. */
function arrangement(
  count: number,
  shape: readonly number[],
  { width, height }: HTMLCanvasElement,
): [number, number] {
  const long = shape.filter((size) => size > 1);
  if (long.length >= 2) return [count / long.at(-1)!, long.at(-1)!];
  const columns = Math.min(count, Math.max(1, Math.round(Math.sqrt((count * width) / height))));
  return [Math.ceil(count / columns), columns];
}

function colour(pixels: Uint32Array, values: readonly number[]): void {
  const most = values.reduce((best, value) => Math.max(best, Math.abs(value) || 0), 1e-12);
  const both = values.some((value) => value < 0);
  values.forEach((value, i) => {
    pixels[i] = both ? diverging(0.5 + value / most / 2) : sequence(value / most);
  });
}
