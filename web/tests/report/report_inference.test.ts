// The section of an inference: prior and posterior, the shares of claims, and the check.

import type { Locator, Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";

import type { ReportData } from "../../src/report/page/unpacked";
import { accessibilityViolations, screenshotPath } from "../browser";
import { figureOf, goTo, ReportBrowser, savedRows } from "./report_browser";
import { hostileInference, inferenceFixture } from "./report_inferences";

const report = new ReportBrowser();
const inference = inferenceFixture();
const data: ReportData = { version: 2, somato: "0.0.0", systems: [], claims: [], curves: [], inferences: [inference] };
let page: Page;
let problems: string[];
let section: Locator;

beforeAll(async () => {
  ({ page, problems } = await report.open(data, { reducedMotion: "reduce" })); // colours change at once
  section = await goTo(page, "inference");
});

const rowsOf = (title: string) =>
  figureOf(section, title)
    .locator("tbody tr")
    .evaluateAll((rows) => rows.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));

test("the prior's prediction stands first, then the posterior's", async () => {
  expect(await section.locator("h2").textContent()).toBe("Inference of press and tensor chain");
  const words = (await section.locator("p.lead").first().textContent())!;
  expect(words).toContain("Of 3 claims, 1.5 hold in a pair of a setting of the prior, and 2.3 in a fresh pair of 20 settings of the posterior.");
  expect(words).toContain("2 do not fail; by their second measures 3.");
  expect(await section.locator(".tiles").textContent()).toBe("Of 3 claims1explained1reachable1excluded");
  expect(await section.textContent()).not.toContain("No claim can be excluded");
  expect(await page.textContent("main")).not.toContain("No results were given");
});

test("each claim has its shares, its verdicts and its support in words", async () => {
  const rows = await rowsOf("Claims of the inference");
  expect(rows[0]).toEqual([
    "At least seven materials are separatedpress: classes_separated ≥ 7",
    "25 %",
    "95 %",
    "38 %",
    "13 %",
    "explained",
    "holdsas written: compatible",
    "P11 IV-F",
  ]);
  expect(rows[1]!.slice(1, 7)).toEqual(["0 %", "0 %", "38 %", "13 %", "excluded", "fails"]);
  expect(rows[2]![0]).toContain("classes_separated minus that of chain ≥ 7");
  expect(rows[2]!.slice(3, 5)).toEqual(["–", "–"]);
  const saved = await savedRows(figureOf(section, "Claims of the inference"));
  expect(saved[0]!.slice(0, 6)).toEqual(["claim", "prior", "fresh", "without it", "by chance", "support"]);
  expect(saved[1]!.slice(0, 6)).toEqual(["press: At least seven materials are separated", "0.25", "0.95", "0.375", "0.125", "explained"]);
});

test("bars are the posterior's shares, lines the prior's", async () => {
  const rows = await rowsOf("Unknowns");
  expect(rows.map((row) => row.slice(1, 5))).toEqual([
    ["0.3", "0.2 (0.06 to 0.8)", "0.5 (0.1 to 0.7)", "0.63"],
    ['"dot_product"', "dot_product 50 %, euclidean 50 %", "dot_product 38 %, euclidean 63 %", "0.97"],
  ]);
  const picture = figureOf(section, "Unknowns").locator("svg.in-table").first();
  const numbers = (of: string, name: string) =>
    picture.locator(of).evaluateAll((all, attribute) => all.map((one) => Number(one.getAttribute(attribute))), name);
  const [low, high] = await numbers(".posterior", "height");
  expect(low! / high!).toBeCloseTo(0.25 / 0.75, 2);
  const tops = await numbers(".posterior", "y");
  const lines = await numbers(".prior", "y1");
  expect(lines[0]).toBe(lines[1]);
  expect(lines[0]).toBeCloseTo((tops[0]! + tops[1]!) / 2, 1); // 0.5 is in the middle of 0.25 and 0.75
  expect(await picture.getAttribute("aria-label")).toContain("0.05 to 0.2: 50 %, 25 %; 0.2 to 0.9: 50 %, 75 %");
});

test("dependences, conflicts, observed values and the check are tables, the joint number a picture", async () => {
  // 3 / sqrt(81) is a third: the weaker correlation is in the file only.
  expect(await rowsOf("Dependences in the posterior")).toEqual([["learning rate", "similarity", "−0.50"]]);
  expect((await savedRows(figureOf(section, "Dependences in the posterior"))).length).toBe(3);
  expect((await rowsOf("Conflicts between claims"))[0]!.slice(2)).toEqual(["26", "55", "−4.3"]);
  expect((await rowsOf("Observed values"))[0]!.slice(1, 5)).toEqual(["3", "5.25", "3.5", "1.5"]);
  const check = figureOf(section, "Check of the inference");
  expect((await rowsOf("Check of the inference"))[0]!.slice(0, 3)).toEqual(["learning rate", "75 %", "0.50"]);
  expect(await check.locator("svg").first().locator(".rank").count()).toBe(4);
  expect(await check.locator("figcaption").textContent()).toContain("here 88 % on average, and p is below 0.05 for 1 of 2 unknowns");
  const joint = figureOf(section, "Claims that hold together");
  expect((await savedRows(joint)).slice(1)).toEqual([["prior", "1"], ["prior", "1.25"], ["prior", "1.75"], ["prior", "2"], ["posterior", "2"], ["posterior", "2.5"]]);
  expect(await joint.locator("svg.plot rect").count()).toBe(3); // two bins of the prior, one of the posterior
});

test("it looks like this, without a barrier, in light, in dark and on a telephone", async () => {
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    expect(await accessibilityViolations(page, ["color-contrast"])).toEqual([]);
    await page.screenshot({ path: screenshotPath(`report-inference-${colorScheme}`) });
  }
  expect(await accessibilityViolations(page)).toEqual([]);
  await page.setViewportSize({ width: 390, height: 844 });
  expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  await page.screenshot({ path: screenshotPath("report-inference-390") });
  expect(problems).toEqual([]);
});

test("invalid texts and missing numbers leave the page whole", async () => {
  const nasty = `</script><img src=x onerror="window.__hurt=1">'"&amp; ${"very long ".repeat(40)}`;
  const opened = await report.open({ ...data, inferences: [hostileInference(nasty), inference] }, { width: 390 });
  await goTo(opened.page, "inference");
  const second = await goTo(opened.page, "inference-2");
  expect(await second.locator("h2").textContent()).toBe("Inference of press and tensor chain");
  expect(await opened.page.evaluate(() => "__hurt" in globalThis)).toBe(false);
  expect(await opened.page.textContent("#inference")).toContain("No claim can be excluded, which requires 1000 draws.");
  expect(await opened.page.locator(".message.problem").count()).toBe(0);
  expect(await opened.page.evaluate(() => document.documentElement.scrollWidth)).toBe(390);
  expect(opened.problems).toEqual([]);
});
