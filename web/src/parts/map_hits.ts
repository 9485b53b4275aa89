// How many samples each neuron of a map won: discs whose areas are as the numbers.

import type { GridData } from "./data";
import { element } from "./dom";
import { centreOf, placeOf } from "./grid";
import { cellSize, mapFrame, type MapFrame } from "./map_cells";
import { attachCursor } from "./map_cursor";
import type { MapOptions, MapPicture } from "./map_picture";
import { shape, rounded, text } from "./svg";

export function hitsPicture(grid: GridData, hits: readonly (number | null)[], options: MapOptions): MapPicture {
  const frame = mapFrame(grid, options.label, cellSize(grid, options.size ?? 420), 0);
  const most = Math.max(1, ...hits.map((count) => count ?? 0));
  hits.forEach((count, neuron) => drawHits(frame, neuron, count ?? 0, most));
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  const tell = (neuron: number) => `${placeOf(grid, neuron)}: ${hitWords(hits[neuron] ?? 0)}`;
  const cursor = attachCursor(frame, readout, tell, options);
  return { element: element("div", { class: "map-picture" }, [frame.svg, readout]), svg: frame.svg, select: cursor.select };
}

function hitWords(count: number): string {
  return count === 1 ? "1 sample" : `${count} samples`;
}

const kNumberSize = 15; // pixels a cell needs for a number in its disc

function drawHits(frame: MapFrame, neuron: number, count: number, most: number): void {
  if (count <= 0) return;
  const [x, y] = centreOf(frame.grid, neuron);
  const [at, middle] = [x * frame.cell, y * frame.cell];
  const radius = Math.max(1.5, 0.46 * frame.cell * Math.sqrt(count / most));
  frame.marks.append(shape("circle", { cx: rounded(at), cy: rounded(middle), r: rounded(radius), class: "hit" }));
  const hasRoom = radius * 2 >= kNumberSize && String(count).length * 7 < radius * 2;
  if (hasRoom) frame.marks.append(text(at, middle + 4, String(count), { class: "middle note on-hit" }));
}
