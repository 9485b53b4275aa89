// The graph of a system's modules, from the sensors on the left to the map on the right.
//
//   const picture = graphPicture(graph, (module) => show(module));
//
// Every module is a button that shows its details. picture.mark(name, words) sets a
// short text below a module's name, such as its current output.

import type { GraphData, ModuleData } from "./data";
import { graphLayout, type GraphLayout } from "./graph_layout";
import { rounded, shape, shortened, svg, text } from "./svg";

export interface GraphPicture {
  svg: SVGSVGElement;
  select(module: string | null): void;
  mark(module: string, words: string): void;
}

const kBoxHeight = 50;
const kRowStep = 66;
const kMargin = 4;
const kLoopRoom = 12; // beside the first and the last layer
const kRoom = 880; // about how wide a picture may be before it is scrolled

interface Sizes {
  box: number; // width of a module
  step: number; // from layer to layer
}

/** Wide spacing if there is space. */
function sizesFor(layers: number): Sizes {
  const box = layers > 5 ? 114 : 138;
  const step = (kRoom - box) / Math.max(1, layers - 1);
  return { box, step: Math.max(box + 26, Math.min(box + 44, step)) };
}

export function graphPicture(graph: GraphData, onChoose?: (module: ModuleData) => void): GraphPicture {
  const layout = graphLayout(graph.modules);
  const sizes = sizesFor(layout.layerCount);
  const boxes = graph.modules.map((module, i) =>
    boxOf(graph, module, placeOf(layout, i, sizes), sizes.box, onChoose),
  );
  const backs = layout.links.filter((link) => link.isBack).length;
  const left = backs > 0 ? kLoopRoom + 3 * backs : kMargin;
  const width = (layout.layerCount - 1) * sizes.step + sizes.box + left + kLoopRoom;
  const height =
    (layout.rowCount - 1) * kRowStep + kBoxHeight + backs * 16 + (backs > 0 ? 12 : 0) + 2 * kMargin;
  const links = shape("g", { class: "graph-links" }, linkPaths(layout, sizes));
  const inner = shape("g", { transform: `translate(${left} ${kMargin})` }, [links, ...boxes]);
  const picture = svg(width, height, `Graph of ${graph.modules.length} modules`, [inner]);
  picture.setAttribute("role", "group");
  const boxOfName = new Map(graph.modules.map((module, i) => [module.name, boxes[i]!]));
  return {
    svg: picture,
    select: (name) => boxOfName.forEach((box, own) => box.classList.toggle("chosen", own === name)),
    mark: (name, words) => {
      const line = boxOfName.get(name)?.querySelector(".module-mark");
      if (line && line.textContent !== words) line.textContent = shortened(words, sizes.box - 18, 10.5);
    },
  };
}

interface Place {
  x: number;
  y: number;
}

function placeOf(layout: GraphLayout, module: number, { step }: Sizes): Place {
  return { x: (layout.layers[module] ?? 0) * step, y: (layout.rows[module] ?? 0) * kRowStep };
}

/** The role of a module: "sense", "code", "learn" or "answer". */
export function kindOf(graph: GraphData, module: ModuleData): string {
  if (module.name === graph.map) return "answer";
  if (module.learns) return "learn";
  return module.type === "channel" ? "sense" : "code";
}

function boxOf(
  graph: GraphData,
  module: ModuleData,
  at: Place,
  width: number,
  onChoose?: (module: ModuleData) => void,
): SVGGElement {
  const words = [module.type.replaceAll("_", " "), shapeWords(module)]
    .filter((one) => one !== "")
    .join(" · ");
  const attributes = {
    transform: `translate(${rounded(at.x)} ${rounded(at.y)})`,
    class: `module ${kindOf(graph, module)}`,
  };
  const box = shape("g", attributes, [
    shape("rect", { width, height: kBoxHeight, rx: 5, class: "module-box" }),
    shape("rect", { width: 4, height: kBoxHeight - 12, x: 6, y: 6, rx: 2, class: "module-kind" }),
    text(17, 19, shortened(module.name, width - 22, 12), { class: "strong" }),
    text(17, 32.5, shortened(words, width - 18, 10.5), { class: "muted module-line" }),
    text(17, 44, shortened(phaseWords(graph, module), width - 18, 10.5), {
      class: "muted module-line module-mark",
    }),
  ]);
  if (onChoose) makeButton(box, module, onChoose);
  return box;
}

