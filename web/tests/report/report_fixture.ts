// Makes reports, the same every time: one that has every field, one with invalid names, and a
// large one.

import type { GridData } from "../../src/parts/data";
import type { ClaimReport, CurveReport, ReportData, SystemReport } from "../../src/report/page/unpacked";
import { emptySystem } from "../../src/report/page/read";
import {
  clusteredRun,
  kObjects,
  kShapeOf,
  metric,
  protocol,
  randomNumbers,
  range,
  round,
} from "./report_runs";
import { bareSystem, claim, handSystem, probeSystem } from "./report_systems";
import { kTouch } from "./report_things";
import { planes, trained } from "./report_trained";

function curves(): CurveReport[] {
  const random = randomNumbers(77);
  const line = (name: string, slope: number) => ({
    name,
    points: range(7).map((x) => {
      const values = range(10).map(() => round(Math.max(0, 1 - slope * x + 0.1 * (random() - 0.5))));
      return { x, ...metric(values) };
    }),
  });
  const lines = [
    line("tensor_chain", 0.04),
    line("t_mpsom_multiplied", 0.07),
    line("nearest neighbour", 0.02),
  ];
  return [
    {
      title: "Named rightly by how carefully things are placed",
      x: "placement noise",
      unit: "mm",
      metric: "accuracy",
      lines,
    },
  ];
}

export function reportFixture(): ReportData {
  const hand = handSystem();
  const probe = probeSystem("");
  const systems = [hand, probe, probeSystem("torus_10x12"), bareSystem()];
  const claims = [
    claim(hand, "At least 29 of 30 explorations lie with their object", "neighbours_same_class", 29, 29),
    claim(hand, "All six objects are separated", "individuals_apart", 1, 1),
    claim(hand, "Each exploration is named rightly in most runs", "accuracy", 0.5, null),
    claim(probe, "At least three materials are separated", "classes_separated", 3, 3),
  ];
  return { version: 2, somato: "0.0.0", systems, claims, curves: curves() };
}

/** Invalid names and texts, and invalid numbers. */
export function hostileFixture(): ReportData {
  const nasty = `</script><img src=x onerror="window.__hurt=1">'"&amp; ${"very long ".repeat(40)}`;
  const system = handSystem();
  const first = system.protocols[0];
  const none = null as unknown as number;
  if (first) {
    first.metrics["accuracy"] = { mean: none, sd: none, values: [none, 0.5, none] };
    first.runs = first.runs
      .slice(0, 3)
      .map((run) => ({ ...run, labels: run.labels.map((one) => (one === "boccia" ? nasty : one)) }));
  }
  const touch = system.trained?.planes[0];
  if (touch?.values[0]) touch.values[0] = touch.values[0].map(() => none);
  if (system.trained)
    system.trained.u_matrix = system.trained.u_matrix.map((value, i) => (i < 30 ? none : value));
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
  const empty: SystemReport = {
    ...emptySystem(),
    question: nasty,
    protocols: [{ protocol: "train_is_test", label: "", samples: 0, metrics: {}, runs: [] }],
  };
  const nastyClaim: ClaimReport = {
    ...claim(hostile, nasty, "accuracy", 1, 1),
    share: none,
    values: [none],
    published: none,
  };
  const curveLine = { name: nasty, points: [{ x: 1, mean: null, sd: null, values: [null] }] };
  return {
    version: 2,
    somato: nasty,
    systems: [hostile, empty],
    claims: [nastyClaim],
    curves: [{ title: nasty, x: nasty, unit: nasty, metric: nasty, lines: [curveLine] }],
  };
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
