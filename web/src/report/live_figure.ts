// A figure that is redrawn when the selection changes.

import type { Table } from "../parts/csv";
import { element, fill, type Child } from "../parts/dom";
import { figure } from "../parts/figure";
import type { Selection } from "./selection";

export interface Drawn {
  body: Child[];
  svg: SVGSVGElement | null;
  table: Table;
}

export interface LiveOptions {
  title: string;
  file: string;
  note?: string;
  controls?: Child[];
  wide?: boolean;
}

export interface LiveFigure {
  element: HTMLElement;
  redraw(): void;
}

export function liveFigure(options: LiveOptions, selection: Selection, draw: () => Drawn): LiveFigure {
  const body = element("div", { class: "live" });
  let drawn: Drawn = { body: [], svg: null, table: { columns: [], rows: [] } };
  const redraw = () => {
    drawn = draw();
    fill(body, drawn.body);
  };
  redraw();
  selection.listen(redraw);
  const shown = figure({ ...options, body, picture: () => drawn.svg, numbers: () => drawn.table });
  return { element: shown, redraw };
}

export function nothing(words: string): Drawn {
  const body = [element("p", { class: "message small" }, [words])];
  return { body, svg: null, table: { columns: [], rows: [] } };
}
