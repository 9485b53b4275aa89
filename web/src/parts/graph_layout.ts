// Lays out a graph of modules in layers from left to right. The links that close a loop go backwards.

import type { ModuleData } from "./data";

export interface Link {
  from: number; // index of a module
  to: number;
  port: string;
  isBack: boolean;
}

export interface GraphLayout {
  layers: number[]; // of each module
  rows: number[]; // of each module: where it lies in its layer, in rows; may be a fraction
  links: (Link & { bends: { layer: number; row: number }[] })[]; // where they pass through layers
  layerCount: number;
  rowCount: number;
}

export function graphLayout(modules: readonly ModuleData[]): GraphLayout {
  const links = markBack(linksOf(modules), modules);
  const layers = layersOf(modules.length, links);
  const nodes = withBends(layers, links);
  const order = orderedLayers(nodes);
  place(nodes, order);
  return {
    layers,
    rows: nodes.slice(0, modules.length).map((node) => node.row),
    links: links.map((link) => ({ ...link, bends: nodes.filter((node) => node.link === link) })),
    layerCount: order.length,
    rowCount: Math.max(1, ...nodes.map((node) => node.row + 1)),
  };
}

function linksOf(modules: readonly ModuleData[]): Link[] {
  const index = new Map(modules.map((module, i) => [module.name, i]));
  return modules.flatMap((module, to) =>
    module.inputs.flatMap(({ port, module: name }) => {
      const from = index.get(name);
      return from === undefined ? [] : [{ from, to, port, isBack: false }];
    }),
  );
}

/** A loop is cut at the input of a delay; without a delay, where a traversal meets itself. */
function markBack(links: Link[], modules: readonly ModuleData[]): Link[] {
  for (const link of links) {
    const isDelay = modules[link.to]?.type.includes("delay") ?? false;
    link.isBack = isDelay && reaches(links, link.to, link.from);
  }
  const state = new Map<number, "open" | "done">();
  const walk = (at: number): void => {
    state.set(at, "open");
    for (const link of links) {
      if (link.from !== at || link.isBack) continue;
      if (state.get(link.to) === "open") link.isBack = true;
      else if (!state.has(link.to)) walk(link.to);
    }
    state.set(at, "done");
  };
  modules.forEach((_, i) => (state.has(i) ? undefined : walk(i)));
  return links;
}

function reaches(links: Link[], from: number, to: number): boolean {
  const seen = new Set([from]);
  for (const at of seen) {
    for (const link of links) if (link.from === at) seen.add(link.to);
  }
  return seen.has(to);
}

/** The longest path from a source; a source is placed directly before its targets. */
function layersOf(count: number, links: Link[]): number[] {
  const layers = new Array<number>(count).fill(0);
  const ahead = links.filter((link) => !link.isBack);
  for (let round = 0; round < count; round += 1) {
    for (const { from, to } of ahead) layers[to] = Math.max(layers[to] ?? 0, (layers[from] ?? 0) + 1);
  }
  return layers;
}

interface Station {
  layer: number;
  row: number;
  link: Link | null; // it is a bend of
  before: Station[];
  after: Station[];
}

/** A node for each module, and one for each layer that a link passes through. */
function withBends(layers: number[], links: Link[]): Station[] {
  const made = (layer: number, link: Link | null): Station => ({
    layer,
    row: 0,
    link,
    before: [],
    after: [],
  });
  const nodes = layers.map((layer) => made(layer, null));
  for (const link of links.filter((one) => !one.isBack)) {
    const end = nodes[link.to]!;
    let last = nodes[link.from]!;
    for (let layer = last.layer + 1; layer < end.layer; layer += 1) {
      const bend = made(layer, link);
      nodes.push(bend);
      join(last, bend);
      last = bend;
    }
    join(last, end);
  }
  return nodes;
}

function join(one: Station, other: Station): void {
  one.after.push(other);
  other.before.push(one);
}

const kSweeps = 12;

/** Nodes of each layer, ordered by the mean position of their neighbours to reduce crossings. */
function orderedLayers(nodes: Station[]): Station[][] {
  const count = Math.max(0, ...nodes.map((node) => node.layer)) + 1;
  const order = Array.from({ length: count }, (_, layer) => nodes.filter((node) => node.layer === layer));
  const number = () => order.forEach((layer) => layer.forEach((node, i) => (node.row = i)));
  number();
  for (let sweep = 0; sweep < kSweeps; sweep += 1) {
    const isForward = sweep % 2 === 0;
    for (const layer of isForward ? order : [...order].reverse()) {
      const wanted = new Map(
        layer.map((node) => [node, meanRow(isForward ? node.before : node.after, node.row)]),
      );
      layer.sort((one, other) => wanted.get(one)! - wanted.get(other)!);
      layer.forEach((node, i) => (node.row = i));
    }
  }
  return order;
}

function meanRow(of: Station[], otherwise: number): number {
  return of.length === 0 ? otherwise : of.reduce((sum, node) => sum + node.row, 0) / of.length;
}

/** Rows near those of the neighbours, at least one apart. */
function place(nodes: Station[], order: Station[][]): void {
  for (let sweep = 0; sweep < kSweeps; sweep += 1) {
    for (const layer of sweep % 2 === 0 ? order : [...order].reverse()) spread(layer);
  }
  const top = Math.min(...nodes.map((node) => node.row));
  nodes.forEach((node) => (node.row -= top));
}

function spread(layer: Station[]): void {
  const wanted = layer.map((node) => meanRow([...node.before, ...node.after], node.row));
  // Neighbours with the same desired position are centred about it.
  const groups: { from: number; size: number; sum: number }[] = [];
  wanted.forEach((row, i) => {
    groups.push({ from: i, size: 1, sum: row });
    while (groups.length > 1 && overlaps(groups.at(-2)!, groups.at(-1)!)) {
      const last = groups.pop()!;
      const before = groups.at(-1)!;
      before.sum += last.sum - last.size * before.size;
      before.size += last.size;
    }
  });
  for (const group of groups) {
    for (let i = 0; i < group.size; i += 1) layer[group.from + i]!.row = startOf(group) + i;
  }
}

type Group = { from: number; size: number; sum: number };

// `sum` is that of the desired rows, each minus its position in the group.
const startOf = (group: Group) => group.sum / group.size;
const overlaps = (one: Group, other: Group) => startOf(one) + one.size > startOf(other);
