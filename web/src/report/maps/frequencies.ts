// The axis of a channel whose elements have an order and no places: frequencies for the
// output of a module `spectrum`, or else the numbers of its elements.

import type { ChannelData, GraphData, ModuleData } from "../../parts/data";
import { hasPlaces } from "../../parts/hands/skin_layout";
import type { Axis } from "./line_picture";
import type { MomentData, SystemReport } from "../page/unpacked";

const kFewest = 24; // elements that are drawn as a line

export function axisOf(system: SystemReport, channel: ChannelData): Axis | null {
  const { elements } = channel;
  if (elements.length < kFewest || hasPlaces(channel)) return null;
  const bins = elements.map(binOf);
  const step = hertzOfBin(system, channel.name);
  if (step !== null && bins.every((bin) => bin !== null)) {
    return { name: "frequency", unit: "Hz", values: bins.map((bin) => bin * step) };
  }
  return { name: "element", unit: "", values: elements.map((_, i) => i + 1) };
}

/** "18-34" are the bins 17 to 33, of which the middle counts. */
function binOf(element: string): number | null {
  const match = /^(\d+)(?:-(\d+))?$/.exec(element);
  if (!match) return null;
  return (Number(match[1]) + Number(match[2] ?? match[1])) / 2 - 1;
}

/** The distance of two bins of a spectrum without bands; null for another module. */
function hertzOfBin({ graph, moments }: SystemReport, name: string): number | null {
  const module = graph?.modules.find((one) => one.name === name);
  const bins = module?.shape.at(-1) ?? 0;
  if (!graph || module?.type !== "spectrum" || bins < 2 || module.parameters["bands"] !== "0") return null;
  const rate = rateOf(sourceOf(graph, module), moments);
  return rate > 0 ? rate / (2 * (bins - 1)) : null;
}

/** The channel from which a module derives its values. */
function sourceOf(graph: GraphData, module: ModuleData): string {
  let at: ModuleData | undefined = module;
  for (let steps = 0; at && steps < graph.modules.length; steps += 1) {
    if (at.channel !== undefined) return at.channel;
    const input: string | undefined = at.inputs[0]?.module;
    at = graph.modules.find((one) => one.name === input);
  }
  return "";
}

function rateOf(channel: string, moments: readonly (MomentData | null)[]): number {
  const channels = moments.flatMap((moment) => moment?.channels ?? []);
  return channels.find((one) => one.channel.name === channel)?.rate ?? 0;
}
