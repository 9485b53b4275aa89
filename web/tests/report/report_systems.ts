// Made-up systems of the report's fixture: a hand on a rectangular plane, probes on a hexagonal torus,
// a variation, and one system of which little is known.

import type { GridData } from "../../src/parts/data";
import type { ClaimReport, SystemReport } from "../../src/report/page/unpacked";
import { emptySystem } from "../../src/report/page/read";
import { clusteredRun, kObjects, kShapeOf, protocol, range, withMaps } from "./report_runs";
import { kJoints, kTouch, moment, things } from "./report_things";
import { deciding, fields, handGraph, planes, trained } from "./report_trained";

const kRectangular: GridData = { rows: 15, columns: 15, lattice: "rectangular", topology: "plane" };
const kHexagonal: GridData = { rows: 10, columns: 12, lattice: "hexagonal", topology: "torus" };

/** A summary of the second protocol. */
function summary(): SystemReport["summary"] {
  return {
    protocol: 1,
    accuracy: 0.85,
    deviation: 0.02,
    baseline: 0.9,
    chance: 1 / 6,
    confusions: [{ label: "boccia", predicted: "boule", count: 7, of: 100 }],
    sentences: ["The map is 5.0 points below the best nearest neighbour, 0.900 (manhattan, raw)."],
    next: [
      {
        text: "Play explorations of 'boccia' and 'boule', and compare their readings.",
        commands: ["somato view lucs2.mcap --model out/system.somato"],
        page: "docs/live.md",
      },
    ],
  };
}

export function handSystem(): SystemReport {
  const shapeOf = (name: string) => kShapeOf[name] ?? "";
  const runs = withMaps(
    kRectangular,
    range(20).map((i) => clusteredRun(i + 1, kRectangular, kObjects, shapeOf)),
  );
  const outs = range(20)
    .map((i) => clusteredRun(i + 101, kRectangular, kObjects, shapeOf))
    .map((run, i) => ({ ...run, seed: i + 1 }));
  const labels = runs[0]?.labels ?? [];
  return {
    file: "out/results.json",
    name: "t_mpsom_multiplied",
    variation: "",
    question: "",
    settings: { study: { label: "object", seeds: "20" }, "module.map": { rows: "15", columns: "15" } },
    data_hash: "fnv1a64:a32cd4b13db36891",
    summary: summary(),
    recordings: ["lucs2.mcap"],
    protocols: [
      protocol("train_is_test", undefined, "object", runs),
      { ...protocol("leave_group_out", "object", "object", outs), folds: labels.map((name) => kObjects.indexOf(name)) },
    ],
    graph: handGraph(),
    grid: kRectangular,
    samples: labels.map((object, i) => ({ object, shape: shapeOf(object), trial: String((i % 5) + 1) })),
    things: things(),
    not_given: [
      {
        part: "module.hand",
        name: "arbor_sigma",
        value: "1.0",
        text: "Width of the arbor in neurons; not given in the papers.",
      },
      {
        part: "module.map",
        name: "learning_rate_start",
        value: "0.3",
        text: "Learning rate at the start; not given in the papers.",
      },
    ],
    trained: trained(
      kRectangular,
      kObjects,
      [planes(kRectangular, kTouch, "N", 3), planes(kRectangular, kJoints, "", 4)],
      [fields("hand", [5, 5], "wrist", 0, 10), fields("posture", [6, 15], "joints", 1, 60)],
    ),
    deciding: deciding([kTouch, kJoints], kObjects),
    recording: 0,
    moments: labels.map((object, i) => moment(object, 50 + i, (i % 5) + 1)),
    missing: [],
  };
}

export function probeSystem(variation: string): SystemReport {
  const materials = [
    "cloth",
    "foam",
    "sandpaper",
    "wood",
    "glass",
    "rubber",
    "cardboard",
    "steel",
    "leather",
    "cork",
  ];
  const runs = range(6).map((i) => ({
    ...clusteredRun(i + 7, kHexagonal, materials, (name) => (name < "m" ? "soft" : "hard")),
    recording: i % 2,
  }));
  return {
    ...handSystem(),
    name: "hardness",
    variation,
    question: variation === "" ? "" : "Does the size of the map matter?",
    recordings: ["probes-1.mcap", "probes-2.mcap"],
    recording: null,
    protocols: [protocol("train_is_test", undefined, "material", runs)],
    graph: null,
    grid: kHexagonal,
    samples: null,
    trained: trained(
      kHexagonal,
      materials,
      [
        planes(
          kHexagonal,
          { name: "bits", unit: "", elements: range(18).map((i) => String(i + 1)), shape: [18] },
          "",
          5,
        ),
      ],
      [],
    ),
    deciding: null,
    moments: [],
    not_given: [],
    missing: [],
  };
}

/** A map that grows: a graph, which has another neuron in the second training. */
export function growingSystem(): SystemReport {
  const hand = handSystem();
  const grids = [star(5), star(6)];
  const runs = grids.map((grid, i) => ({
    ...clusteredRun(i + 1, { ...grid, rows: 1, columns: 5 }, ["boccia", "boule"], (name) => name),
    map: { grid, u_matrix: range(grid.columns), edge_distances: (grid.edges ?? []).map((_, edge) => edge + 1) },
  }));
  const graph = hand.graph!;
  const map = { ...graph.modules.at(-1)!, type: "growing_cells" };
  return {
    ...hand,
    name: "growing",
    protocols: [
      protocol("train_is_test", undefined, "object", runs),
      protocol("leave_group_out", "trial", "object", runs.map(({ map: _, ...run }) => run)),
    ],
    graph: { ...graph, modules: [...graph.modules.slice(0, -1), map] },
    grid: grids[0]!,
    trained: trained(grids[0]!, ["boccia", "boule"], [planes(grids[0]!, kTouch, "N", 3)], []),
    deciding: null,
    samples: null,
    moments: [],
  };
}

/** Neuron 0 is connected with each other one; 0 is in the middle of a row of cells. */
function star(neurons: number): GridData {
  const columns = range(neurons).map((i) => (i === 0 ? 2 : i <= 2 ? i - 1 : i));
  return {
    rows: 1,
    columns: neurons,
    lattice: "rectangular",
    topology: "plane",
    edges: range(neurons - 1).map((i) => [0, i + 1]),
    cells: columns.map((column, i) => [i === 0 ? 1 : i % 2 === 0 ? 0 : 2, column]),
  };
}

export function bareSystem(): SystemReport {
  const { file, data_hash, recordings } = handSystem();
  const missing =
    "The trained system is not here: run somato run with --out and keep system.somato beside results.json.";
  return { ...emptySystem(), name: "bare", file, data_hash, recordings, missing: [missing] };
}

export function claim(
  system: SystemReport,
  text: string,
  name: string,
  least: number,
  published: number | null,
): ClaimReport {
  const values = system.protocols[0]?.metrics[name]?.values ?? [];
  const isMet = (value: number | null) => value !== null && value >= least;
  const chance = system.protocols[0]?.metrics[`${name}_chance`]?.mean ?? null;
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
    than_metric: "",
    published,
    at_least: least,
    at_most: null,
    values,
    by_chance: chance,
    chance_share: null,
    verdict: values.every(isMet) ? "holds" : "mostly",
    reason: "",
    share: values.filter(isMet).length / Math.max(1, values.length),
  };
}
