// Draws the values of a module on a canvas.

import { divergingColour, sequenceColour } from "../../parts/maps/colour_maps";
import type { NumberOrNull } from "../../parts/data";
import { paintPixels, pixelRamp } from "../../parts/maps/painter";
import { themeColour } from "../page/theme_colours";

const sequence = pixelRamp(sequenceColour);
const diverging = pixelRamp(divergingColour);

export function drawBars(
  context: CanvasRenderingContext2D,
  values: readonly NumberOrNull[],
  ratio: number,
): void {
  const { width, height } = context.canvas;
  const drawn = values.map((value) => value ?? 0);
  const low = Math.min(0, ...drawn);
  const high = Math.max(0, ...drawn, low + 1e-9);
  const y = (value: number) => ((high - value) / (high - low)) * (height - 2) + 1;
  const step = width / Math.max(1, values.length);
  const bar = Math.max(1, Math.min(step - ratio, 26 * ratio));
  context.fillStyle = themeColour("accent");
  drawn.forEach((value, i) =>
    context.fillRect(i * step + (step - bar) / 2, Math.min(y(value), y(0)), bar, Math.abs(y(value) - y(0))),
  );
  context.fillStyle = themeColour("line-strong");
  context.fillRect(0, Math.round(y(0)), width, 1);
}

/** Where several values share a column of pixels, the line covers their range. */
export function drawLine(context: CanvasRenderingContext2D, values: readonly NumberOrNull[]): void {
  const { width, height } = context.canvas;
  const known = values.filter((value) => value !== null);
  const low = Math.min(0, ...known);
  const high = Math.max(...known, low + 1e-9);
  const y = (value: number) => ((high - value) / (high - low)) * (height - 3) + 1.5;
  context.strokeStyle = themeColour("line-strong");
  context.beginPath();
  context.moveTo(0, y(0));
  context.lineTo(width, y(0));
  context.stroke();
  context.strokeStyle = themeColour("accent");
  context.lineWidth = Math.max(1, width / 500);
  context.beginPath();
  values.forEach((value, i) => {
    const x = (i / Math.max(1, values.length - 1)) * width;
    if (value === null) return;
    if ((values[i - 1] ?? null) === null) context.moveTo(x, y(value));
    context.lineTo(x, y(value));
  });
  context.stroke();
}

export function drawCells(
  context: CanvasRenderingContext2D,
  picture: HTMLCanvasElement,
  values: readonly NumberOrNull[],
  shape: readonly number[],
): void {
  const [rows, columns] = arrangement(values.length, shape, context.canvas);
  const colour = colourFor(values);
  paintPixels(picture, columns, rows, (x, y) => colour(values[y * columns + x]));
  context.imageSmoothingEnabled = columns > context.canvas.width || rows > context.canvas.height;
  context.drawImage(picture, 0, 0, context.canvas.width, context.canvas.height);
}

/** The rows and columns of the module; a single long row is wrapped. */
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

function colourFor(values: readonly NumberOrNull[]): (value: NumberOrNull | undefined) => number | null {
  const most = values.reduce<number>((best, value) => Math.max(best, Math.abs(value ?? 0) || 0), 1e-12);
  const both = values.some((value) => (value ?? 0) < 0);
  return (value) => {
    if (value === undefined || value === null) return null;
    return both ? diverging(0.5 + value / most / 2) : sequence(value / most);
  };
}
