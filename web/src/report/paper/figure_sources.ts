// The parts of a report that have figures, each of which is drawn without controls.

import type { Child } from "../../parts/dom";
import { curvesSection } from "../maps/curves";
import { inferenceSection } from "../inference/section";
import { groupsOf, questionsOf, type Numbered } from "../page/groups";
import { overviewSection } from "../page/overview";
import { questionFigures } from "../page/question";
import { Selection } from "../page/selection";
import type { ReportData } from "../page/unpacked";
import { systemName } from "../page/words";
import { claimsSection } from "../tables/claims";
import { systemFigures } from "../tables/system";
import { slug } from "./figure_names";

export interface Source {
  system: string; // its name; "" for a part about all systems
  prefix: string; // of the names of its figures
  selection: Selection | null;
  make: () => Child[];
}

export function sourcesOf(data: ReportData): Source[] {
  const whole = (make: () => Child[]): Source => ({ system: "", prefix: "", selection: null, make });
  const questions = questionsOf(data);
  return [
    whole(() => [overviewSection(data)]),
    ...(data.inferences ?? []).map((inference, i) => whole(() => [inferenceSection(inference, i)])),
    ...groupsOf(data).flatMap(({ systems }) => systems.map((one) => systemSource(one, "", data))),
    ...questions.map((question) => whole(() => questionFigures(question, data))),
    ...questions.flatMap(({ name, systems }) => systems.map((one) => systemSource(one, slug(name), data))),
    ...(data.curves.length > 0 ? [whole(() => [curvesSection(data)])] : []),
    ...(data.claims.length > 0 ? [whole(() => [claimsSection(data)])] : []),
  ];
}

/** The only system of a report is not named. */
function systemSource({ system }: Numbered, question: string, data: ReportData): Source {
  const selection = new Selection(system);
  const name = systemName(system);
  const prefix = data.systems.length === 1 ? "" : `${question} ${name}`;
  return { system: name, prefix, selection, make: () => systemFigures(selection, data) };
}