function makeButton(box: SVGGElement, module: ModuleData, onChoose: (module: ModuleData) => void): void {
  box.setAttribute("role", "button");
  box.setAttribute("tabindex", "0");
  box.addEventListener("click", () => onChoose(module));
  box.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== " ") return;
    event.preventDefault();
    onChoose(module);
  });
}

function shapeWords(module: ModuleData): string {
  return module.shape.length === 0 ? "1" : module.shape.join(" × ");
}

function phaseWords(graph: GraphData, module: ModuleData): string {
  if (!module.learns) return module.rate === "exploration" ? "at the end" : "every frame";
  const phase = graph.phases.findIndex((one) => one.learn.includes(module.name));
  return graph.phases.length > 1 && phase >= 0 ? `learns, phase ${phase + 1}` : "learns";
}

function linkPaths(layout: GraphLayout, sizes: Sizes): SVGElement[] {
  let loops = 0;
  return layout.links.flatMap((link) => {
    const [from, to] = [placeOf(layout, link.from, sizes), placeOf(layout, link.to, sizes)];
    const start = { x: from.x + sizes.box, y: from.y + kBoxHeight / 2 };
    const end = { x: to.x, y: to.y + kBoxHeight / 2 };
    if (link.isBack) return linkShapes(loopPath(layout, start, end, loops++), end, "back");
    const bends = link.bends.map(({ layer, row }) => ({
      x: layer * sizes.step,
      y: row * kRowStep + kBoxHeight / 2,
    }));
    return linkShapes(forwardPath(start, bends, end, sizes.box), end, "");
  });
}

const kArrow = 7;

function linkShapes(d: string, end: Place, kind: string): SVGElement[] {
  const [x, y] = [rounded(end.x), rounded(end.y)];
  const head = `M${x} ${y}l${-kArrow} ${-kArrow / 2}v${kArrow}Z`;
  return [shape("path", { d, class: `link ${kind}` }), shape("path", { d: head, class: "link-head" })];
}

function forwardPath(start: Place, bends: Place[], end: Place, width: number): string {
  let d = `M${rounded(start.x)} ${rounded(start.y)}`;
  let last = start;
  for (const bend of bends) {
    d += `${curveTo(last, bend)}H${rounded(bend.x + width)}`;
    last = { x: bend.x + width, y: bend.y };
  }
  return `${d}${curveTo(last, { x: end.x - kArrow + 1, y: end.y })}`;
}

function curveTo(from: Place, to: Place): string {
  const middle = rounded((from.x + to.x) / 2);
  return `C${middle} ${rounded(from.y)} ${middle} ${rounded(to.y)} ${rounded(to.x)} ${rounded(to.y)}`;
}

/** A path below all nodes and back. */
function loopPath(layout: GraphLayout, start: Place, end: Place, number: number): string {
  const below = rounded((layout.rowCount - 1) * kRowStep + kBoxHeight + 12 + number * 16);
  const out = 11 + number * 3;
  const corner = 7;
  return [
    `M${rounded(start.x)} ${rounded(start.y)}h${out - corner}q${corner} 0 ${corner} ${corner}`,
    `V${below - corner}q0 ${corner} ${-corner} ${corner}H${rounded(end.x - out + corner)}`,
    `q${-corner} 0 ${-corner} ${-corner}V${rounded(end.y + corner)}q0 ${-corner} ${corner} ${-corner}`,
    `H${rounded(end.x - kArrow + 1)}`,
  ].join("");
}
