// The graph of a system's modules, from the sensors on the left to the map on the right.
//
//   const picture = graphPicture(graph, (module) => show(module));
//
// Every module is a button that shows its details. picture.mark(name, words) sets a
// short text below a module's name, such as its current output.

import type { GraphData, ModuleData } from "./data";
import { graphLayout, type GraphLayout } from "./graph_layout";
import { rounded, shape, shortened, svg, text, textWidth } from "./svg";

export interface GraphPicture {
  svg: SVGSVGElement;
  select(module: string | null): void;
  mark(module: string, words: string): void;
}

const kBoxHeight = 50;
const kRowStep = 66;
const kMargin = 4;
const kLoopRoom = 12; // beside the first and the last layer
const kGap = 30; // between layers
const kNarrowest = 114; // of modules
const kWidest = 260;
const kLeastScale = 0.75; // of a picture that is wider than its place; below, it is scrolled

/** Left edge and width of the modules in each layer, wide enough for their texts. */
interface Sizes {
  left: number[];
  width: number[];
}

function sizesFor(graph: GraphData, layout: GraphLayout): Sizes {
  const width = Array.from({ length: layout.layerCount }, (_, layer) => {
    const modules = graph.modules.filter((_module, i) => layout.layers[i] === layer);
    const widest = Math.max(0, ...modules.map((module) => roomFor(graph, module)));
    return Math.min(kWidest, Math.max(kNarrowest, Math.ceil(widest)));
  });
  const left = width.map((_, layer) => width.slice(0, layer).reduce((sum, one) => sum + one + kGap, 0));
  return { left, width };
}

function roomFor(graph: GraphData, module: ModuleData): number {
  const lines = [typeWords(module), phaseWords(graph, module)].map((words) => textWidth(words, kLineSize));
  return kTextLeft + 8 + Math.max(textWidth(module.name, kNameSize) * kBold, ...lines);
}

export function graphPicture(graph: GraphData, onChoose?: (module: ModuleData) => void): GraphPicture {
  const layout = graphLayout(graph.modules);
  const sizes = sizesFor(graph, layout);
  const widths = graph.modules.map((_, i) => widthOf(layout, i, sizes));
  const boxes = graph.modules.map((module, i) =>
    boxOf(graph, module, placeOf(layout, i, sizes), widths[i]!, onChoose),
  );
  const backs = layout.links.filter((link) => link.isBack).length;
  const left = backs > 0 ? kLoopRoom + 3 * backs : kMargin;
  const right = (sizes.left.at(-1) ?? 0) + (sizes.width.at(-1) ?? 0);
  const width = right + left + kLoopRoom + 3 * backs;
  const height =
    (layout.rowCount - 1) * kRowStep + kBoxHeight + backs * 16 + (backs > 0 ? 12 : 0) + 2 * kMargin;
  const links = shape("g", { class: "graph-links" }, linkPaths(layout, sizes));
  const inner = shape("g", { transform: `translate(${left} ${kMargin})` }, [links, ...boxes]);
  const picture = svg(width, height, `Graph of ${graph.modules.length} modules`, [inner]);
  picture.setAttribute("role", "group");
  picture.style.width = `clamp(${Math.round(kLeastScale * width)}px, 100%, ${Math.round(width)}px)`;
  const boxOfName = new Map(graph.modules.map((module, i) => [module.name, boxes[i]!]));
  const widthOfName = new Map(graph.modules.map((module, i) => [module.name, widths[i]!]));
  return {
    svg: picture,
    select: (name) => boxOfName.forEach((box, own) => box.classList.toggle("chosen", own === name)),
    mark: (name, words) => {
      const line = boxOfName.get(name)?.querySelector(".module-mark");
      if (line && line.textContent !== words) line.textContent = shortened(words, textRoom(widthOfName.get(name)!), kLineSize);
    },
  };
}

interface Place {
  x: number;
  y: number;
}

function placeOf(layout: GraphLayout, module: number, { left }: Sizes): Place {
  return { x: left[layout.layers[module] ?? 0] ?? 0, y: (layout.rows[module] ?? 0) * kRowStep };
}

function widthOf(layout: GraphLayout, module: number, { width }: Sizes): number {
  return width[layout.layers[module] ?? 0] ?? kNarrowest;
}

const kTextLeft = 17;
const kNameSize = 12;
const kBold = 1.08; // width of bold letters by that of others
const kLineSize = 10.5;
const textRoom = (width: number) => width - kTextLeft - 1;

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
  const attributes = {
    transform: `translate(${rounded(at.x)} ${rounded(at.y)})`,
    class: `module ${kindOf(graph, module)}`,
  };
  const box = shape("g", attributes, [
    shape("rect", { width, height: kBoxHeight, rx: 5, class: "module-box" }),
    shape("rect", { width: 4, height: kBoxHeight - 12, x: 6, y: 6, rx: 2, class: "module-kind" }),
    text(kTextLeft, 19, shortened(module.name, textRoom(width) - 4, kNameSize), { class: "strong" }),
    text(kTextLeft, 32.5, shortened(typeWords(module), textRoom(width), kLineSize), { class: "muted module-line" }),
    text(kTextLeft, 44, shortened(phaseWords(graph, module), textRoom(width), kLineSize), {
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

function typeWords(module: ModuleData): string {
  return [module.type.replaceAll("_", " "), shapeWords(module)].filter((one) => one !== "").join(" · ");
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
    const start = { x: from.x + widthOf(layout, link.from, sizes), y: from.y + kBoxHeight / 2 };
    const end = { x: to.x, y: to.y + kBoxHeight / 2 };
    if (link.isBack) return linkShapes(loopPath(layout, start, end, loops++), end, "back");
    const bends = link.bends.map(({ layer, row }) => ({
      x: sizes.left[layer] ?? 0,
      y: row * kRowStep + kBoxHeight / 2,
      width: sizes.width[layer] ?? 0,
    }));
    return linkShapes(forwardPath(start, bends, end), end, "");
  });
}

const kArrow = 7;

function linkShapes(d: string, end: Place, kind: string): SVGElement[] {
  const [x, y] = [rounded(end.x), rounded(end.y)];
  const head = `M${x} ${y}l${-kArrow} ${-kArrow / 2}v${kArrow}Z`;
  return [shape("path", { d, class: `link ${kind}` }), shape("path", { d: head, class: "link-head" })];
}

function forwardPath(start: Place, bends: (Place & { width: number })[], end: Place): string {
  let d = `M${rounded(start.x)} ${rounded(start.y)}`;
  let last = start;
  for (const bend of bends) {
    d += `${curveTo(last, bend)}H${rounded(bend.x + bend.width)}`;
    last = { x: bend.x + bend.width, y: bend.y };
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
