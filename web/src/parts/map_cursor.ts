// Pointing at the cells of a picture (neurons of a map, taxels of a hand) and choosing them, with
// the mouse, a finger or the keyboard. A cell is a path with the attribute data-cell.

import { shape } from "./svg";

export interface CursorPlace {
  svg: SVGSVGElement;
  cells: readonly SVGPathElement[];
  rings: SVGGElement;
  kind: string; // "map": what the picture is, for those who hear it
  cellName: string; // "neurons"
  step(at: number, rows: number, columns: number): number;
}

export interface CursorOptions {
  label: string;
  onChoose?: (cell: number) => void;
  onPoint?: (cell: number | null) => void;
}

export interface Cursor {
  select(cell: number | null): void;
  refresh(): void; // says again what is pointed at, after values have changed
}

const kSteps: Record<string, [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

export function attachCursor(
  frame: CursorPlace,
  readout: HTMLElement,
  tell: (cell: number) => string,
  options: CursorOptions,
): Cursor {
  let pointed: number | null = null;
  let selected: number | null = null;
  const say = () => {
    const at = pointed ?? selected;
    const words = at === null ? "" : tell(at);
    if (readout.textContent !== words) readout.textContent = words;
  };
  const point = (cell: number | null) => {
    if (pointed === cell) return;
    pointed = cell;
    drawRings(frame, pointed, selected);
    say();
    options.onPoint?.(cell);
  };
  const select = (cell: number | null) => {
    selected = cell;
    drawRings(frame, pointed, selected);
    say();
  };
  const choose = (cell: number) => {
    select(cell);
    options.onChoose?.(cell);
  };
  const { svg } = frame;
  prepare(frame, options);
  svg.addEventListener("pointermove", (event) => point(cellAt(event)));
  svg.addEventListener("pointerleave", () => point(null));
  svg.addEventListener("click", (event) => {
    const cell = cellAt(event);
    if (cell !== null) choose(cell);
  });
  svg.addEventListener("focus", () => point(pointed ?? selected ?? 0));
  svg.addEventListener("blur", () => point(null));
  svg.addEventListener("keydown", (event) => {
    const at = pointed ?? selected ?? 0;
    const to = target(frame, at, event.key);
    if (to !== null) point(to);
    else if (event.key === "Enter" || event.key === " ") choose(at);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  return { select, refresh: say };
}

function prepare({ svg, kind, cellName }: CursorPlace, options: CursorOptions): void {
  const keys = `Arrow keys point at ${cellName}${options.onChoose ? ", Enter chooses one" : ""}.`;
  svg.setAttribute("role", "application");
  svg.setAttribute("aria-roledescription", kind);
  svg.setAttribute("aria-label", `${options.label}. ${keys}`);
  svg.setAttribute("tabindex", "0");
}

function cellAt(event: Event): number | null {
  const found = event.target instanceof Element ? event.target.closest("[data-cell]") : null;
  const number = found?.getAttribute("data-cell");
  return number === null || number === undefined ? null : Number(number);
}

function target(frame: CursorPlace, at: number, key: string): number | null {
  if (key === "Home") return 0;
  if (key === "End") return frame.cells.length - 1;
  const step = kSteps[key];
  return step ? frame.step(at, step[0], step[1]) : null;
}

function drawRings(frame: CursorPlace, pointed: number | null, selected: number | null): void {
  const drawn: SVGElement[] = [];
  for (const [cell, kind] of [[selected, "map-ring"], [pointed, "map-ring pointed"]] as const) {
    const d = cell === null ? null : (frame.cells[cell]?.getAttribute("d") ?? null);
    if (d === null) continue;
    drawn.push(shape("path", { d, class: "map-ring-back" }), shape("path", { d, class: kind }));
  }
  frame.rings.replaceChildren(...drawn);
}
