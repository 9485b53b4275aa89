// The report of what others recorded: objects without sizes, sensors that lie on no hand, a
// single run.

import type { Browser, Page } from "playwright-core";
import { afterAll, beforeAll, expect, test } from "vitest";

import type { ReportData } from "../../src/report/page/unpacked";
import { flatBrowser, writeReport } from "../browser";
import { fileText, goTo } from "./report_browser";
import { reportFixture } from "./report_fixture";

let browser: Browser;
let page: Page;

const kNames = ["finger_spread", "thumb_opposition", "thumb_bent", "thumb_end", "index_bent", "index_end"];
const kShapes = ["sphere", "cylinder", "cone", "ellipsoid", "capsule", "block"] as const;

const ofOneRun = (value: number) => ({ mean: value, sd: 0, values: [value] });

function ofOthers(): ReportData {
  const data = reportFixture();
  const system = data.systems[0]!;
  const channel = {
    name: "joints",
    unit: "deg",
    elements: [...kNames, "a", "b", "ring_and_little"],
    shape: [9],
  };
  const values = channel.elements.map((_, i) => i);
  const series = [0, 1, 2].map((time) => values.map((value) => value + time));
  system.moments = [
    {
      labels: { object: "egg" },
      channels: [{ channel, rate: 1, frame: 2, time: 2, values, times: [0, 1, 2], series }],
    },
  ];
  const known = system.things[0]!;
  system.things = [
    { ...known, name: "a name", shape: null, size: null, material: "", colour: null },
    ...kShapes.map((shape) => ({ ...known, name: `a ${shape}`, shape, size: null })),
  ];
  const neurons = system.trained!.planes[0]!.values.length;
  const curve = {
    name: "curve",
    unit: "N",
    elements: Array.from({ length: 20 }, (_, i) => `${i + 1}`),
    shape: [20, 1],
  };
  system.trained!.planes = [
    { channel: curve, unit: "N", values: Array.from({ length: neurons }, () => curve.elements.map(Number)) },
    { channel, unit: "deg", values: Array.from({ length: neurons }, () => values) },
  ];
  system.protocols = system.protocols.map((protocol) => ({
    ...protocol,
    runs: protocol.runs.slice(0, 1),
    metrics: { accuracy: ofOneRun(0.75), baseline_accuracy: ofOneRun(0.5) },
  }));
  return { ...data, systems: [system], claims: [], curves: [] };
}

beforeAll(async () => {
  browser = await flatBrowser();
  page = await browser.newPage({ viewport: { width: 1366, height: 768 } });
  await page.goto(writeReport(fileText(ofOthers())));
  await goTo(page, "t_mpsom_multiplied");
});

afterAll(async () => {
  await page.close();
});

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

function boxesOf(selector: string): Promise<Box[]> {
  return page.locator(selector).evaluateAll((all) =>
    all.map((one) => {
      const { left, top, right, bottom } = one.getBoundingClientRect();
      return { left, top, right, bottom };
    }),
  );
}

function overlaps(boxes: Box[]): number {
  return boxes.filter((one, i) =>
    boxes
      .slice(0, i)
      .some(
        (other) =>
          one.left < other.right - 1 &&
          other.left < one.right - 1 &&
          one.top < other.bottom - 1 &&
          other.top < one.bottom - 1,
      ),
  ).length;
}

test("draws objects of unknown size by their shapes, each in its own row", async () => {
  const boxes = await boxesOf(".things .thing-face");
  expect(boxes.length).toBeGreaterThanOrEqual(kShapes.length);
  const rows = await boxesOf(".things tbody tr");
  for (const face of boxes) {
    expect(rows.some((row) => face.top >= row.top - 1 && face.bottom <= row.bottom + 1)).toBe(true);
  }
  const drawn = await page
    .locator(".things td.thing svg")
    .evaluateAll((all) => all.map((one) => one.innerHTML));
  expect(new Set(drawn.map((one) => one.replaceAll(/light-?\d+/g, ""))).size).toBe(kShapes.length);
  const note = page.locator('figure[aria-label="Things"] figcaption');
  expect(await note.textContent()).toContain("the sizes are unknown");
});

test("draws nothing of a thing of which only the name is known", async () => {
  const row = page.locator(".things tbody tr", { hasText: "a name" });
  expect(await row.locator("svg").count()).toBe(0);
});

test("names rows of a matrix without writing one over the other", async () => {
  const words = 'figure[aria-label="Joints over time"] text[transform*="rotate"]';
  expect(await page.locator(words).count()).toBeGreaterThan(1);
  expect(overlaps(await boxesOf(words))).toBe(0);
});

test("marks the time that is shown in a course", async () => {
  const hint = page.locator('figure[aria-label="Joints over time"] > p');
  expect(await hint.textContent()).toBe("The vertical line marks the time above.");
  expect(await page.locator(".player output").textContent()).toBe("2.0 s");
});

test("lays a curve's planes out beside each other, and names beside names", async () => {
  const figure = 'figure[aria-label^="Component planes of"]';
  const maps = await boxesOf(`${figure} image`);
  expect(maps).toHaveLength(20);
  expect(new Set(maps.map(({ left }) => Math.round(left))).size).toBeGreaterThan(3);
  await page.getByRole("combobox", { name: "Channel" }).selectOption({ label: "joints" });
  await expect.poll(() => page.locator(`${figure} image`).count()).toBe(9);
  expect(overlaps(await boxesOf(`${figure} text.note`))).toBe(0);
});

test("explains no sign that it does not draw", async () => {
  const legend = 'figure[aria-label="Outcomes"] .strip-legend';
  expect(await page.locator(legend).textContent()).toContain("nearest neighbour");
  expect(await page.locator(legend).textContent()).not.toContain("paper");
});

test("distinguishes systems of one name by their files", async () => {
  const data = reportFixture();
  const [system, claim] = [data.systems[0]!, data.claims[0]!];
  const files = ["out/noise0/results.json", "out/noise8/results.json"];
  const twins = await browser.newPage();
  const systems = files.map((file) => ({ ...system, file }));
  const claims = files.map((file) => ({ ...claim, file, system: system.name, variation: "", question: "" }));
  await twins.goto(writeReport(fileText({ ...data, systems, claims })));
  const links = await twins.locator("nav.side a", { hasText: system.name }).allTextContents();
  expect(links.map((one) => one.replaceAll("\u200b", ""))).toEqual([
    `${system.name} (noise0)`,
    `${system.name} (noise8)`,
  ]);
  expect(await twins.locator("#claims th.group").count()).toBe(2);
  await twins.close();
});

test("counts a single run as one", async () => {
  const words = await page.locator("#t_mpsom_multiplied .what").allTextContents();
  expect(words.some((one) => /, 1 run of /.test(one))).toBe(true);
  expect(await page.locator('figure[aria-label^="Confusion matrix"]').count()).toBe(1);
  expect(await page.getByRole("slider", { name: "Seed" }).count()).toBe(0);
  expect(words.join()).not.toMatch(/\b1 runs/);
  expect(await page.locator('figure[aria-label="Systems"] tbody').textContent()).not.toContain("±");
});
