// Pictures of a map, rectangular or hexagonal, plane or torus (whose border is dotted), or a graph.
//
//   const picture = valuesPicture(grid, { label: "U-matrix", unit: "", onChoose: show });
//   picture.setValues(values, [low, high]);   // cheap: only changed cells are updated
//   picture.setWinner(neuron);                // a ring; null removes it
//   picture.setMarks(classes, names);         // a marker on each neuron with a class
//   place.append(picture.element);
//
//   const picture = labelsPicture(grid, { label, names, winners, classes, areas: true });
//
// Pointing at a neuron, or moving with the arrow keys when the map has the focus, shows its row,
// column and value below the picture; a click, Enter or space selects it.

import type { GridData } from "../data";
import { sequenceColour } from "./colour_maps";
import { centreOf, placeOf } from "./grid";
import { mapFrame, setFootHeight, type MapFrame, type MapOptions } from "./map_cells";
import { cellPicture, type CellPicture } from "./map_cursor";
import { colourBar, markerLegend } from "./legend";
import { marker } from "./markers";
import { rangeOf, readable, withUnit } from "../numbers";
import { painter, scaled } from "./painter";
import { shape } from "../svg";

export interface ValuesOptions extends MapOptions {
  unit?: string;
  colour?: (share: number) => string;
  legend?: boolean; // a bar with its ends; unless false
  describe?: (neuron: number) => string; // more words for the readout
}

export interface ValuesPicture extends CellPicture {
  setValues(values: readonly (number | null)[], range?: readonly [number, number]): void;
  setEdges(values: readonly number[], range: readonly [number, number]): void; // colours those of a graph
  setWinner(neuron: number | null): void;
  setMarks(classes: readonly (number | null)[], names: readonly string[]): void;
}

export function valuesPicture(grid: GridData, options: ValuesOptions): ValuesPicture {
  const hasLegend = options.legend !== false;
  const frame = mapFrame(grid, options, hasLegend ? kBar : 0);
  const bar = hasLegend ? colourBar(frame.width, options.unit ?? "", options.colour ?? sequenceColour) : null;
  if (bar) frame.foot.append(bar.group);
  let shown: readonly (number | null)[] = [];
  let names: readonly string[] = [];
  let marks: readonly (number | null)[] = [];
  const describe = (neuron: number) => {
    const value = withUnit(readable(shown[neuron]), options.unit ?? "");
    const mark = marks[neuron];
    const name = mark === null || mark === undefined ? "" : `, ${names[mark] ?? ""}`;
    return `${placeOf(grid, neuron)}: ${value}${name}${options.describe ? `, ${options.describe(neuron)}` : ""}`;
  };
  const picture = cellPicture(frame, "map-picture", describe, options);
  const paint = painter(frame.cells, options.colour ?? sequenceColour);
  return {
    ...picture,
    setValues: (values, range) => {
      const [low, high] = range ?? rangeOf(values) ?? [0, 1];
      shown = values;
      paint(values, low, high);
      bar?.setRange(low, high);
      picture.refresh();
    },
    setEdges: (values, [low, high]) => {
      const colour = scaled(options.colour ?? sequenceColour, low, high);
      frame.edges.forEach((edge, i) => (edge.style.stroke = colour(values[i]) ?? ""));
    },
    setWinner: (neuron) => setWinner(frame, neuron),
    setMarks: (classes, classNames) => {
      marks = classes;
      names = classNames;
      drawMarks(frame, classes);
      drawMarkLegend(frame, classes, classNames, hasLegend);
    },
  };
}

const kBar = 30; // height of the bar of colours

/** The names of the markers below the bar of colours. */
function drawMarkLegend(
  frame: MapFrame,
  classes: readonly (number | null)[],
  names: readonly string[],
  hasBar: boolean,
): void {
  const counts = names.map((_, number) => classes.filter((one) => one === number).length);
  const { group, height } = markerLegend(frame.width, names, counts, false);
  const top = hasBar ? kBar + 8 : 0;
  group.setAttribute("transform", `translate(0 ${top})`);
  frame.foot.querySelector(".marker-legend")?.remove();
  frame.foot.append(group);
  setFootHeight(frame, top + height);
}

function setWinner(frame: MapFrame, neuron: number | null): void {
  const shown = String(neuron ?? "");
  if (frame.winner.dataset["neuron"] === shown) return;
  frame.winner.dataset["neuron"] = shown;
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
