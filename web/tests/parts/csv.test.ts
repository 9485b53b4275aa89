import { expect, test } from "vitest";

import { csv } from "../../src/parts/csv";
import { fileName } from "../../src/parts/figure";
import { percent, rangeOf, readable } from "../../src/parts/numbers";

test("fields are quoted where they must be", () => {
  const rows = [['a "b"', "c,d"], ["line\nbreak", 1.5], [null, Number.NaN]];
  expect(csv({ columns: ["x", "y"], rows })).toBe('x,y\r\n"a ""b""","c,d"\r\n"line\nbreak",1.5\r\n,\r\n');
});

test("what a spreadsheet would take for a formula is a text", () => {
  expect(csv({ columns: ["x"], rows: [["=1+1"], ["@a"], [-1]] })).toBe("x\r\n'=1+1\r\n'@a\r\n-1\r\n");
});

test("numbers keep all their digits", () => {
  expect(csv({ columns: ["x"], rows: [[0.1 + 0.2]] })).toBe("x\r\n0.30000000000000004\r\n");
});

test("names of files are such as every system takes", () => {
  expect(fileName('a/b: "c" <d>')).toBe("a-b-c-d");
  expect(fileName("../..")).toBe("figure");
  expect([...fileName("é".repeat(200))].length).toBe(80);
});

test("numbers are read as people read them", () => {
  expect(readable(0.123456)).toBe("0.123");
  expect(readable(-2)).toBe("−2");
  expect(readable(123456)).toBe("123456");
  expect(readable(1e-9)).toBe("1.00e−9");
  expect(readable(null)).toBe("–");
  expect(percent(0.999)).toBe("> 99 %");
  expect(percent(1)).toBe("100 %");
  expect(percent(0.001)).toBe("< 1 %");
  expect(rangeOf([null, 3, -1])).toEqual([-1, 3]);
  expect(rangeOf([null])).toBeNull();
});
