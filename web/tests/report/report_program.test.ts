// The output of `somato report`, in a browser: the page has the numbers of results.json. A probe
// explores, a system of a few lines is trained and reported; nothing but the program is needed.

import { mkdtempSync, readFileSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

import type { Locator, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";

import { accessibilityViolations, flatBrowser, screenshotPath } from "../browser";
import { somato } from "../program";

const kSystem = `
[study]
name = "pressed"
label = "material"
labels = ["hardness"]
individual = "material"
protocols = ["train_is_test", "leave_group_out"]
groups = ["trial"]

[module.potentiometer]
type = "channel"
channel = "potentiometer"
shape = [1]

[module.reading]
type = "last"
input = "potentiometer"

[module.map]
type = "som"
input = "reading"
rows = 6
columns = 8
lattice = "hexagonal"
learning_rate_start = 0.3
iterations = 300
`;

interface Results {
  parts: {
    protocols: {
      protocol: string;
      metrics: Record<string, { values: number[] }>;
      runs: { winners: number[]; predictions: string[] }[];
    }[];
  }[];
}

let page: Page;
let results: Results;
let folder: string;
const problems: string[] = [];

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), "somato-program-"));
  writeFileSync(join(folder, "pressed.toml"), kSystem);
  await somato(["explore", "--body", "hardness", "--explorations", "3", "-o", "pressed.mcap"], { cwd: folder });
  await somato(["run", "pressed.toml", "--data", "pressed.mcap", "--seeds", "3", "--out", "out"], { cwd: folder });
  await somato(["report", "out/results.json", "--data", "pressed.mcap", "-o", "report.html"], { cwd: folder });
  results = JSON.parse(readFileSync(join(folder, "out", "results.json"), "utf8")) as Results;
  page = await (await flatBrowser()).newPage({ viewport: { width: 1280, height: 800 }, acceptDownloads: true });
  page.on("pageerror", (error) => problems.push(error.message));
  page.on("console", (message) => (message.type() === "error" ? problems.push(message.text()) : undefined));
  await page.goto(`${pathToFileURL(join(folder, "report.html")).href}#pressed`);
  await page.waitForFunction(
    () => document.querySelector("#pressed .lazy") && !document.querySelector("#pressed .lazy:empty"),
  );
});

afterAll(async () => {
  await page?.close();
});

/** The section of the system; the page shows its maps side by side, too. */
const section = () => page.locator("#pressed");

async function savedRows(figure: Locator): Promise<string[][]> {
  const waiting = page.waitForEvent("download");
  await figure.getByRole("button", { name: /^CSV:/ }).click();
  const bytes = readFileSync(await (await waiting).path());
  return bytes
    .toString("utf8")
    .trimEnd()
    .split("\r\n")
    .map((line) => line.split(","));
}

const choose = (name: string, option: { index: number } | { label: string }) =>
  section().getByRole("combobox", { name }).selectOption(option);

/** The rows of the winners as CSV: of one map. */
const winnerRows = async () => (await savedRows(section().locator('figure[aria-label="Winners"]'))).slice(1);

/** The rows of all trainings of the selected run, in the order of the samples. */
async function rowsOfTrainings(): Promise<string[][]> {
  const names = await section().getByRole("combobox", { name: "Map" }).locator("option").allTextContents();
  const rows: string[][] = [];
  for (const label of names.filter((name) => name.startsWith("training"))) {
    await choose("Map", { label });
    const own = await winnerRows();
    expect(own.length).toBe(8); // the samples of one trial
    rows.push(...own);
  }
  return rows.sort((one, other) => Number(one[0]) - Number(other[0]));
}

test("has the winners and what was named of results.json, for every protocol and seed", async () => {
  for (const [protocol, { runs }] of results.parts[0]!.protocols.entries()) {
    await choose("Protocol", { index: protocol });
    for (const [seed, run] of runs.entries()) {
      await section().getByRole("slider", { name: "Seed" }).fill(String(seed));
      const rows = protocol === 0 ? await winnerRows() : await rowsOfTrainings();
      expect(rows.map((row) => Number(row[0]))).toEqual(run.winners.map((_, i) => i + 1));
      expect(rows.map((row) => Number(row[1]) - 1)).toEqual(run.winners);
      expect(rows.map((row) => row[5])).toEqual(run.predictions);
    }
  }
});

