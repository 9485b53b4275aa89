// The areas of the classes on a map, defined in docs/reference/results.md: a neuron belongs to the
// class of the winner nearest to it; among equally near winners to the class with most samples at
// them, then to the class that comes first.

import type { GridData } from "../data";
import { neuronCount, squaredDistance } from "./grid";

/** The class of each neuron, where winners[i] is the winner of a sample of class classes[i]; null
 * without samples. */
export function areasOf(
  grid: GridData,
  winners: readonly number[],
  classes: readonly number[],
): (number | null)[] {
  const won = wonBy(winners, classes);
  const areas: (number | null)[] = [];
  for (let neuron = 0; neuron < neuronCount(grid); neuron += 1) areas.push(nearest(grid, neuron, won));
  return areas;
}

/** For each winner the number of samples of each class. */
export function wonBy(
  winners: readonly number[],
  classes: readonly number[],
): Map<number, Map<number, number>> {
  const won = new Map<number, Map<number, number>>();
  winners.forEach((winner, i) => {
    const counts = won.get(winner) ?? new Map<number, number>();
    const number = classes[i] ?? 0;
    won.set(winner, counts.set(number, (counts.get(number) ?? 0) + 1));
  });
  return won;
}

const kEqual = 1e-9; // distances on a hexagonal lattice are rounded

function nearest(grid: GridData, neuron: number, won: Map<number, Map<number, number>>): number | null {
  let least = Number.POSITIVE_INFINITY;
  let counts = new Map<number, number>();
  for (const [winner, of] of won) {
    const distance = squaredDistance(grid, neuron, winner);
    if (distance > least + kEqual) continue;
    if (distance < least - kEqual) counts = new Map();
    least = Math.min(least, distance);
    for (const [number, samples] of of) counts.set(number, (counts.get(number) ?? 0) + samples);
  }
  return most(counts);
}

function most(counts: Map<number, number>): number | null {
  let best: number | null = null;
  for (const [number, samples] of counts) {
    const lead = best === null ? 1 : samples - (counts.get(best) ?? 0);
    if (lead > 0 || (lead === 0 && best !== null && number < best)) best = number;
  }
  return best;
}
