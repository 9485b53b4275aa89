import type { Training } from "../data";

/** For each neuron the most frequent class of its samples, as an index in `names`; null for none. */
export function mostOften(
  winners: Training["winners"],
  names: readonly string[],
  neurons: number,
): (number | null)[] {
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
