// Makes a report that has every field, the same every time: a hand on a rectangular plane, probes on
// a hexagonal torus, a variation, and one system of which little is known.

import type { ChannelData, ChannelPlanes, GraphData, GridData, ModuleData, ReceptiveFields, ThingData } from "../src/parts/data";
import type { ClaimReport, CurveReport, MetricData, MomentData, ProtocolData, ReportData, RunData, SystemReport, TrainedData } from "../src/report/data";

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

const round = (value: number) => Math.round(value * 1e4) / 1e4;
const range = (count: number) => Array.from({ length: count }, (_, i) => i);

export function metric(values: number[]): MetricData {
  const mean = values.reduce((sum, value) => sum + value, 0) / values.length;
  const square = values.reduce((sum, value) => sum + (value - mean) ** 2, 0) / Math.max(1, values.length - 1);
  return { mean, sd: Math.sqrt(square), values };
}

const kObjects = ["boccia", "boule", "cylinder", "block_1", "block_2", "block_3"];
const kShapeOf: Record<string, string> = {
  boccia: "sphere", boule: "sphere", cylinder: "cylinder", block_1: "block", block_2: "block", block_3: "block",
};

export function touchElements(): string[] {
  return [1, 2, 3].flatMap((finger) =>
    [["proximal", 7], ["distal", 8]].flatMap(([segment, count]) =>
      range(Number(count)).map((i) => `finger${finger}_${segment}_${i + 1}`),
    ),
  );
}

const kTouch: ChannelData = { name: "touch", unit: "N", elements: touchElements(), shape: [45] };
const kJoints: ChannelData = {
  name: "joints",
  unit: "deg",
  elements: [1, 2, 3].flatMap((finger) => [`finger${finger}_proximal`, `finger${finger}_distal`]),
  shape: [6],
};

function clusteredRun(seed: number, grid: GridData, classes: string[], label: (name: string) => string): RunData {
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
  const predictions = labels.map((name) => (random() < 0.85 ? name : (classes[Math.floor(random() * classes.length)] ?? name)));
  return { seed, recording: 0, winners, labels, predictions, other_predictions: { shape: predictions.map(label) } };
}

function protocol(name: string, group: string | undefined, label: string, runs: RunData[]): ProtocolData {
  const shares = (run: RunData) => run.predictions.filter((one, i) => one === run.labels[i]).length / run.labels.length;
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
      individuals_apart_by_luck: some(0.1),
      areas_connected: either(0.5),
      areas_connected_by_luck: some(0.05),
      with_own: metric(runs.map(() => 25 + Math.floor(random() * 6))),
      with_own_by_luck: metric(runs.map(() => round(5 + 2 * random()))),
      told_exactly: metric(runs.map(() => 4 + Math.floor(random() * 3))),
      told_exactly_by_luck: some(1),
      "mapped_with boccia boule": metric(runs.map(() => Math.floor(random() * 3))),
      "shape.areas_connected": either(0.6),
      "shape.areas_connected_by_luck": some(0.05),
      on_border: some(1),
      on_border_by_luck: metric(runs.map(() => 0.25)),
    });
  }
  const samples = runs[0]?.labels.length ?? 0;
  return { protocol: name, ...(group ? { group } : {}), label, samples, metrics, runs };
}

function module(name: string, type: string, inputs: string[], shape: number[], more: Partial<ModuleData> = {}): ModuleData {
  return {
    name,
    type,
    text: `What a ${type} does.`,
    inputs: inputs.map((one, i) => ({ port: String(i), module: one })),
    shape,
    sparse: false,
    rate: "frame",
    learns: false,
    parameters: {},
    not_given: [],
    ...more,
  };
}

function handGraph(): GraphData {
  return {
    modules: [
      module("height_mm", "channel", [], [1], { channel: "height" }),
      module("height", "one_hot", ["height_mm"], [10]),
      module("wrist_deg", "channel", [], [1], { channel: "wrist" }),
      module("wrist", "one_hot", ["wrist_deg"], [10]),
      module("joints_deg", "channel", [], [6], { channel: "joints" }),
      module("joints", "one_hot", ["joints_deg"], [6, 10]),
      module("touch", "channel", [], [45], { channel: "touch" }),
      module("hand", "t_mpsom", ["wrist", "height"], [5, 5], {
        learns: true,
        parameters: { arbor_sigma: "1.0", combination: '"multiplied"' },
        not_given: ["arbor_sigma"],
      }),
      module("posture", "t_mpsom", ["hand", "joints"], [6, 15], { learns: true }),
      module("felt", "t_mpsom", ["posture", "touch"], [46, 23], { learns: true }),
      module("before", "delay", ["sum"], [46, 23]),
      module("sum", "addition", ["felt", "before"], [46, 23]),
      module("memory", "accumulate", ["sum"], [46, 23], { rate: "exploration" }),
      module("map", "som", ["memory"], [15, 15], { learns: true, rate: "exploration", parameters: { rows: "15", columns: "15" } }),
    ],
    map: "map",
    phases: [
      { learn: ["hand", "posture", "felt"], draws: 5000, of: "frames" },
      { learn: ["map"], draws: 1000, of: "explorations" },
    ],
  };
}

