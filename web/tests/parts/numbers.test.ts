import { expect, test } from "vitest";

import {
  countOf,
  digits,
  fineDigits,
  fixed,
  hundredths,
  percent,
  rangeOf,
  readable,
  seconds,
  significant,
  withUnit,
} from "../../src/parts/numbers";

test("numbers are read as people read them", () => {
  expect(readable(0.123456)).toBe("0.123");
  expect(readable(-2)).toBe("−2");
  expect(readable(1234.5678)).toBe("1234.57");
  expect(readable(123456)).toBe("123456");
  expect(readable(1e-9)).toBe("1.00e−9");
  expect(readable(1e6)).toBe("1.00e+6");
  expect(percent(0.999)).toBe("> 99 %");
  expect(percent(1)).toBe("100 %");
  expect(percent(0.001)).toBe("< 1 %");
  expect(percent(0.5)).toBe("50 %");
});

test("a value that is missing is a dash", () => {
  for (const missing of [null, undefined, Number.NaN, Number.POSITIVE_INFINITY])
    for (const format of [readable, digits, hundredths, percent]) expect(format(missing)).toBe("–");
});

test("numbers that change keep their decimals", () => {
  expect([0, 1.234, -12.34, 99.96, 9.996].map(digits)).toEqual(["0.00", "1.23", "−12.3", "100", "10.0"]);
  expect([0, 0.01234, -0.01234, 0.1, 12.34].map(fineDigits)).toEqual([
    "0.00",
    "0.0123",
    "−0.0123",
    "0.10",
    "12.3",
  ]);
});

test("numbers below each other have two decimals, up to 100", () => {
  expect([0.8449, -0.5, 99.994, 123.456, 1e6].map(hundredths)).toEqual([
    "0.84",
    "−0.50",
    "99.99",
    "123",
    "1.00e+6",
  ]);
  expect(fixed(-0.05, 3)).toBe("−0.050");
});

test("numbers at an axis have no zeros at their end", () => {
  expect([0.1 + 0.2, -2.5, 1e-7].map((value) => significant(value, 6))).toEqual(["0.3", "−2.5", "1e−7"]);
});

test("a unit stands behind its number, where there is one", () => {
  expect(withUnit(digits(1), "N")).toBe("1.00 N");
  expect(withUnit(digits(1), "")).toBe("1.00");
  expect(seconds(5.94)).toBe("5.9 s");
});

test("one is counted with a word of its own", () => {
  expect([0, 1, 2].map((count) => countOf(count, "run"))).toEqual(["0 runs", "1 run", "2 runs"]);
  expect(countOf(2, "class", "classes")).toBe("2 classes");
});

test("a range is that of the numbers that are there", () => {
  expect(rangeOf([null, 3, -1, Number.NaN])).toEqual([-1, 3]);
  expect(rangeOf([null])).toBeNull();
});
