import type { Training } from "./data";

/** For each neuron the class, by its place in `names`, that it won most of; null where it won none. */
export function mostOften(winners: Training["winners"], names: readonly string[], neurons: number): (number | null)[] {
  const counts = new Map<number, number[]>();
  for (const { winner, class: name } of winners) {
    const of = counts.get(winner) ?? names.map(() => 0);
    const at = names.indexOf(name);
    of[at] = (of[at] ?? 0) + 1;
    counts.set(winner, of);
  }
  return Array.from({ length: neurons }, (_, neuron) => {
    const of = counts.get(neuron);
    return of === undefined ? null : of.indexOf(Math.max(...of));
  });
}
