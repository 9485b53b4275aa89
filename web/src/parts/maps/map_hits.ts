// The number of samples won by each neuron: discs with areas proportional to the numbers.

import type { GridData } from "../data";
import { centreOf, placeOf } from "./grid";
import { mapFrame, type MapFrame, type MapOptions } from "./map_cells";
import { cellPicture, type CellPicture } from "./map_cursor";
import { countOf } from "../numbers";
import { shape, rounded, text } from "../svg";

export function hitsPicture(
  grid: GridData,
  hits: readonly (number | null)[],
  options: MapOptions,
): CellPicture {
  const frame = mapFrame(grid, options, 0);
  const most = Math.max(1, ...hits.map((count) => count ?? 0));
  hits.forEach((count, neuron) => drawHits(frame, neuron, count ?? 0, most));
  const describe = (neuron: number) => `${placeOf(grid, neuron)}: ${countOf(hits[neuron] ?? 0, "sample")}`;
  return cellPicture(frame, "map-picture", describe, options);
}

const kNumberSize = 15; // pixels a cell needs for a number in its disc

function drawHits(frame: MapFrame, neuron: number, count: number, most: number): void {
  if (count <= 0) return;
  const [x, y] = centreOf(frame.grid, neuron);
  const [at, middle] = [x * frame.cell, y * frame.cell];
  const radius = Math.max(1.5, 0.46 * frame.cell * Math.sqrt(count / most));
  frame.marks.append(
    shape("circle", { cx: rounded(at), cy: rounded(middle), r: rounded(radius), class: "hit" }),
  );
  const hasRoom = radius * 2 >= kNumberSize && String(count).length * 7 < radius * 2;
  if (hasRoom) frame.marks.append(text(at, middle + 4, String(count), { class: "middle note on-hit" }));
}
