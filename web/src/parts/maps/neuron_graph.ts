// The graph of a map that grows: neurons that edges connect, each in a cell of a drawing.

import type { GridData } from "../data";

export interface NeuronGraph {
  edges: readonly [number, number][];
  cells: readonly [row: number, column: number][];
  rows: number; // of the drawing
  columns: number;
  neuronIn(row: number, column: number): number | null;
  steps(from: number, to: number): number; // edges on the shortest path; Infinity without a path
}

const known = new WeakMap<GridData, NeuronGraph | null>();

/** The graph of a map that has one instead of rows and columns; else null. */
export function graphOf(grid: GridData): NeuronGraph | null {
  const found = known.get(grid);
  if (found !== undefined) return found;
  const made = grid.edges && grid.cells ? graphFrom(grid.edges as [number, number][], grid.cells as [number, number][]) : null;
  known.set(grid, made);
  return made;
}

function graphFrom(edges: [number, number][], cells: [number, number][]): NeuronGraph {
  const columns = 1 + Math.max(0, ...cells.map(([, column]) => column));
  const places = new Map(cells.map(([row, column], neuron) => [row * columns + column, neuron]));
  const neighbours = neighboursOf(cells.length, edges);
  const steps = new Map<number, number[]>();
  return {
    edges,
    cells,
    rows: 1 + Math.max(0, ...cells.map(([row]) => row)),
    columns,
    neuronIn: (row, column) => places.get(row * columns + column) ?? null,
    steps: (from, to) => {
      const all = steps.get(from) ?? stepsFrom(from, neighbours);
      steps.set(from, all);
      return all[to] ?? Number.POSITIVE_INFINITY;
    },
  };
}

function neighboursOf(neurons: number, edges: readonly [number, number][]): number[][] {
  const neighbours = Array.from({ length: neurons }, (): number[] => []);
  for (const [one, other] of edges) {
    neighbours[one]?.push(other);
    neighbours[other]?.push(one);
  }
  return neighbours;
}

function stepsFrom(from: number, neighbours: readonly number[][]): number[] {
  const steps = neighbours.map(() => Number.POSITIVE_INFINITY);
  steps[from] = 0;
  for (let reached = [from], step = 1; reached.length > 0; step += 1) {
    const next = reached.flatMap((neuron) => neighbours[neuron] ?? []);
    reached = [...new Set(next)].filter((neuron) => steps[neuron] === Number.POSITIVE_INFINITY);
    for (const neuron of reached) steps[neuron] = step;
  }
  return steps;
}
