// Pictures of a map, rectangular or hexagonal, plane or torus (whose border is dotted).
//
//   const picture = valuesPicture(grid, { label: "U-matrix", unit: "", onChoose: show });
//   picture.setValues(values, [low, high]);   // cheap: only cells that change are touched
//   picture.setWinner(neuron);                // a ring; null takes it away
//   picture.setMarks(classes, names);         // a marker on each neuron with a class
//   place.append(picture.element);
//
//   const picture = labelsPicture(grid, { label, names, winners, classes, areas: true });
//
// Pointing at a neuron, or moving with the arrow keys when the map has the focus, tells its row,
// column and value below the picture; a click, Enter or space chooses it.

import type { GridData } from "./data";
import { sequenceColour } from "./colour_maps";
import { element } from "./dom";
import { centreOf, placeOf } from "./grid";
import { cellSize, mapFrame, type MapFrame } from "./map_cells";
import { attachCursor, type CursorOptions } from "./map_cursor";
import { colourBar } from "./legend";
import { marker } from "./markers";
import { rangeOf, readable } from "./numbers";
import { painter } from "./painter";
import { shape } from "./svg";

export interface MapOptions extends CursorOptions {
  size?: number; // about how wide, in pixels; 420 unless said
}

export interface MapPicture {
  element: HTMLElement; // the picture with its readout
  svg: SVGSVGElement;
  select(neuron: number | null): void;
}

export interface ValuesOptions extends MapOptions {
  unit?: string;
  colour?: (share: number) => string;
  legend?: boolean; // a bar with its ends; unless false
  tell?: (neuron: number) => string; // more words for the readout
}

export interface ValuesPicture extends MapPicture {
  setValues(values: readonly (number | null)[], range?: readonly [number, number]): void;
  setWinner(neuron: number | null): void;
  setMarks(classes: readonly (number | null)[], names: readonly string[]): void;
}

export function valuesPicture(grid: GridData, options: ValuesOptions): ValuesPicture {
  const hasLegend = options.legend !== false;
  const frame = mapFrame(grid, options.label, cellSize(grid, options.size ?? 420), hasLegend ? 30 : 0);
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  const bar = hasLegend ? colourBar(frame.width, options.unit ?? "", options.colour ?? sequenceColour) : null;
  if (bar) frame.foot.append(bar.group);
  let shown: readonly (number | null)[] = [];
  let names: readonly string[] = [];
  let marks: readonly (number | null)[] = [];
  const tell = (neuron: number) => {
    const value = `${readable(shown[neuron])}${options.unit ? ` ${options.unit}` : ""}`;
    const mark = marks[neuron];
    const name = mark === null || mark === undefined ? "" : `, ${names[mark] ?? ""}`;
    return `${placeOf(grid, neuron)}: ${value}${name}${options.tell ? `, ${options.tell(neuron)}` : ""}`;
  };
  const cursor = attachCursor(frame, readout, tell, options);
  const paint = painter(frame.cells, options.colour ?? sequenceColour);
  return {
    element: element("div", { class: "map-picture" }, [frame.svg, readout]),
    svg: frame.svg,
    select: cursor.select,
    setValues: (values, range) => {
      const [low, high] = range ?? rangeOf(values) ?? [0, 1];
      shown = values;
      paint(values, low, high);
      bar?.setRange(low, high);
      cursor.refresh();
    },
    setWinner: (neuron) => setWinner(frame, neuron),
    setMarks: (classes, classNames) => {
      marks = classes;
      names = classNames;
      drawMarks(frame, classes);
    },
  };
}

function setWinner(frame: MapFrame, neuron: number | null): void {
  if (neuron === null) return frame.winner.replaceChildren();
  const d = frame.cells[neuron]?.getAttribute("d") ?? "";
  const back = shape("path", { d, class: "map-ring-back" });
  frame.winner.replaceChildren(back, shape("path", { d, class: "map-ring" }));
}

function drawMarks(frame: MapFrame, classes: readonly (number | null)[]): void {
  const radius = Math.min(6, frame.cell * 0.24);
  const drawn = classes.flatMap((number, neuron) => {
    if (number === null) return [];
    const [x, y] = centreOf(frame.grid, neuron);
    return [marker(number, x * frame.cell, y * frame.cell, radius)];
  });
  frame.marks.replaceChildren(...drawn);
}

export { labelsPicture, type LabelsOptions } from "./map_labels";
