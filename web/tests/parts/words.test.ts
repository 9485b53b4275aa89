// The names and ranges of the metrics: those of the table (src/report/metrics.ts), which must agree with what
// docs/reference/results.md lists.

import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";

import { expect, test } from "vitest";

import { kMetrics, type MetricRange } from "../../src/report/metrics";
import { isShare, metricName, metricRange, splitMetric } from "../../src/report/page/words";

const kSource = process.env["SOMATO_SOURCE"] ?? fileURLToPath(new URL("../../..", import.meta.url));
const kReference = join(kSource, "docs/reference/results.md");

interface Documented {
  name: string;
  range: string;
}

function documentedMetrics(): Documented[] {
  const tables = readFileSync(kReference, "utf8").match(/^\| metric \| range \|.*\n(?:\|.*\n)+/gm) ?? [];
  const rows = tables.join("").matchAll(/^\| ((?:`\w+`(?:, )?)+) \| ([^|]*) \|/gm);
  return [...rows].flatMap(([, names = "", range = ""]) =>
    [...names.matchAll(/`(\w+)`/g)].map(([, name = ""]) => ({ name, range: range.trim() })),
  );
}

/** The name without a suffix. */
function plain(name: string): string {
  return name.replace(/_chance$/, "").replace(/_after_K$/, "");
}

const kRangesOf30SamplesOf6Classes: Record<MetricRange, [number, number] | null> = {
  share: [0, 1],
  signed: [-1, 1],
  samples: [0, 30],
  classes: [0, 6],
  from_zero: null,
};

test("every metric of the table has words and a range, with prefixes and suffixes too", () => {
  expect(kMetrics.size).toBeGreaterThan(0);
  for (const [name, { words, range }] of kMetrics) {
    expect(words, name).toMatch(/^[A-Z]/);
    expect(metricName(`shape.${name}`), name).toBe(words);
    for (const whole of [name, `shape.${name}_chance`, `altered.half.shape.${name}`, `${name}_after_3`]) {
      expect(metricRange(whole, 30, 6), whole).toEqual(kRangesOf30SamplesOf6Classes[range]);
      expect(isShare(whole), whole).toBe(range === "share");
    }
  }
});

test("a metric that is not in the table has its name as words and no range", () => {
  for (const name of ["other_accuracy", "constructor", "mapped_with cube a.accuracy"]) {
    expect(metricRange(name, 30, 6), name).toBeNull();
    expect(isShare(name), name).toBe(false);
  }
  expect(metricName("other_accuracy")).toBe("Other accuracy");
  expect(metricName("mapped_with cube a.accuracy")).toBe("Samples of cube among a.accuracy");
});

test("a metric whose range the reference states has this range in the table", () => {
  const kDocumented: Record<MetricRange, RegExp> = {
    share: /^0 to 1$/,
    signed: /^-1 to 1$/,
    samples: /^0 to `samples`$/,
    classes: /^0 to the number of classes$/,
    from_zero: /^(count|from 0, in .*)$/,
  };
  for (const { name, range } of documentedMetrics()) {
    const info = kMetrics.get(plain(name));
    expect(info, name).toBeDefined();
    if (info) expect(range, name).toMatch(kDocumented[info.range]);
  }
});

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
  expect(metricName("accuracy_chance")).toBe("Accuracy by chance");
  expect(metricName("areas_connected_chance")).toBe("Areas connected chance");
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