function planes(grid: GridData, channel: ChannelData, unit: string, seed: number): ChannelPlanes {
  const random = randomNumbers(seed);
  const peaks = channel.elements.map(() => [random() * grid.rows, random() * grid.columns]);
  const value = (neuron: number, [row, column]: number[]) => {
    const square = (Math.floor(neuron / grid.columns) - (row ?? 0)) ** 2 + ((neuron % grid.columns) - (column ?? 0)) ** 2;
    return round(Math.exp(-square / 18));
  };
  return { channel, unit, values: range(grid.rows * grid.columns).map((neuron) => peaks.map((peak) => value(neuron, peak))) };
}

function fields(name: string, shape: [number, number], input: string, axis: 0 | 1, elements: number): ReceptiveFields {
  const neurons = range(shape[0] * shape[1]);
  const place = (neuron: number) => (axis === 0 ? Math.floor(neuron / shape[1]) / shape[0] : (neuron % shape[1]) / shape[1]);
  const weights = neurons.map((neuron) =>
    range(elements).map((one) => round(Math.exp(-((one - (place(neuron) + 0.5 / shape[axis]) * elements) ** 2) / 4))),
  );
  return { module: name, shape, input, axis, elements, neurons, weights };
}

function trained(grid: GridData, classes: string[], allPlanes: ChannelPlanes[], receptive: ReceptiveFields[]): TrainedData {
  const random = randomNumbers(9);
  const neurons = range(grid.rows * grid.columns);
  return {
    file: "out/system.somato",
    seed: 1,
    classes,
    neuron_classes: neurons.map(() => (random() < 0.15 ? Math.floor(random() * classes.length) : null)),
    u_matrix: neurons.map((neuron) => round(0.2 + 0.15 * Math.sin(neuron / 7) + 0.05 * random())),
    hits: neurons.map(() => (random() < 0.12 ? 1 + Math.floor(random() * 3) : 0)),
    planes: allPlanes,
    receptive_fields: receptive,
  };
}

const kNoThing = { top_diameter: 0, material: "wood", hardness: "", colour: null, mass: null };

function things(): ThingData[] {
  return [
    { ...kNoThing, name: "boccia", shape: "sphere", size: [80, 80, 80], material: "plastic", hardness: "hard", colour: [0.75, 0.2, 0.18], mass: 0.28 },
    { ...kNoThing, name: "boule", shape: "sphere", size: [74, 74, 74], material: "steel", hardness: "hard", colour: [0.62, 0.64, 0.67], mass: 0.7 },
    { ...kNoThing, name: "cylinder", shape: "cylinder", size: [70, 70, 150], colour: [0.76, 0.6, 0.38], mass: 0.4 },
    { ...kNoThing, name: "block_1", shape: "block", size: [90, 60, 150], colour: [0.35, 0.5, 0.62], mass: 0.6 },
    { ...kNoThing, name: "cone", shape: "cone", size: [80, 80, 120], top_diameter: 30, colour: [0.45, 0.6, 0.4] },
    { ...kNoThing, name: "egg", shape: "ellipsoid", size: [60, 60, 90] },
    { ...kNoThing, name: "pill", shape: "capsule", size: [50, 50, 120], colour: [0.85, 0.75, 0.3] },
    { ...kNoThing, name: "a mesh", shape: "mesh", size: [70, 50, 60] },
    { ...kNoThing, name: "sandpaper", shape: null, size: null, material: "sandpaper", hardness: "rough" },
  ];
}

