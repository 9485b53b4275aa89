// Made-up runs of the report's fixture: winners that lie together by class, and what is measured.

import type { GridData } from "../../src/parts/data";
import type { MetricData, ProtocolData, RunData } from "../../src/report/page/unpacked";

/** Random numbers from 0 to 1 by mulberry32, so that the fixture never changes. */
export function randomNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 4294967296;
  };
}

export const round = (value: number) => Math.round(value * 1e4) / 1e4;
export const range = (count: number) => Array.from({ length: count }, (_, i) => i);

export function metric(values: number[]): MetricData {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const square = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / Math.max(1, values.length - 1);
  return { mean, sd: Math.sqrt(square), values };
}

export const kObjects = ["boccia", "boule", "cylinder", "block_1", "block_2", "block_3"];

export const kShapeOf: Record<string, string> = {
  boccia: "sphere",
  boule: "sphere",
  cylinder: "cylinder",
  block_1: "block",
  block_2: "block",
  block_3: "block",
};

export function clusteredRun(
  seed: number,
  grid: GridData,
  classes: string[],
  label: (name: string) => string,
): RunData {
  const random = randomNumbers(seed);
  const neurons = grid.rows * grid.columns;
  const labels = classes.flatMap((name) => range(5).map(() => name));
  const middles = new Map(classes.map((name) => [name, Math.floor(random() * neurons)]));
  const winners = labels.map((name) => {
    const middle = middles.get(name) ?? 0;
    const row = Math.floor(middle / grid.columns) + Math.floor(random() * 3) - 1;
    const column = (middle % grid.columns) + Math.floor(random() * 3) - 1;
    const clamp = (value: number, size: number) => Math.min(size - 1, Math.max(0, value));
    return clamp(row, grid.rows) * grid.columns + clamp(column, grid.columns);
  });
  const predictions = labels.map((name) =>
    random() < 0.85 ? name : (classes[Math.floor(random() * classes.length)] ?? name),
  );
  return {
    seed,
    recording: 0,
    winners,
    labels,
    predictions,
    other_predictions: { shape: predictions.map(label) },
  };
}

/** Another one for each seed. */
export function uMatrixOf(grid: GridData, seed: number): number[] {
  const random = randomNumbers(90 + seed);
  return range(grid.rows * grid.columns).map((neuron) => round(0.2 + 0.15 * Math.sin(neuron / 7 + seed) + 0.05 * random()));
}

/** The same runs with the maps of results.json. */
export function withMaps(grid: GridData, runs: RunData[]): RunData[] {
  return runs.map((run) => ({ ...run, map: { grid, u_matrix: uMatrixOf(grid, run.seed) } }));
}

export function protocol(
  name: string,
  group: string | undefined,
  label: string,
  runs: RunData[],
): ProtocolData {
  const shares = (run: RunData) =>
    run.predictions.filter((one, i) => one === run.labels[i]).length / run.labels.length;
  const random = randomNumbers(runs.length + name.length);
  const some = (scale: number) => metric(runs.map(() => round(random() * scale)));
  const either = (share: number) => metric(runs.map(() => (random() < share ? 1 : 0)));
  const metrics: Record<string, MetricData> = {
    accuracy: metric(runs.map(shares)),
    baseline_accuracy: metric(runs.map(() => 0.9)),
    baseline_accuracy_raw: metric(runs.map(() => 0.9)),
    baseline_accuracy_standardized: metric(runs.map(() => 0.85)),
    "shape.accuracy": some(1),
    "shape.baseline_accuracy": metric(runs.map(() => 0.95)),
    quantization_error: metric(runs.map(() => round(0.4 + 0.1 * random()))),
    topographic_error: some(0.1),
  };
  if (name === "train_is_test") {
    Object.assign(metrics, {
      individuals_apart: either(0.7),
      individuals_apart_chance: some(0.1),
      areas_connected: either(0.5),
      areas_connected_chance: some(0.05),
      neighbours_same_class: metric(runs.map(() => 25 + Math.floor(random() * 6))),
      neighbours_same_class_chance: metric(runs.map(() => round(5 + 2 * random()))),
      classes_separated: metric(runs.map(() => 4 + Math.floor(random() * 3))),
      classes_separated_chance: some(1),
      "mapped_with boccia boule": metric(runs.map(() => Math.floor(random() * 3))),
      "shape.areas_connected": either(0.6),
      "shape.areas_connected_chance": some(0.05),
      on_border: some(1),
      on_border_chance: metric(runs.map(() => 0.25)),
    });
  }
  const samples = runs[0]?.labels.length ?? 0;
  return { protocol: name, ...(group ? { group } : {}), label, samples, metrics, runs };
}
