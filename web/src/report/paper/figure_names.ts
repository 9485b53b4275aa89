// The names of figures on the command line: lower-case words with hyphens, from their ids on the page.

import { idOf } from "../../parts/figure";

const kShort: Record<string, string> = { "overview-map": "map", "claims-results": "claims" };

/** "tensor_chain-u-matrix" of the system "tensor_chain" is "u-matrix", after the `prefix` of the system. */
export function figureName(id: string, system: string, prefix: string): string {
  const start = `${idOf(system)}-`;
  const own = system !== "" && id.startsWith(start) ? id.slice(start.length) : id;
  return slug(`${prefix} ${kShort[own] ?? own.replace(/^(curve-\d+)-.*/s, "$1")}`);
}

export function slug(words: string): string {
  return words.toLowerCase().replaceAll(/[^\p{L}\p{N}]+/gu, "-").replaceAll(/^-|-$/g, "");
}

/** Later ones of the same name have a number. */
export function unique(names: readonly string[]): string[] {
  const taken = new Set<string>();
  return names.map((name) => {
    let free = name;
    for (let number = 2; taken.has(free); number += 1) free = `${name}-${number}`;
    taken.add(free);
    return free;
  });
}
