// All that a paper takes from a report beside pictures: names of figures, tables, methods, references.

import { expect, test } from "vitest";

import { latex } from "../../src/parts/latex";
import { asLatex, asPlain } from "../../src/report/paper/cited_text";
import { figureName, unique } from "../../src/report/paper/figure_names";
import { methodsOf } from "../../src/report/paper/methods";
import { printedClaims, printedSystems } from "../../src/report/paper/printed";
import { bibtex } from "../../src/report/paper/references";
import { emptySystem } from "../../src/report/page/read";
import { Selection } from "../../src/report/page/selection";
import { refused, restored } from "../../src/report/page/selection_state";
import type { ReportData, SystemReport } from "../../src/report/page/unpacked";
import { reportFixture } from "../report/report_fixture";

const data = reportFixture();
const hand = data.systems[0]!;

test("figures have short names, and each its own", () => {
  expect(figureName("tensor_chain-u-matrix", "tensor_chain", "")).toBe("u-matrix");
  expect(figureName("tensor_chain-touch_change-course", "tensor_chain", "")).toBe("touch-change-course");
  expect(figureName("tensor_chain-hits", "tensor_chain", " tensor_chain")).toBe("tensor-chain-hits");
  expect(figureName("texture-torus-hits", "texture, torus", "a question texture, torus")).toBe("a-question-texture-torus-hits");
  expect(figureName("overview-map", "", "")).toBe("map");
  expect(figureName("curve-2-accuracy-by-noise", "", "")).toBe("curve-2");
  expect(unique(["hits", "map", "hits", "hits-2", "hits"])).toEqual(["hits", "map", "hits-2", "hits-2-2", "hits-3"]);
});

/** The cells of the rows between the lines of a tabular, as TeX reads them. */
function cellsOf(tex: string): string[][] {
  const body = /\\begin\{tabular\}\{((?:[lr]|p\{[\d.]+\\textwidth\})+)\}\n(.*)\\end\{tabular\}/s.exec(tex)!;
  const columns = body[1]!.replaceAll(/p\{[^}]*\}/g, "p").length;
  const rows = body[2]!.split(/\\\\\n/).map((row) => row.replaceAll(/\\hline|^\s+|\s+$/g, "").trim());
  const cells = rows.filter((row) => row !== "").map((row) => row.split(/(?<!\\)&/).map((cell) => cell.trim()));
  for (const row of cells) expect(row.length).toBe(columns);
  return cells;
}

test("the table of systems has few columns, in words", () => {
  const { table, note } = printedSystems([hand]);
  const tex = latex(table(), note, "systems");
  expect(tex).not.toMatch(/booktabs|rule\b|baseline_|train_is_test/);
  const [head, first, , ...rest] = cellsOf(tex);
  expect(head).toEqual(["System", "Tested on", "Accuracy", "Nearest neighbour", "Chance", "Samples", "Runs"]);
  expect(first!.slice(0, 2)).toEqual(["t mpsom multiplied", "training samples"]);
  expect(first![2]).toMatch(/^0\.\d\d \$\\pm\$ 0\.\d\d$/);
  // Six objects, equally often.
  expect(first!.slice(3)).toEqual(["0.90 $\\pm$ 0.00", "0.17", "30", "20"]);
  expect(rest).toEqual([]);
});

test("chance is the share of the most frequent class", () => {
  const labels = ["a", "a", "a", "b"];
  const run = { ...hand.protocols[0]!.runs[0]!, labels };
  const system = { ...hand, protocols: [{ ...hand.protocols[0]!, runs: [run] }] };
  expect(printedSystems([system]).table().rows[0]![4]).toBe("0.75");
});

test("columns of sentences are broken into lines, and no cell is an argument of the row before", () => {
  const tex = latex(printedClaims(data.claims).table(), "Claims", "claims");
  expect(tex).toContain("{p{0.5\\textwidth}l");
  expect(cellsOf(tex).length).toBe(1 + data.claims.length);
  expect(cellsOf(tex)[1]![0]).toBe("At least 29 of 30 explorations lie with their object");
  expect(latex({ columns: ["value"], rows: [["[1]"], ["*"]] }, "", "x")).toContain("    {}[1] \\\\\n    {}* \\\\");
});

