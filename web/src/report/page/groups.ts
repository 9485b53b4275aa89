// The sections of systems: one for each original system with its variations, and one for each
// question, whose systems are opened from a table because they are many.

import { idOf } from "../../parts/figure";
import { capital } from "../../parts/numbers";
import { addressOf } from "./address";
import type { Placed } from "./same_names";
import type { ReportData, SystemReport } from "./unpacked";
import { systemName } from "./words";

export interface Numbered {
  system: Placed<SystemReport>;
  index: number; // in the report
  link: string; // the address of its section
}

/** A system and its variations. */
export interface Group {
  id: string; // of its section
  name: string;
  systems: Numbered[];
}

export interface Question {
  id: string;
  name: string;
  systems: Numbered[];
}

export function groupsOf(data: ReportData): Group[] {
  const groups = new Map<string, Group>();
  for (const [index, system] of data.systems.entries()) {
    if (system.question !== "") continue;
    const key = JSON.stringify([system.file, system.name]);
    const name = systemName({ ...system, variation: "" });
    const group = groups.get(key) ?? { id: newId(name, groups), name, systems: [] };
    groups.set(key, group);
    group.systems.push({ system, index, link: addressOf(group.id, { variation: system.variation }) });
  }
  return [...groups.values()];
}

function newId(name: string, groups: Map<string, Group>): string {
  const taken = new Set([...kFixed, ...[...groups.values()].map(({ id }) => id)]);
  const id = idOf(name);
  return taken.has(id) ? `${id}-${groups.size + 1}` : id;
}

const kFixed = ["overview", "systems", "claims", "curves", "compare", "inference", "report", "report-data"];

export function questionsOf(data: ReportData): Question[] {
  const questions = new Map<string, Question>();
  for (const [index, system] of data.systems.entries()) {
    const { question, file } = system;
    if (question === "") continue;
    const key = JSON.stringify([file, question]);
    const id = `question-${questions.size + 1}`;
    const one = questions.get(key) ?? { id, name: capital(question), systems: [] };
    questions.set(key, one);
    one.systems.push({ system, index, link: `#${one.id}-system-${one.systems.length + 1}` });
  }
  return [...questions.values()];
}

/** "touch_change" as the start of a title. */
