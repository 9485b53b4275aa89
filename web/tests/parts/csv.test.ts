import { expect, test } from "vitest";

import { csv } from "../../src/parts/csv";
import { fileName } from "../../src/parts/figure";

test("fields are quoted where they must be", () => {
  const rows = [
    ['a "b"', "c,d"],
    ["line\nbreak", 1.5],
    [null, Number.NaN],
  ];
  expect(csv({ columns: ["x", "y"], rows })).toBe('x,y\r\n"a ""b""","c,d"\r\n"line\nbreak",1.5\r\n,\r\n');
});

test("what a spreadsheet would take for a formula is a text", () => {
  expect(csv({ columns: ["x"], rows: [["=1+1"], ["@a"], [-1]] })).toBe("x\r\n'=1+1\r\n'@a\r\n-1\r\n");
  expect(csv({ columns: ["'=x"], rows: [["-wet"], ["-"], ["'cup"]] })).toBe("''=x\r\n'-wet\r\n'-\r\n'cup\r\n");
});

test("a label that is a number stays one", () => {
  expect(csv({ columns: ["x"], rows: [["-40"], ["+1.5e3"], ["-.5"], ["'-40"]] })).toBe(
    "x\r\n-40\r\n+1.5e3\r\n-.5\r\n'-40\r\n",
  );
});

test("numbers keep all their digits", () => {
  expect(csv({ columns: ["x"], rows: [[0.1 + 0.2]] })).toBe("x\r\n0.30000000000000004\r\n");
});

test("names of files are such as every system takes", () => {
  expect(fileName('a/b: "c" <d>')).toBe("a-b-c-d");
  expect(fileName("../..")).toBe("figure");
  expect([...fileName("é".repeat(200))].length).toBe(120);
});