const kSettings: SystemReport["settings"] = {
  study: { name: '"pressed_things"', folds: "7", only: "[]" },
  recording: { format: '"automatic"' },
  explore: { body: '"hardness"' },
  "explore.press": { force: "1.25" },
  "module.reading": { type: '"last"', input: '"potentiometer"', elements: "13" },
  "module.map": {
    type: '"som"',
    input: '"reading"',
    rows: "15",
    iterations: "1234",
    training: '"online"',
    learning_rate_schedule: '"exponential"',
    learning_rate_start: "0.31",
    learning_rate_end: "0.021",
    neighbourhood: '"gaussian"',
    radius_schedule: '"linear"',
    radius_start: "7.5",
    radius_end: "1.5",
    softmax: '"power"',
  },
  "phase.1": { learn: '["map"]' },
  "altered.early": { frames: "0.55" },
};

const system: SystemReport = { ...hand, settings: kSettings };
const report: ReportData = { ...data, systems: [system] };

test("the methods contain every setting, the data, the protocols and the seeds", () => {
  const words = asPlain(methodsOf(report));
  for (const [part, settings] of Object.entries(kSettings))
    for (const [name, value] of Object.entries(settings))
      expect(words, `${part}.${name}`).toContain(value === "[]" ? "only = none" : value.replaceAll('"', ""));
  for (const part of [
    "program Somato, version 0.0.0 (Somato contributors)",
    "trained and tested on 30 explorations of 6 classes of the label object from the recording lucs2.mcap",
    hand.data_hash,
    "a self-organizing map of 15 × 15 neurons (Kohonen, 2001) with the input reading",
    "trained for 1234 iterations (online); the learning rate changed from 0.31 to 0.021 (exponential schedule)",
    "radius of the neighbourhood (gaussian) from 7.5 to 1.5 (linear schedule)",
    "The system was trained on all 30 samples",
    "The samples of each object were left out in turn",
    "Each of these tests was done in 20 runs with 20 seeds from 1 to 20.",
    "The papers do not give these settings, whose values are assumptions: arbor sigma of hand; learning rate start of map.",
  ])
    expect(words).toContain(part);
  for (const sentence of words.split("References")[0]!.split(/(?<=\.)\s+(?=[A-Z])/)) expect(sentence.trim()).toMatch(/^[A-Z].*\.$/s);
});

test("of a variation the methods state what differs", () => {
  const map = { ...kSettings["module.map"]!, iterations: "99" };
  const varied = { ...system, variation: "short", settings: { ...kSettings, "module.map": map } };
  const words = asPlain(methodsOf({ ...report, systems: [system, varied] }));
  expect(words).toContain(`The variation short of the system ${hand.name.replaceAll("_", " ")} differs from it: iterations of map is 99 instead of 1234.`);
  expect(words.match(/It was trained for/g)!.length).toBe(1);
});

test("what the methods cite is in the references", () => {
  const cites = (of: ReportData) => [...asLatex(methodsOf(of)).matchAll(/\\cite\{([^}]*)\}/g)].flatMap((one) => one[1]!.split(","));
  const paper = { ...data.claims[0]!, paper: "P06 2.3, P11 II-C" };
  const other = { ...data.claims[0]!, paper: "A-SOM 2009" };
  const of = { ...report, claims: [paper, other] };
  expect(new Set(cites(of))).toEqual(new Set(["somato", "johnsson2006", "johnsson2011", "kohonen2001"]));
  for (const key of cites(of)) expect(bibtex(of)).toMatch(new RegExp(`^@\\w+\\{${key},$`, "m"));
  expect(asPlain(methodsOf(of))).toContain("Its claims also refer to A-SOM 2009.");
  expect(new Set(cites({ ...report, claims: [] }))).toEqual(new Set(["somato", "kohonen2001"]));
  expect(asLatex(methodsOf(report))).not.toMatch(/(?<!\\)[_#&%]/);
});

test("the methods of a system without data are sentences, too", () => {
  const words = asPlain(methodsOf({ ...data, systems: [{ ...emptySystem(), name: "bare" }], claims: [] }));
  expect(words).toContain("The system bare was trained and tested on 0 explorations.");
  expect(words).not.toMatch(/undefined|NaN|Infinity/);
});

test("a selection that the system does not have is named", () => {
  const selection = new Selection(hand);
  const wrong = (words: string) => {
    const state = new URLSearchParams(words);
    restored(selection, state);
    return refused(selection, state);
  };
  expect(wrong("protocol=1&label=object&run=1")).toEqual([]);
  expect(wrong("protocol=2&label=shape&run=20&neuron=3")).toEqual([]);
  expect(wrong("protocol=3&label=weight&run=21&neuron=300&seed=1")).toEqual(["protocol", "label", "run", "neuron", "seed"]);
});