test("has the outcomes of results.json", async () => {
  await section().getByRole("combobox", { name: "Protocol" }).selectOption({ index: 0 });
  const rows = await savedRows(section().locator('figure[aria-label="Outcomes"]'));
  const values = rows
    .filter((row) => row[0] === "quantization_error" && row[1] === "here")
    .map((row) => Number(row[3]));
  expect(values).toEqual(results.parts[0]!.protocols[0]!.metrics["quantization_error"]!.values);
});

test("has the graph, the trained map, the moments and the materials", async () => {
  expect(await section().locator('figure[aria-label="Modules"] .module').count()).toBe(3);
  expect(await section().locator('figure[aria-label="U-matrix"] [data-cell]').count()).toBe(48);
  expect(await section().locator('figure[aria-label="Potentiometer at the end"] dd').textContent()).toContain(
    "counts",
  );
  expect(await section().locator(".things tbody tr").count()).toBe(8);
});

/** Saves a figure of the results by the command. */
async function figureFile(name: string, file: string, ...words: string[]): Promise<Buffer> {
  await somato(["figure", "out/results.json", name, "--data", "pressed.mcap", "-o", file, ...words], { cwd: folder });
  return readFileSync(join(folder, file));
}

test("somato figure names every figure of the page", async () => {
  const listed = JSON.parse(await somato(["figure", "out/results.json", "--data", "pressed.mcap", "--json"], { cwd: folder })) as {
    figures: { name: string; title: string; endings: string[] }[];
  };
  const titles = new Set(listed.figures.map(({ title }) => title));
  const shown = await page.locator("figure").evaluateAll((all) => all.map((one) => one.getAttribute("aria-label")));
  expect(shown.filter((title) => !titles.has(title ?? ""))).toEqual([]);
  const names = listed.figures.map(({ name }) => name);
  expect(names).toEqual([...new Set(names)]);
  for (const name of ["map", "systems", "winners", "u-matrix", "hits", "outcomes", "methods", "references"]) expect(names).toContain(name);
  expect(names.filter((name) => !/^[a-z0-9]+(-[a-z0-9]+)*$/.test(name))).toEqual([]);
});

// 8.8 cm are not a whole number of the pixels of which Chromium makes paper.
test("somato figure saves a PDF of one page, with vectors and fonts, of exactly the chosen width", async () => {
  const pdf = (await figureFile("winners", "winners.pdf", "--width", "8.8cm")).toString("latin1");
  const [, bottom, right, top] = /\/MediaBox \[0 ([\d.]+) ([\d.]+) ([\d.]+)\]/.exec(pdf)!.map(Number);
  expect(right).toBeCloseTo((88 * 72) / 25.4, 2);
  expect(pdf.match(/\/Type \/Page\b/g)!.length).toBe(1);
  expect(pdf).toContain("/FontFile2");
  expect(pdf).not.toContain("/Subtype /Image");
  expect(Number(/^startxref\n(\d+)$/m.exec(pdf)![1])).toBe(pdf.lastIndexOf("\nxref") + 1);
  const svg = (await figureFile("winners", "winners.svg", "--width", "88mm")).toString("utf8");
  const height = Number(/ width="88mm" height="([\d.]+)mm"/.exec(svg)![1]);
  expect(top! - bottom!).toBeCloseTo((height * 72) / 25.4, 1);
  expect(svg).toContain("font/woff2;base64,");
});

test("somato figure saves a PNG of what is selected, with 600 dots per inch", async () => {
  const png = await figureFile("hits", "hits.png", "--width", "3in", "--selection", "label=hardness&run=2", "--caption");
  expect(png.subarray(1, 4).toString()).toBe("PNG");
  expect(png.readUInt32BE(16)).toBe(1800);
  expect(png.toString("latin1")).toContain("Selection\0Train = test, by hardness, seed 2");
  await expect(figureFile("hits", "none.png", "--selection", "label=weight")).rejects.toThrow(/hits: the system has no such label/);
});

test("finds no barrier and no error, and looks like this", async () => {
  expect(await accessibilityViolations(page)).toEqual([]);
  expect(problems).toEqual([]);
  await page.screenshot({ path: screenshotPath("report-of-program"), fullPage: true });
});
