// Pointing at and selecting the cells of a picture (neurons of a map, taxels of a hand) with
// the mouse, by touch or with the keyboard. A cell is a path with the attribute data-cell.

import { element } from "../dom";
import { shape } from "../svg";

export interface CursorPlace {
  svg: SVGSVGElement;
  cells: readonly SVGPathElement[];
  rings: SVGGElement;
  kind: string; // "map": the kind of picture, for screen readers
  cellName: string; // "neurons"
  step(at: number, rows: number, columns: number): number;
}

export interface CursorOptions {
  label: string;
  onChoose?: (cell: number) => void;
  onPoint?: (cell: number | null) => void;
}

export interface CellPicture {
  element: HTMLElement; // the picture with its readout
  svg: SVGSVGElement;
  select(cell: number | null): void;
  mark(cells: readonly number[]): void; // several at once, such as what belongs to a selection elsewhere
  refresh(): void; // says again what is pointed at, after values have changed
}

/** The picture with a readout below it, which says what `describe` has for the cell that is pointed at. */
export function cellPicture(
  place: CursorPlace,
  kind: string | null, // its class in the style sheet
  describe: (cell: number) => string,
  options: CursorOptions,
): CellPicture {
  const readout = element("output", { class: "readout", "aria-live": "polite" });
  const cursor = new CellCursor(place, readout, describe, options);
  return {
    element: element("div", { class: kind }, [place.svg, readout]),
    svg: place.svg,
    select: (cell) => cursor.select(cell),
    mark: (cells) => cursor.mark(cells),
    refresh: () => cursor.say(),
  };
}

const kSteps: Record<string, [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

class CellCursor {
  private pointed: number | null = null;
  private selected: number | null = null;
  private marked: readonly number[] = [];

  constructor(
    private readonly place: CursorPlace,
    private readonly readout: HTMLElement,
    private readonly describe: (cell: number) => string,
    private readonly options: CursorOptions,
  ) {
    prepare(place, options);
    this.listen(place.svg);
  }

  select(cell: number | null): void {
    this.selected = cell;
    this.drawRings();
    this.say();
  }

  mark(cells: readonly number[]): void {
    this.marked = cells;
    this.drawRings();
  }

  private drawRings(): void {
    const rings: [number | null, string][] = this.marked.map((cell) => [cell, "map-ring marked"]);
    drawRings(this.place, [...rings, [this.selected, "map-ring"], [this.pointed, "map-ring pointed"]]);
  }

  say(): void {
    const at = this.pointed ?? this.selected;
    const words = at === null ? "" : this.describe(at);
    if (this.readout.textContent !== words) this.readout.textContent = words;
  }

  private listen(svg: SVGSVGElement): void {
    svg.addEventListener("pointermove", (event) => this.point(cellAt(event)));
    svg.addEventListener("pointerleave", () => this.point(null));
    svg.addEventListener("click", (event) => this.choose(cellAt(event)));
    svg.addEventListener("focus", () => this.point(this.pointed ?? this.selected ?? 0));
    svg.addEventListener("blur", () => this.point(null));
    svg.addEventListener("keydown", (event) => this.press(event));
  }

  private point(cell: number | null): void {
    if (this.pointed === cell) return;
    this.pointed = cell;
    this.drawRings();
    this.say();
    this.options.onPoint?.(cell);
  }

  private choose(cell: number | null): void {
    if (cell === null) return;
    this.point(cell); // a finger points only now: the focus before it has pointed at the first cell
    this.select(cell);
    this.options.onChoose?.(cell);
  }

  private press(event: KeyboardEvent): void {
    const at = this.pointed ?? this.selected ?? 0;
    const to = target(this.place, at, event.key);
    if (to !== null) this.point(to);
    else if (event.key === "Enter" || event.key === " ") this.choose(at);
    else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

function prepare({ svg, kind, cellName }: CursorPlace, options: CursorOptions): void {
  const keys = `Arrow keys move between ${cellName}${options.onChoose ? ", Enter selects one" : ""}.`;
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

function target(place: CursorPlace, at: number, key: string): number | null {
  if (key === "Home") return 0;
  if (key === "End") return place.cells.length - 1;
  const step = kSteps[key];
  return step ? place.step(at, step[0], step[1]) : null;
}

function drawRings(place: CursorPlace, rings: [cell: number | null, kind: string][]): void {
  const drawn: SVGElement[] = [];
  for (const [cell, kind] of rings) {
    const d = cell === null ? null : (place.cells[cell]?.getAttribute("d") ?? null);
    if (d === null) continue;
    drawn.push(shape("path", { d, class: "map-ring-back" }), shape("path", { d, class: kind }));
  }
  place.rings.replaceChildren(...drawn);
}
