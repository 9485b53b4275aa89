// Parts that belong together: maps, seeds and labels, a selected neuron in all figures, two systems side
// by side, the exploration behind a marker, and addresses that lead to all of it.

import type { Locator, Page } from "playwright-core";
import { beforeAll, describe, expect, test } from "vitest";

import { between, kSequence } from "../../src/parts/maps/colour_maps";
import { accessibilityViolations, screenshotPath } from "../browser";
import { figureOf, goTo, ReportBrowser, savedRows } from "./report_browser";
import { reportFixture } from "./report_fixture";
import { growingSystem } from "./report_systems";

const report = new ReportBrowser();
const data = reportFixture();
const hand = data.systems[0]!;
const [run, fifth] = [hand.protocols[0]!.runs[0]!, hand.protocols[0]!.runs[4]!];
const kId = "t_mpsom_multiplied";
let page: Page;
let section: Locator;

async function open(): Promise<void> {
  ({ page } = await report.open(data));
  section = await goTo(page, kId);
}

const rings = (title: string, kind: string, within = section) =>
  figureOf(within, title).locator(`.map-ring${kind}`);

describe("maps of a system, one after the other", () => {
  beforeAll(open);

  test("state values under the pointer, with the names of the elements", async () => {
    const figure = figureOf(section, "Touch over time");
    await figure.scrollIntoViewIfNeeded();
    const box = (await figure.locator("image").boundingBox())!;
    await page.mouse.move(box.x + box.width * 0.99, box.y + box.height * (7.5 / 45));
    expect(await figure.locator(".readout").textContent()).toMatch(/^finger1_distal_1, 5\.9 s: [\d.]+ N$/);
    expect(await figure.locator("svg text", { hasText: /^finger2$/ }).count()).toBe(1);
  });

  test("mark the selected neuron, whose samples play", async () => {
    const winner = run.winners[7]!;
    await figureOf(section, "Winners").locator(`[data-cell="${winner}"]`).click();
    for (const title of ["Winners", "U-matrix", "Hits", "Component plane of an element of touch"])
      expect(await rings(title, ":not(.pointed)").count()).toBe(1);
    const column = `row ${Math.floor(winner / 15) + 1}, column ${(winner % 15) + 1}`;
    expect(await figureOf(section, "Weights of one neuron on the hand").locator(".what").textContent()).toContain(column);
    const samples = section.locator(".won button");
    expect(await samples.count()).toBe(run.winners.filter((one) => one === winner).length);
    const sample = hand.samples![7]!;
    const name = `${sample["object"]}, trial ${sample["trial"]}`;
    await samples.filter({ hasText: name }).click();
    const time = () => section.locator(".player output").textContent();
    const begun = await time();
    expect(await section.getByRole("button", { name: "Stop" }).count()).toBe(1);
    await expect.poll(time).not.toBe(begun);
    await section.getByRole("button", { name: "Stop" }).click();
    expect(await figureOf(section, "Touch at a moment").locator(".what").textContent()).toContain(name);
    const shown = Number.parseFloat((await time())!);
    const touch = hand.moments[7]!.channels[0]!;
    const nearest = touch.times.findIndex((one) => Math.abs(one - shown) <= 0.051);
    const values = (await savedRows(figureOf(section, "Touch at a moment"))).slice(1).map((row) => Number(row[1]));
    const rows = [nearest - 1, nearest, nearest + 1].map((i) => touch.series[i]);
    expect(rows).toContainEqual(values);
  });

  test("follow seed and label, or state that they are of another map", async () => {
    const distances = await savedRows(figureOf(section, "U-matrix"));
    const won = (winner: number) => run.labels.filter((_, i) => run.winners[i] === winner);
    for (const winner of new Set(run.winners)) expect(won(winner)).toContain(distances[winner + 1]![4]);
    await section.getByRole("radio", { name: "shape" }).check();
    const shapes = await savedRows(figureOf(section, "U-matrix"));
    expect(new Set(shapes.slice(1).map((row) => row[4]))).toEqual(new Set(["", "sphere", "cylinder", "block"]));
    await section.getByRole("slider", { name: "Seed" }).fill("4");
    const hits = (await savedRows(figureOf(section, "Hits"))).slice(1).map((row) => Number(row[3]));
    hits.forEach((count, neuron) => expect(count).toBe(fifth.winners.filter((winner) => winner === neuron).length));
    const other = await savedRows(figureOf(section, "U-matrix"));
    expect(other.slice(1).map((row) => Number(row[3]))).toEqual(fifth.map!.u_matrix);
    expect(fifth.map!.u_matrix).not.toEqual(run.map!.u_matrix);
    expect(await figureOf(section, "U-matrix").locator(".what").textContent()).toContain("seed 5");
    // The weights of one system are stored.
    const notice = section.locator(".other-map");
    expect(await notice.textContent()).toContain("seed 1: another map than that of the selected winners");
    await notice.getByRole("button").click();
    expect(await section.getByRole("slider", { name: "Seed" }).inputValue()).toBe("0");
    expect(await section.locator(".other-map").count()).toBe(0);
  });
});

