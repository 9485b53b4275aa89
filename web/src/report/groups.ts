// Original systems, and the systems of questions: the latter are many, so each question has one
// section with a table from which its systems can be opened.

import type { ReportData, SystemReport } from "./data";

export interface Numbered {
  system: SystemReport;
  index: number; // in the report
}

export interface Question {
  id: string;
  name: string;
  systems: Numbered[];
}

export function standing(data: ReportData): Numbered[] {
  return numbered(data).filter(({ system }) => system.question === "");
}

export function questionsOf(data: ReportData): Question[] {
  const questions = new Map<string, Numbered[]>();
  for (const one of numbered(data)) {
    const { question, file } = one.system;
    if (question === "") continue;
    const key = JSON.stringify([file, question]);
    questions.set(key, [...(questions.get(key) ?? []), one]);
  }
  return [...questions.values()].map((systems, i) => ({
    id: `question-${i + 1}`,
    name: capital(systems[0]?.system.question ?? ""),
    systems,
  }));
}

export const systemId = (index: number) => `system-${index + 1}`;

/** "touch_change" as the start of a title. */
export function capital(name: string): string {
  const words = name.replaceAll("_", " ");
  return words.slice(0, 1).toUpperCase() + words.slice(1);
}

function numbered(data: ReportData): Numbered[] {
  return data.systems.map((system, index) => ({ system, index }));
}
