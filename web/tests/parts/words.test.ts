// The names and ranges of the metrics that docs/reference/results.md lists.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { expect, test } from "vitest";

import { isShare, metricName, metricRange, splitMetric } from "../../src/report/page/words";

const kSource = process.env["SOMATO_SOURCE"] ?? fileURLToPath(new URL("../../..", import.meta.url));
const kReference = join(kSource, "docs/reference/results.md");

interface Documented {
  name: string;
  range: string;
}

function documentedMetrics(): Documented[] {
  const rows = readFileSync(kReference, "utf8").matchAll(/^\| ((?:`\w+`(?:, )?)+) \| ([^|]*) \|/gm);
  return [...rows].flatMap(([, names = "", range = ""]) =>
    [...names.matchAll(/`(\w+)`/g)].map(([, name = ""]) => ({ name, range: range.trim() })),
  );
}

test("a metric that counts samples or classes has their number as its range", () => {
  const counts = documentedMetrics().filter(({ range }) => range === "0 to `samples`");
  expect(counts.map(({ name }) => name)).toContain("samples_ambiguous");
  for (const { name } of counts) {
    expect(metricRange(name, 30, 6), name).toEqual([0, 30]);
    expect(isShare(name), name).toBe(false); // a curve of counts must not end at 1
    expect(metricRange(`shape.${name}_chance`, 30, 6), name).toEqual([0, 30]);
  }
  expect(metricRange("classes_separated", 30, 6)).toEqual([0, 6]);
});

test("a metric that is a share has the range from 0 to 1", () => {
  const shares = documentedMetrics().filter(({ range }) => range === "0 to 1");
  expect(shares.map(({ name }) => name)).toContain("order_along");
  for (const { name } of shares) expect(metricRange(name, 30, 6), name).toEqual([0, 1]);
});

test("a metric of a label has the name of the metric", () => {
  expect(metricName("samples_ambiguous")).toBe("Ambiguous samples");
  expect(metricName("shape.samples_ambiguous")).toBe("Ambiguous samples");
  expect(metricName("classes_separated")).toBe("Classes separated");
  expect(metricName("taught_accuracy_after_1")).toBe("New class answered after 1 name");
  expect(metricName("baseline_known_accuracy_after_3")).toBe("Known classes, nearest neighbour, after 3 names");
  expect(metricName("accuracy_after_3")).toBe("Accuracy after 3");
  expect(isShare("known_changed_after_2")).toBe(true);
});

test("a metric of altered explorations has the name and the range of the metric", () => {
  expect(splitMetric("altered.first_half.accuracy")).toEqual(["first_half", "accuracy"]);
  expect(splitMetric("altered.first_half.shape.accuracy")).toEqual(["shape, first_half", "accuracy"]);
  expect(metricName("altered.first_half.shape.accuracy")).toBe("Accuracy");
  expect(metricRange("altered.first_half.accuracy", 30, 6)).toEqual([0, 1]);
});

test("an error of predictions has no upper end", () => {
  for (const metric of ["aperture.prediction_error", "aperture.prediction_error_of_mean"]) {
    expect(metricRange(metric, 30, 6), metric).toBeNull();
  }
});
