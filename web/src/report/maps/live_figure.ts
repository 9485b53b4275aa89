// A figure that is redrawn when the selection changes, and marks the selected neuron.

import type { Table } from "../../parts/csv";
import { element, fill, type Child } from "../../parts/dom";
import { figure, type Printed, type Shown } from "../../parts/figure";
import type { CellPicture } from "../../parts/maps/map_cursor";
import { shownBySelection } from "../page/origin";
import type { Selection } from "../page/selection";

export interface Drawn {
  body: Child[];
  svg: SVGSVGElement | null;
  table: Table;
  map?: CellPicture; // a map on which the selected neuron is marked
}

export interface LiveOptions {
  title: string;
  file: string;
  note?: string;
  controls?: Child[];
  wide?: boolean;
  about?: () => Shown;
  printed?: Printed;
}

export function liveFigure(options: LiveOptions, selection: Selection, draw: () => Drawn): HTMLElement {
  const body = element("div", { class: "live" });
  let drawn: Drawn = { body: [], svg: null, table: { columns: [], rows: [] } };
  const redraw = () => {
    drawn = draw();
    drawn.map?.select(selection.neuron);
    drawn.map?.mark(selection.marks);
    fill(body, drawn.body);
  };
  redraw();
  selection.listen(redraw);
  selection.listenToNeuron((neuron) => drawn.map?.select(neuron));
  selection.listenToMarks(() => drawn.map?.mark(selection.marks));
  return figure({
    about: () => shownBySelection(selection),
    ...options,
    body,
    picture: () => drawn.svg,
    numbers: () => drawn.table,
  });
}

export function nothing(words: string): Drawn {
  const body = [element("p", { class: "message small" }, [words])];
  return { body, svg: null, table: { columns: [], rows: [] } };
}
