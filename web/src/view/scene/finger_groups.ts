// The fingers that the touch sensors of a channel belong to, as rows of a strip.

/** Consecutive elements of one finger: the first, the number, and the name. */
export interface Group {
  name: string;
  first: number;
  count: number;
}

const kMost = 12;

/** By their names, such as "finger1_proximal_3"; [] if they do not name fingers. */
export function fingerGroups(elements: readonly string[]): Group[] {
  const groups: Group[] = [];
  for (const [i, element] of elements.entries()) {
    const finger = /^(?:taxel_)?(.+?)_(?:proximal|middle|distal|tip)/.exec(element)?.[1];
    if (finger === undefined) return [];
    const last = groups.at(-1);
    if (last?.name === finger) last.count += 1;
    else groups.push({ name: finger, first: i, count: 1 });
  }
  return groups.length <= kMost ? groups : [];
}
