// A picture of a matrix, drawn once on a canvas because it may have tens of thousands of elements.

import { element } from "../../parts/dom";
import { sequenceColour } from "../../parts/maps/colour_maps";
import { colourBar } from "../../parts/maps/legend";
import { rangeOf, readable, withUnit } from "../../parts/numbers";
import { pixelImage, pixelRamp, scaled } from "../../parts/maps/painter";
import { rounded, shape, shortened, svg, text, textWidth } from "../../parts/svg";

export interface MatrixPicture {
  element: HTMLElement; // the picture with a line that states the value under the pointer
  svg: SVGSVGElement;
  markRow(row: number): void;
  markColumn(column: number): void;
}

export interface MatrixOptions {
  label: string;
  rowName: string;
  columnName: string;
  unit: string;
  width?: number;
  height?: number;
  rowEnds: [string, string];
  columnEnds: [string, string];
  describe: (row: number, column: number) => string;
  colour?: (share: number) => string;
  range?: readonly [number, number]; // of the colours; that of the values unless said
  bands?: { name: string; from: number; to: number }[]; // consecutive rows with a common name
  onRow?: (row: number) => void;
}

const kLeft = 34;
const kTop = 8;
const kSteps = 256; // of colours

export function matrixPicture(
  values: readonly (readonly (number | null)[])[],
  options: MatrixOptions,
): MatrixPicture {
  const rows = values.length;
  const columns = Math.max(1, ...values.map((row) => row.length));
  const [width, height] = [options.width ?? 460, options.height ?? Math.max(80, Math.min(380, rows * 12))];
  const [low, high] = options.range ?? rangeOf(values.flatMap((row) => rangeOf(row) ?? [])) ?? [0, 1];
  const colours = options.colour ?? sequenceColour;
  const colour = scaled(pixelRamp(colours, kSteps), low, high);
  const box = { x: kLeft, y: kTop, width, height };
  const image = pixelImage(box, columns, Math.max(1, rows), (x, y) => colour(values[y]?.[x]));
  const line = shape("rect", { class: "matrix-mark", "data-transient": "" });
  const bar = colourBar(width, options.unit, colours);
  bar.setRange(low, high);
  bar.group.setAttribute("transform", `translate(${kLeft} ${kTop + height + 34})`);
  const below = kTop + height + 16;
  const words = [
    text(kLeft, below, options.columnEnds[0], { class: "muted" }),
    text(kLeft + width / 2, below, `${options.columnName} →`, { class: "muted middle" }),
    text(kLeft + width, below, options.columnEnds[1], { class: "muted end" }),
    ...(options.bands?.length ? bandsBeside(options.bands, rows, height) : besideRows(options, height)),
  ];
  const frame = shape("rect", { x: kLeft, y: kTop, width, height, class: "rule" });
  const picture = svg(kLeft + width + 6, kTop + height + 66, options.label, [
    image,
    frame,
    line,
    ...words,
    bar.group,
  ]);
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  const cell = (event: MouseEvent) => cellAt(image, rows, columns, event);
  picture.addEventListener("pointermove", (event) => {
    const at = cell(event);
    const value = at && withUnit(readable(values[at.row]?.[at.column]), options.unit);
    readout.textContent = at ? `${options.describe(at.row, at.column)}: ${value}` : "";
  });
  picture.addEventListener("pointerleave", () => (readout.textContent = ""));
  picture.addEventListener("click", (event) => {
    const at = cell(event);
    if (at) options.onRow?.(at.row);
  });
  picture.style.cursor = "crosshair";
  return {
    element: element("div", {}, [picture, readout]),
    svg: picture,
    markRow: (row) => mark(line, rows, row, width, height),
    markColumn: (column) => markColumn(line, columns, column, width, height),
  };
}

const kLetters = 12;

/** The names of the first and last row, and the meaning of rows, if there is space. */
function besideRows({ rowName, rowEnds }: MatrixOptions, height: number): SVGTextElement[] {
  const [first, last] = rowEnds.map((words) => shortened(words, height / 2 - 4, kLetters));
  const between = `← ${rowName}`;
  const longest = Math.max(textWidth(first ?? "", kLetters), textWidth(last ?? "", kLetters));
  const hasRoom = 2 * longest + textWidth(between, kLetters) + 16 < height;
  return [
    sideways(first ?? "", kTop, "end"),
    ...(hasRoom ? [sideways(between, kTop + height / 2, "middle")] : []),
    sideways(last ?? "", kTop + height, ""),
  ];
}

/** Names of the bands, with lines between them. */
function bandsBeside(bands: { name: string; from: number; to: number }[], rows: number, height: number): SVGElement[] {
  const y = (row: number) => kTop + (row * height) / rows;
  return bands.flatMap(({ name, from, to }) => [
    shape("path", { d: `M${kLeft - 24} ${rounded(y(from))}H${kLeft}`, class: "rule" }),
    sideways(shortened(name, y(to) - y(from) - 4, kLetters), (y(from) + y(to)) / 2, "middle"),
  ]);
}

function sideways(words: string, y: number, anchor: string): SVGTextElement {
  return text(0, 0, words, {
    class: `muted ${anchor}`,
    transform: `translate(${kLeft - 9} ${rounded(y)}) rotate(-90)`,
  });
}

function mark(line: SVGRectElement, rows: number, row: number, width: number, height: number): void {
  const tall = Math.max(2.5, height / rows);
  place(line, kLeft - 2, kTop + ((row + 0.5) * height) / rows - tall / 2, width + 4, tall);
}

function markColumn(
  line: SVGRectElement,
  columns: number,
  column: number,
  width: number,
  height: number,
): void {
  const wide = Math.max(2.5, width / columns);
  place(line, kLeft + ((column + 0.5) * width) / columns - wide / 2, kTop - 2, wide, height + 4);
}

function place(line: SVGRectElement, x: number, y: number, width: number, height: number): void {
  for (const [name, value] of Object.entries({ x, y, width, height }))
    line.setAttribute(name, String(rounded(value)));
}

function cellAt(
  image: SVGImageElement,
  rows: number,
  columns: number,
  { clientX, clientY }: MouseEvent,
): { row: number; column: number } | null {
  const box = image.getBoundingClientRect();
  const row = Math.floor(((clientY - box.top) / box.height) * rows);
  const column = Math.floor(((clientX - box.left) / box.width) * columns);
  return row < 0 || row >= rows || column < 0 || column >= columns ? null : { row, column };
}
