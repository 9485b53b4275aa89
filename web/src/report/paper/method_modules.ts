// The sentences of the methods about the modules of a system and its output map.

import { neuronCount } from "../../parts/maps/grid";
import { graphOf } from "../../parts/maps/neuron_graph";
import { countOf } from "../../parts/numbers";
import type { SystemReport } from "../page/unpacked";
import type { Sentence } from "./cited_text";
import { inWords } from "./printed";
import { papersOfType } from "./references";
import type { SettingsLeft } from "./settings_left";

export function moduleSentences(left: SettingsLeft, system: SystemReport): Sentence[] {
  const map = mapOf(left);
  return [
    ...left.modules(map).map((part) => moduleSentence(left, part)),
    ...(map === null ? [] : mapSentences(left, map, system)),
  ];
}

/** The output map: the only one, or that of which no other module takes the output. */
function mapOf(left: SettingsLeft): string | null {
  return left.parts(/^module\./).filter((part) => kMaps.has(left.type(part))).at(-1) ?? null;
}

const kMaps = new Map([
  ["som", "a self-organizing map"],
  ["growing_when_required", "a map that grows when required"],
  ["growing_cells", "a map of growing cells"],
  ["growing_grid", "a growing grid"],
]);

function moduleSentence(left: SettingsLeft, part: string): Sentence {
  const type = left.take(part, "type");
  const kind = kMaps.get(type) ?? `a module of the type ${inWords(type)}`;
  const name = inWords(part.replace(/^module\./, ""));
  return [`The module ${name} is ${kind}`, papersOfType(type), `${left.listed(part)}.`];
}

function mapSentences(left: SettingsLeft, part: string, system: SystemReport): Sentence[] {
  const type = left.take(part, "type");
  const input = inWords(left.take(part, "input"));
  const first: Sentence = [`The output map is ${kMaps.get(type)}${sizeWords(system)}`, papersOfType(type), ` with the input ${input}.`];
  if (left.look(part, "iterations") === "") return [first, left.sentence(part, "It was trained")];
  const take = (name: string) => inWords(left.take(part, name));
  const learning = `It was trained for ${take("iterations")} iterations (${take("training")}); the learning rate changed from ${take("learning_rate_start")} to ${take("learning_rate_end")} (${take("learning_rate_schedule")} schedule), and the radius of the neighbourhood (${take("neighbourhood")}) from ${take("radius_start")} to ${take("radius_end")} (${take("radius_schedule")} schedule).`;
  return [first, [learning], left.sentence(part, "Map and training were set up")];
}

function sizeWords({ grid }: SystemReport): string {
  if (!grid) return "";
  return graphOf(grid) ? ` of ${countOf(neuronCount(grid), "neuron")}` : ` of ${grid.rows} × ${grid.columns} neurons`;
}
