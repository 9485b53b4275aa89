// Texts in files: LaTeX, chunks of PNG, and packed numbers.

import { expect, test } from "vitest";

import { latex } from "../../src/parts/latex";
import { checksum, withText } from "../../src/parts/png_text";
import { unpacked } from "../../src/report/page/unpacked";

test("every character of a LaTeX table stands for itself", () => {
  const rows = [
    ["50 % of a_b & c", 0.123456],
    ["\\ ~ ^ { } # $", null],
    ["≥ ± × < –", 12345678],
  ];
  const lines = latex({ columns: ["name", "value"], rows }, "A & B", "a_b").split("\n");
  expect(lines).toContain("  \\begin{tabular}{lr}");
  expect(lines).toContain("  \\label{tab:a-b}");
  expect(lines).toContain("  \\caption{A \\& B}");
  expect(lines).toContain("    50 \\% of a\\_b \\& c & 0.1235 \\\\");
  expect(lines).toContain("    \\textbackslash{} \\textasciitilde{} \\textasciicircum{} \\{ \\} \\# \\$ & -- \\\\");
  expect(lines).toContain("    $\\geq$ $\\pm$ $\\times$ $<$ -- & 12345678 \\\\");
});

test("texts of a PNG stand after its header, with the checksum of the PNG specification", () => {
  // The checksum of an empty IEND chunk, as in every PNG file.
  expect(checksum(new TextEncoder().encode("IEND"))).toBe(0xae426082);
  const png = Uint8Array.from({ length: 45 }, (_, i) => i);
  const whole = withText(png, [
    ["Title", "ü"],
    ["Title", "≥"],
  ]);
  expect([...whole.subarray(0, 33)]).toEqual([...png.subarray(0, 33)]);
  const words = new TextDecoder("latin1").decode(whole);
  expect(words.slice(33, 48)).toBe("\0\0\0\x07tEXtTitle\0ü");
  expect(words.slice(52, 60)).toBe("\0\0\0\x0diTXt");
  expect([...whole.subarray(whole.length - 12)]).toEqual([...png.subarray(33)]);
});

test("packed numbers are those of the schema", () => {
  // -1, 0, 1 and a missing number, as in tests/views/report/packed_json_test.cc.
  const wide = { bits: 16, low: -1, high: 1, packed: "AAD/f/7///8=" };
  expect(unpacked({ deep: [wide] })).toEqual({ deep: [[-1, 0, 1, Number.NaN]] });
  const narrow = { columns: 2, bits: 8, low: -1, high: 1, packed: "AH/+/w==" };
  expect(unpacked(narrow)).toEqual([
    [-1, 0],
    [1, null],
  ]);
  expect(unpacked({ columns: 0, bits: 8, low: 0, high: 0, packed: "" })).toEqual([]);
});