function moment(name: string, seed: number): MomentData {
  const random = randomNumbers(seed);
  const times = range(60).map((i) => round(i * 0.1));
  const peaks = kTouch.elements.map(() => (random() < 0.35 ? 1 + 4 * random() : 0));
  const touch = times.map((time) => peaks.map((peak) => round(peak / (1 + Math.exp(-(time - 3.5) * 3)))));
  const joints = times.map((time) => kJoints.elements.map((_, i) => round(30 * Math.min(1, time / 4) - (i % 2) * 70 * (1 - time / 6))));
  return {
    labels: { object: name, shape: kShapeOf[name] ?? "", trial: "1" },
    channels: [
      { channel: kTouch, rate: 10, frame: 50, values: touch[50] ?? [], times, series: touch },
      { channel: kJoints, rate: 10, frame: 50, values: joints[50] ?? [], times, series: joints },
      { channel: { name: "height", unit: "mm", elements: ["1"], shape: [1] }, rate: 10, frame: 50, values: [148], times, series: times.map((_, i) => [i < 30 ? 126 : 148]) },
      { channel: { name: "spectrum", unit: "", elements: range(100).map((i) => String(i + 1)), shape: [100] }, rate: 10, frame: 50, values: range(100).map((i) => round(1 / (1 + i))), times: [], series: [] },
    ],
  };
}

const kRectangular: GridData = { rows: 15, columns: 15, lattice: "rectangular", topology: "plane" };
const kHexagonal: GridData = { rows: 10, columns: 12, lattice: "hexagonal", topology: "torus" };

function handSystem(): SystemReport {
  const shapeOf = (name: string) => kShapeOf[name] ?? "";
  const runs = range(20).map((i) => clusteredRun(i + 1, kRectangular, kObjects, shapeOf));
  const outs = range(20).map((i) => clusteredRun(i + 101, kRectangular, kObjects, shapeOf)).map((run, i) => ({ ...run, seed: i + 1 }));
  const labels = runs[0]?.labels ?? [];
  return {
    file: "out/results.json",
    name: "t_mpsom_multiplied",
    variation: "",
    question: "",
    settings: { study: { label: "object", seeds: "20" }, "module.map": { rows: "15", columns: "15" } },
    data_hash: "fnv1a64:a32cd4b13db36891",
    recordings: ["lucs2.mcap"],
    protocols: [protocol("train_is_test", undefined, "object", runs), protocol("leave_group_out", "object", "object", outs)],
    graph: handGraph(),
    grid: kRectangular,
    samples: labels.map((object, i) => ({ object, shape: shapeOf(object), trial: String((i % 5) + 1) })),
    things: things(),
    not_given: [
      { part: "module.hand", name: "arbor_sigma", value: "1.0", text: "Width of the arbor in neurons; not given in the papers." },
      { part: "module.map", name: "learning_rate_start", value: "0.3", text: "Learning rate at the start; not given in the papers." },
    ],
    trained: trained(kRectangular, kObjects, [planes(kRectangular, kTouch, "N", 3), planes(kRectangular, kJoints, "", 4)], [
      fields("hand", [5, 5], "wrist", 0, 10),
      fields("posture", [6, 15], "joints", 1, 60),
    ]),
    moments: kObjects.map((name, i) => moment(name, 50 + i)),
    missing: [],
  };
}

function probeSystem(variation: string): SystemReport {
  const materials = ["cloth", "foam", "sandpaper", "wood", "glass", "rubber", "cardboard", "steel", "leather", "cork"];
  const runs = range(6).map((i) => ({ ...clusteredRun(i + 7, kHexagonal, materials, (name) => (name < "m" ? "soft" : "hard")), recording: i % 2 }));
  return {
    ...handSystem(),
    name: "hardness",
    variation,
    question: variation === "" ? "" : "Does the size of the map matter?",
    recordings: ["probes-1.mcap", "probes-2.mcap"],
    protocols: [protocol("train_is_test", undefined, "material", runs)],
    graph: null,
    grid: kHexagonal,
    samples: null,
    trained: trained(kHexagonal, materials, [planes(kHexagonal, { name: "bits", unit: "", elements: range(18).map((i) => String(i + 1)), shape: [18] }, "", 5)], []),
    moments: [],
    not_given: [],
    missing: [],
  };
}

function bareSystem(): SystemReport {
  return {
    ...handSystem(),
    name: "bare",
    protocols: [],
    graph: null,
    grid: null,
    samples: null,
    things: [],
    not_given: [],
    trained: null,
    moments: [],
    settings: {},
    missing: ["The trained system is not here: run somato run with --out and keep system.somato beside results.json."],
  };
}

