// Words about inferences.

import { idOf } from "../../parts/figure";
import { readable } from "../../parts/numbers";
import type { InferenceReport, UnknownCell, UnknownData } from "../page/unpacked";

export type InferredValue = UnknownCell["from"];

export function inferenceTitle({ systems }: InferenceReport): string {
  const names = systems.map((name) => name.replaceAll("_", " "));
  const listed = names.length > 1 ? `${names.slice(0, -1).join(", ")} and ${names.at(-1)}` : (names[0] ?? "");
  return listed === "" ? "Inference" : `Inference of ${listed}`;
}

/** The id of the section, which is also the begin of the names of its figures. */
export function inferenceId(index: number): string {
  return idOf(index === 0 ? "inference" : `inference-${index + 1}`);
}

export function valueWords(value: InferredValue): string {
  return typeof value === "number" ? readable(value) : String(value);
}

export function cellWords({ from, to }: UnknownCell): string {
  return from === to ? valueWords(from) : `${valueWords(from)} to ${valueWords(to)}`;
}

const kMostListed = 4;

/** Whether the shares of single values say more than their median: for names and few numbers. */
export function isListed({ cells }: UnknownData): boolean {
  const isOrdered = cells.every(({ from }) => typeof from === "number");
  return cells.every(({ from, to }) => from === to) && (!isOrdered || cells.length <= kMostListed);
}

export function claimWords(claim: { system: string; variation: string; text: string }): string {
  return `${claim.variation === "" ? claim.system : `${claim.system}, ${claim.variation}`}: ${claim.text}`;
}

export function unknownWords(name: string): string {
  return name.replaceAll("_", " ");
}