test("a U-matrix that was not stored for a seed is that of the saved system, and says so", async () => {
  const protocols = hand.protocols.map((one) => ({ ...one, runs: one.runs.map(({ map: _, ...rest }) => rest) }));
  ({ page } = await report.open({ ...data, systems: [{ ...hand, protocols }], claims: [] }));
  section = await goTo(page, kId);
  const figure = figureOf(section, "U-matrix");
  expect(await figure.locator(".other-map").count()).toBe(0);
  await section.getByRole("slider", { name: "Seed" }).fill("4");
  expect(await figure.locator(".other-map").textContent()).toContain("seed 1: another map");
  expect(await figure.locator(".marker").count()).toBe(0);
  const rows = (await savedRows(figure)).slice(1).map((row) => Number(row[3]));
  expect(rows).toEqual(hand.trained!.u_matrix);
});

describe("a map that grows", () => {
  const system = growingSystem();
  const [first, second] = system.protocols[0]!.runs;

  test("is drawn as neurons and their connections, another graph for each seed", async () => {
    ({ page } = await report.open({ ...data, systems: [system], claims: [] }));
    section = await goTo(page, "growing");
    expect(await section.locator(".facts").textContent()).toContain("5 neurons with 4 connections");
    for (const title of ["Winners", "U-matrix", "Hits"]) {
      expect(await figureOf(section, title).locator("[data-cell]").count()).toBe(5);
      expect(await figureOf(section, title).locator(".map-edges path").count()).toBe(4);
    }
    // An edge ends in the middles of its neurons; the longest distance is the brightest.
    const places = await figureOf(section, "U-matrix").locator("[data-cell], .map-edges path").evaluateAll((all) =>
      all.map((one) => {
        const box = (one as SVGGraphicsElement).getBBox();
        return { x: box.x, y: box.y, width: box.width, height: box.height, stroke: getComputedStyle(one).stroke };
      }),
    );
    const [edges, cells] = [places.slice(0, 4), places.slice(4)];
    const middle = (i: number, name: "x" | "y") => cells[i]![name] + cells[i]![name === "x" ? "width" : "height"] / 2;
    edges.forEach((edge, i) => {
      expect(edge.x).toBeCloseTo(Math.min(middle(0, "x"), middle(i + 1, "x")), 1);
      expect(edge.width).toBeCloseTo(Math.abs(middle(0, "x") - middle(i + 1, "x")), 1);
      expect(edge.height).toBeCloseTo(Math.abs(middle(0, "y") - middle(i + 1, "y")), 1);
      const [red, green, blue] = between(kSequence, (i + 1) / 4); // from 0, which neuron 0 has, to 4
      const shown = edge.stroke.match(/\d+/g)!.map(Number);
      [red, green, blue].forEach((part, k) => expect(Math.abs(part - shown[k]!)).toBeLessThanOrEqual(4));
    });
    await page.screenshot({ path: screenshotPath("report-growing"), fullPage: true });
    await figureOf(section, "Winners").locator('[data-cell="4"]').click();
    const won = first!.winners.filter((winner) => winner === 4).length;
    expect(await section.locator(".won p").textContent()).toBe(`Neuron 5 wins ${won} sample${won === 1 ? "" : "s"}.`);
    await section.getByRole("slider", { name: "Seed" }).fill("1");
    expect(await figureOf(section, "Winners").locator("[data-cell]").count()).toBe(6);
    const rows = await savedRows(figureOf(section, "U-matrix"));
    expect(rows[0]).toEqual(["neuron", "distance", "class"]);
    expect(rows.slice(1).map((row) => Number(row[1]))).toEqual(second!.map!.u_matrix);
    await section.getByRole("combobox", { name: "Protocol" }).selectOption({ index: 1 });
    expect(await figureOf(section, "Winners").locator(".message").textContent()).toContain("cannot be drawn together");
  });
});

