// Which sensors decided: the contributions of channels and elements to a decision between two classes.

import type { Locator, Page } from "playwright-core";
import { beforeAll, expect, test } from "vitest";

import { sequenceColour } from "../../src/parts/maps/colour_maps";
import { accessibilityViolations, screenshotPath } from "../browser";
import { figureOf, goTo, ReportBrowser, savedRows, scrollTo } from "./report_browser";
import { reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();
const hand = data.systems[0]!;
const { sources, decisions } = hand.deciding!;
let page: Page;
let problems: string[];
let section: Locator;

beforeAll(async () => {
  ({ page, problems } = await report.open(data));
  section = await goTo(page, hand.name);
});

const numberIn = (words: string) => Number(words.replace("\u2212", "-").replace(/[^-+\d.e]/g, ""));
const figures = () => figureOf(section, "Contributions of channels");

async function choose(decision: number): Promise<void> {
  const part = section.locator("details.block", { has: page.getByRole("heading", { name: "Which sensors decided" }) });
  await part.getByLabel("Exploration of").selectOption(String(decision));
}

test.each([0, 1, 2])("the channels of decision %i sum to the difference of the distances", async (number) => {
  await choose(number);
  const decision = decisions[number]!;
  const rows = await figures().locator("tbody tr").evaluateAll((all) => all.map((row) => [...row.children].map((cell) => cell.textContent ?? "")));
  expect(rows.length).toBe(sources.length + 1);
  const difference = decision.of_other - decision.of_nearest;
  const sum = rows.slice(0, -1).reduce((all, row) => all + numberIn(row[1]!), 0);
  expect(Math.abs(sum - difference)).toBeLessThan(0.02 * rows.length);
  expect(Math.abs(numberIn(rows.at(-1)![1]!) - difference)).toBeLessThan(0.02);
  const strongest = rows.slice(0, -1).map((row) => Math.abs(numberIn(row[1]!)));
  expect(strongest).toEqual([...strongest].sort((one, other) => other - one));
  const words = (await figures().textContent())!;
  for (const one of [decision.nearest, decision.other, decision.answer]) expect(words).toContain(one);
  expect(words.includes(`${decision.confused} of ${decision.tests} tests named it ${decision.predicted}.`)).toBe(decision.confused > 0);
});

test("the strongest elements of a channel are those of its values", async () => {
  await choose(1);
  const touch = sources[0]!;
  const values = touch.values[1]!;
  const order = values.map((_, i) => i).sort((one, other) => Math.abs(values[other] ?? 0) - Math.abs(values[one] ?? 0));
  const row = (await figures().locator("tbody tr", { hasText: "Touch" }).textContent())!;
  const places = order.slice(0, 3).map((i) => row.indexOf(`${touch.channel.elements[i]!} `));
  expect(Math.min(...places)).toBeGreaterThan(0);
  expect(places).toEqual([...places].sort((one, other) => one - other));
});

test("the skin has the colours of the contributions, and no colour where an element is not read", async () => {
  await choose(0);
  const skin = figureOf(section, "Contributions of touch");
  await scrollTo(skin);
  const all = sources.flatMap(({ values }) => values[0] ?? []);
  const end = Math.max(...all.map((value) => Math.abs(value ?? 0)));
  const fills = await skin.locator("[data-cell]").evaluateAll((cells) => cells.map((cell) => cell.getAttribute("fill") ?? ""));
  const parts = (hex: string) => [1, 3, 5].map((at) => Number.parseInt(hex.slice(at, at + 2), 16));
  sources[0]!.values[0]!.forEach((value, i) => {
    if (value === null) return expect(fills[i]).toBe("none");
    const exact = parts(sequenceColour((value / end + 1) / 2));
    parts(fills[i]!).forEach((part, k) => expect(Math.abs(part - exact[k]!)).toBeLessThan(6));
  });
  expect(await skin.locator("figcaption").textContent()).toBe(
    `Bright: closer to ${decisions[0]!.nearest} than to ${decisions[0]!.other}. Dark: the reverse.`,
  );
});

test("the saved numbers are all contributions, which sum to those of the channels", async () => {
  await choose(0);
  const rows = await savedRows(figures());
  expect(rows[0]).toEqual(["channel", "element", "contribution (N)"]);
  expect(rows.length).toBe(1 + sources.reduce((all, { channel }) => all + channel.elements.length, 0));
  const sum = rows.slice(1).reduce((all, row) => all + Number(row[2]), 0);
  const { sums, of_nearest, of_other } = decisions[0]!;
  expect(sum).toBeCloseTo(of_other - of_nearest - sums.at(-1)!, 9); // without the module, which has too many elements
});

test("it looks like this, without a barrier, in light and in dark", async () => {
  await choose(0);
  for (const colorScheme of ["light", "dark"] as const) {
    await page.emulateMedia({ colorScheme });
    await scrollTo(figures());
    expect(await accessibilityViolations(page, ["color-contrast"])).toEqual([]);
    await page.screenshot({ path: screenshotPath(`report-deciding-${colorScheme}`) });
  }
  expect(await accessibilityViolations(page)).toEqual([]);
  expect(problems).toEqual([]);
});
