// An inference with every field, and one whose texts and numbers are invalid.

import type { InferenceReport, SupportedClaim } from "../../src/report/page/unpacked";

const kClaim: SupportedClaim = {
  text: "At least seven materials are separated",
  paper: "P11 IV-F",
  system: "press",
  variation: "",
  metric: "classes_separated",
  protocol: "train_is_test",
  than: "",
  than_metric: "",
  published: 7,
  at_least: 7,
  at_most: null,
  prior: 0.25,
  left_out: 0.375,
  fresh: 0.95,
  chance: 0.1,
  fresh_chance: 0.125,
  fresh_verdict: "holds",
  fresh_verdict_as_written: "compatible",
  support: "explained",
};

export function inferenceFixture(): InferenceReport {
  const claims: SupportedClaim[] = [
    kClaim,
    { ...kClaim, text: "It never holds", prior: 0, fresh: 0, support: "excluded", fresh_verdict: "fails", fresh_verdict_as_written: "fails" },
    { ...kClaim, text: "It compares", than: "chain", than_metric: "classes_separated", left_out: null, fresh_chance: null, support: "reachable" },
  ];
  return {
    file: "out/inference.json",
    systems: ["press", "tensor_chain"],
    draws: 1024,
    pairs: 4,
    accepted: 81,
    adjusted: true,
    bodies: 20,
    fresh_pairs: 5,
    targets: [
      { text: "Three are separated", paper: "P11", system: "press", variation: "small", metric: "classes_separated", protocol: "train_is_test", observed: 3, scale: 1.5, prior: 5.25, posterior: 3.5 },
    ],
    unknowns: [
      {
        name: "learning_rate",
        text: "No paper gives it.",
        system: "0.3",
        key: ["module.map.learning_rate_start"],
        cells: [
          { from: 0.05, to: 0.2, prior: 0.5, posterior: 0.25 },
          { from: 0.2, to: 0.9, prior: 0.5, posterior: 0.75 },
        ],
        prior: { low: 0.06, median: 0.2, high: 0.8 },
        posterior: { low: 0.1, median: 0.5, high: 0.7 },
        shrinkage: 0.625,
      },
      {
        name: "similarity",
        text: "Open.",
        system: '"dot_product"',
        key: ["module.map.similarity"],
        cells: [
          { from: "dot_product", to: "dot_product", prior: 0.5, posterior: 0.375 },
          { from: "euclidean", to: "euclidean", prior: 0.5, posterior: 0.625 },
        ],
        prior: { low: "dot_product", median: "dot_product", high: "euclidean" },
        posterior: { low: "dot_product", median: "euclidean", high: "euclidean" },
        shrinkage: 0.97,
      },
    ],
    dependences: [
      { first: "learning_rate", second: "similarity", correlation: -0.5 },
      { first: "learning_rate", second: "learning_rate", correlation: 0.1 },
    ],
    truths: 4,
    calibration: [
      { name: "learning_rate", covered: 0.75, uniform_p: 0.5, ranks: [0.1, 0.4, 0.6, 0.99] },
      { name: "similarity", covered: 1, uniform_p: 0.04, ranks: [0.2, 0.4, 0.6, 0.8] },
    ],
    claims,
    conflicts: [{ first: { system: "press", variation: "", text: "One" }, second: { system: "press", variation: "small", text: "Other" }, together: 26, expected: 55.2, deviations: -4.26 }],
    joint: {
      prior: { mean: 1.5, sums: [1, 1.25, 1.75, 2], not_failing: 1, not_failing_as_written: 1 },
      fresh: { mean: 2.25, sums: [2, 2.5], not_failing: 2, not_failing_as_written: 3 },
    },
  };
}

export function hostileInference(nasty: string): InferenceReport {
  const inference = inferenceFixture();
  const none = null as unknown as number;
  return {
    ...inference,
    systems: [nasty],
    draws: 3,
    accepted: 0,
    targets: [],
    unknowns: inference.unknowns.map((unknown) => ({ ...unknown, name: nasty, text: nasty, system: nasty, shrinkage: none })),
    dependences: [],
    calibration: [],
    claims: inference.claims.map((claim) => ({ ...claim, text: nasty, prior: null, fresh: null, fresh_verdict: null })),
    conflicts: [],
    joint: { prior: { ...inference.joint.prior, sums: [none] }, fresh: { ...inference.joint.fresh, sums: [] } },
  };
}