describe("two systems", () => {
  test("stand side by side, and mark the winners of the same samples", async () => {
    ({ page } = await report.open(data));
    section = page.locator("#compare");
    await page.evaluate(() => (location.hash = "compare?system1=1&system2=1&run2=5"));
    const sides = section.locator(".side-of-two");
    await expect.poll(() => sides.count()).toBe(2);
    expect(await sides.nth(1).getByRole("slider", { name: "Seed" }).inputValue()).toBe("4");
    const winner = run.winners[0]!;
    await figureOf(sides.nth(0), "Winners").locator(`[data-cell="${winner}"]`).click();
    const same = new Set(fifth.winners.filter((_, i) => run.winners[i] === winner));
    expect(await rings("Winners", ".marked", sides.nth(1)).count()).toBe(same.size);
    expect(await rings("Hits", ".marked", sides.nth(1)).count()).toBe(same.size);
    await expect.poll(() => page.evaluate(() => location.hash)).toContain(`neuron1=${winner + 1}`);
    await page.screenshot({ path: screenshotPath("report-compare") });
    await sides.nth(1).getByRole("combobox", { name: "System" }).selectOption({ label: "hardness" });
    expect(await rings("Winners", ".marked", sides.nth(1)).count()).toBe(0); // other samples
    expect(await accessibilityViolations(page)).toEqual([]);
  });
});

describe("an address", () => {
  test("contains what is selected, and shows it again", async () => {
    await open();
    await section.getByRole("radio", { name: "shape" }).check();
    await section.getByRole("slider", { name: "Seed" }).fill("4");
    await figureOf(section, "Winners").locator('[data-cell="20"]').click();
    await figureOf(section, "Confusion matrix of the selected run").locator(".figure-link").click();
    const address = page.url();
    expect(address).toContain("#t_mpsom_multiplied-confusions?label=shape&run=5&neuron=21");
    const other = await report.browser.newPage();
    await other.goto(address);
    const again = other.locator(`#${kId}`);
    await expect.poll(() => again.getByRole("slider", { name: "Seed" }).inputValue()).toBe("4");
    expect(await again.getByRole("radio", { name: "shape" }).isChecked()).toBe(true);
    expect(await rings("Winners", ":not(.pointed)", again).count()).toBe(1);
    const top = () =>
      figureOf(again, "Confusion matrix of the selected run").evaluate((one) => one.getBoundingClientRect().top);
    await expect.poll(top).toBeLessThan(800);
    await other.close();
  });

  test("that leads nowhere changes nothing", async () => {
    const { page: lost, problems } = await report.open(data);
    for (const hash of ["#nowhere", "#%E0%A4%A", "#t_mpsom_multiplied?run=99&neuron=-3&label=none&protocol=x"]) {
      await lost.evaluate((one) => (location.hash = one), hash);
    }
    const slider = lost.locator(`#${kId}`).getByRole("slider", { name: "Seed" });
    await expect.poll(() => slider.inputValue()).toBe("0");
    expect(problems).toEqual([]);
  });
});
