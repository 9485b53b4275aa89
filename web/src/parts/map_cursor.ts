// Pointing at neurons and choosing them, with the mouse, a finger or the keyboard.

import { neuronCount, stepFrom } from "./grid";
import type { MapFrame } from "./map_cells";
import type { MapOptions } from "./map_picture";
import { shape } from "./svg";

export interface Cursor {
  select(neuron: number | null): void;
  refresh(): void; // says again what is pointed at, after values have changed
}

const kSteps: Record<string, [number, number]> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

export function attachCursor(
  frame: MapFrame,
  readout: HTMLElement,
  tell: (neuron: number) => string,
  options: MapOptions,
): Cursor {
  let pointed: number | null = null;
  let selected: number | null = null;
  const say = () => {
    const at = pointed ?? selected;
    const words = at === null ? "" : tell(at);
    if (readout.textContent !== words) readout.textContent = words;
  };
  const point = (neuron: number | null) => {
    if (pointed === neuron) return;
    pointed = neuron;
    drawRings(frame, pointed, selected);
    say();
    options.onPoint?.(neuron);
  };
  const select = (neuron: number | null) => {
    selected = neuron;
    drawRings(frame, pointed, selected);
    say();
  };
  const choose = (neuron: number) => {
    select(neuron);
    options.onChoose?.(neuron);
  };
  const { svg } = frame;
  prepare(svg, options);
  svg.addEventListener("pointermove", (event) => point(neuronAt(event)));
  svg.addEventListener("pointerleave", () => point(null));
  svg.addEventListener("click", (event) => {
    const neuron = neuronAt(event);
    if (neuron !== null) choose(neuron);
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

function prepare(svg: SVGSVGElement, options: MapOptions): void {
  const keys = options.onChoose ? "Arrow keys point at neurons, Enter chooses one." : "Arrow keys point at neurons.";
  svg.setAttribute("role", "application");
  svg.setAttribute("aria-roledescription", "map");
  svg.setAttribute("aria-label", `${options.label}. ${keys}`);
  svg.setAttribute("tabindex", "0");
}

function neuronAt(event: Event): number | null {
  const cell = event.target instanceof Element ? event.target.closest("[data-neuron]") : null;
  const number = cell?.getAttribute("data-neuron");
  return number === null || number === undefined ? null : Number(number);
}

function target(frame: MapFrame, at: number, key: string): number | null {
  if (key === "Home") return 0;
  if (key === "End") return neuronCount(frame.grid) - 1;
  const step = kSteps[key];
  return step ? stepFrom(frame.grid, at, step[0], step[1]) : null;
}

function drawRings(frame: MapFrame, pointed: number | null, selected: number | null): void {
  const drawn: SVGElement[] = [];
  for (const [neuron, kind] of [[selected, "map-ring"], [pointed, "map-ring pointed"]] as const) {
    const d = neuron === null ? null : (frame.cells[neuron]?.getAttribute("d") ?? null);
    if (d === null) continue;
    drawn.push(shape("path", { d, class: "map-ring-back" }), shape("path", { d, class: kind }));
  }
  frame.rings.replaceChildren(...drawn);
}