function claim(system: SystemReport, text: string, name: string, least: number, published: number | null): ClaimReport {
  const values = system.protocols[0]?.metrics[name]?.values ?? [];
  const luck = system.protocols[0]?.metrics[`${name}_by_luck`]?.mean ?? null;
  return {
    file: system.file,
    system: system.name,
    variation: system.variation,
    question: system.question,
    text,
    paper: published === null ? "" : "P11 II-C",
    metric: name,
    protocol: "train_is_test",
    group: "",
    than: "",
    published,
    at_least: least,
    at_most: null,
    values,
    by_luck: luck,
    share: values.filter((value) => value >= least).length / Math.max(1, values.length),
  };
}

function curves(): CurveReport[] {
  const random = randomNumbers(77);
  const line = (name: string, slope: number) => ({
    name,
    points: range(7).map((x) => {
      const values = range(10).map(() => round(Math.max(0, 1 - slope * x + 0.1 * (random() - 0.5))));
      return { x, ...metric(values) };
    }),
  });
  const lines = [line("tensor_chain", 0.04), line("t_mpsom_multiplied", 0.07), line("nearest neighbour", 0.02)];
  return [{ title: "Named rightly by how carefully things are placed", x: "placement noise", unit: "mm", metric: "accuracy", lines }];
}

export function reportFixture(): ReportData {
  const hand = handSystem();
  const probe = probeSystem("");
  const systems = [hand, probe, probeSystem("torus_10x12"), bareSystem()];
  const claims = [
    claim(hand, "At least 29 of 30 explorations lie with their object", "with_own", 29, 29),
    claim(hand, "All six objects are told apart", "individuals_apart", 1, 1),
    claim(hand, "Each exploration is named rightly in most runs", "accuracy", 0.5, null),
    claim(probe, "At least three materials are told exactly", "told_exactly", 3, 3),
  ];
  return { version: 1, somato: "0.0.0", systems, claims, curves: curves() };
}

/** Names and texts as nobody should have them, and numbers that are none. */
export function hostileFixture(): ReportData {
  const nasty = `</script><img src=x onerror="window.__hurt=1">'"&amp; ${"very long ".repeat(40)}`;
  const system = handSystem();
  const first = system.protocols[0];
  const none = null as unknown as number;
  if (first) {
    first.metrics["accuracy"] = { mean: none, sd: none, values: [none, 0.5, none] };
    first.runs = first.runs.slice(0, 3).map((run) => ({ ...run, labels: run.labels.map((one) => (one === "boccia" ? nasty : one)) }));
  }
  const touch = system.trained?.planes[0];
  if (touch?.values[0]) touch.values[0] = touch.values[0].map(() => none);
  if (system.trained) system.trained.u_matrix = system.trained.u_matrix.map((value, i) => (i < 30 ? none : value));
  const hostile: SystemReport = {
    ...system,
    name: nasty,
    recordings: [],
    file: nasty,
    things: system.things.map((thing) => ({ ...thing, name: nasty })),
    not_given: [{ part: nasty, name: nasty, value: nasty, text: nasty }],
    missing: [nasty],
    moments: [{ labels: { object: nasty }, channels: [] }],
  };
  const empty: SystemReport = { ...bareSystem(), name: "", file: "", question: nasty, missing: [], protocols: [{ protocol: "train_is_test", label: "", samples: 0, metrics: {}, runs: [] }], things: [] };
  const nastyClaim: ClaimReport = { ...claim(hostile, nasty, "accuracy", 1, 1), share: none, values: [none], published: none };
  return { version: 1, somato: nasty, systems: [hostile, empty], claims: [nastyClaim], curves: [{ title: nasty, x: nasty, unit: nasty, metric: nasty, lines: [{ name: nasty, points: [] }] }] };
}

/** Many and large systems. */
export function largeFixture(): ReportData {
  const grid: GridData = { rows: 30, columns: 30, lattice: "rectangular", topology: "plane" };
  const hand = handSystem();
  const runs = range(500).map((i) => clusteredRun(i + 1, grid, kObjects, (name) => kShapeOf[name] ?? ""));
  const large: SystemReport = {
    ...hand,
    grid,
    protocols: [protocol("train_is_test", undefined, "object", runs)],
    trained: trained(grid, kObjects, [planes(grid, kTouch, "N", 3)], []),
  };
  const systems = range(30).map((i) => ({ ...large, name: `system_${i + 1}` }));
  return { ...reportFixture(), systems, claims: [] };
}
