// The report in a browser: its numbers equal those of its data, and choices change its figures. Most tests go through
// one report, in their order, because to draw it takes longer than to read it.

import type { Locator, Page } from "playwright-core";
import { beforeAll, describe, expect, test } from "vitest";

import { screenshotPath } from "../browser";
import { figureOf, goTo, readoutAt, ReportBrowser, savedRows, scrollTo } from "./report_browser";
import { reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();
const hand = data.systems[0]!;

describe("in one report", () => {
  let page: Page;
  let problems: string[];
  let section: Locator;

  beforeAll(async () => {
    ({ page, problems } = await report.open(data));
  });

  test("has every system, its figures and its claims in the overview", async () => {
    const rows = page.locator("#overview tbody tr");
    expect(await rows.count()).toBe(data.systems.filter((system) => system.question === "").length);
    expect(await page.locator(".question h2").allTextContents()).toEqual([
      "Does the size of the map matter?",
    ]);
    const accuracy = hand.protocols[0]!.metrics["accuracy"]!;
    expect(await rows.first().textContent()).toContain(
      `${accuracy.mean!.toFixed(2)} ± ${accuracy.sd!.toFixed(2)}`,
    );
    const claims = page.locator("#claims tbody tr:has(td)");
    expect(await claims.count()).toBe(data.claims.length);
    expect(await claims.first().textContent()).toContain(`${Math.round(data.claims[0]!.share * 100)} %`);
    expect(problems).toEqual([]);
    await page.screenshot({ path: screenshotPath("report-overview") });
  });

  test("a system of a question opens from its table", async () => {
    const fold = page.locator(".fold");
    expect(await fold.locator("[data-cell]").count()).toBe(0);
    const link = await scrollTo(page.locator(".question tbody a"));
    await link.click();
    await expect.poll(() => fold.locator("[data-cell]").count()).toBeGreaterThan(120);
    expect(await fold.evaluate((one: HTMLDetailsElement) => one.open)).toBe(true);
  });

  describe("a system", () => {
    beforeAll(async () => {
      section = await goTo(page, "t_mpsom_multiplied");
    });

    test("shows for a neuron how many samples of which class it won", async () => {
      const figure = figureOf(section, "Winners");
      const run = hand.protocols[0]!.runs[0]!;
      const winner = run.winners[0]!;
      const own = run.labels.filter((_, i) => run.winners[i] === winner);
      const expected = `row ${Math.floor(winner / 15) + 1}, column ${(winner % 15) + 1}: ${own.filter((name) => name === own[0]).length} × ${own[0]}`;
      expect(await readoutAt(figure, winner)).toContain(expected);
      expect(await figure.locator(".map-marks .marker").count()).toBe(run.winners.length);
    });

    test("saves winners, U-matrix and planes as the numbers that it was given", async () => {
      const winners = await savedRows(figureOf(section, "Winners"));
      expect(winners[0]).toEqual(["sample", "winner", "row", "column", "class", "named"]);
      const run = hand.protocols[0]!.runs[0]!;
      expect(winners.slice(1).map((row) => Number(row[1]) - 1)).toEqual(run.winners);
      expect(winners.slice(1).map((row) => row[5])).toEqual(run.predictions);
      const distances = await savedRows(figureOf(section, "U-matrix"));
      expect(distances.slice(1).map((row) => Number(row[3]))).toEqual(hand.trained!.u_matrix);
      const planes = await savedRows(figureOf(section, "Component plane of an element of touch"));
      expect(planes[0]!.slice(3)).toEqual(hand.trained!.planes[0]!.channel.elements);
      expect(planes[1]!.slice(3).map(Number)).toEqual(hand.trained!.planes[0]!.values[0]);
    });

    test("shows outcomes and confusions of the results", async () => {
      const outcomes = await savedRows(figureOf(section, "Outcomes"));
      const accuracies = outcomes
        .filter((row) => row[0] === "accuracy" && row[1] === "here")
        .map((row) => Number(row[3]));
      expect(accuracies).toEqual(hand.protocols[0]!.metrics["accuracy"]!.values);
      expect(outcomes.some((row) => row[0] === "neighbours_same_class" && row[1] === "paper" && row[3] === "29")).toBe(true);
      const confusions = await savedRows(figureOf(section, "Confusion matrix of all runs"));
      const right = hand.protocols[0]!.runs.flatMap((run) =>
        run.labels.filter((one, i) => one === "boccia" && run.predictions[i] === one),
      );
      expect(Number(confusions[1]![1])).toBe(right.length);
    });

    test("draws hexagonal maps, things, receptive fields, moments and curves", async () => {
      const first = section;
      expect(await first.locator(".things tbody tr").count()).toBe(hand.things.length);
      expect(await figureOf(first, "Touch at a moment").locator("[data-cell]").count()).toBe(45);
      expect(await figureOf(first, "Weights of hand for wrist").locator("image").count()).toBe(1);
      const field = await savedRows(figureOf(first, "Receptive field"));
      expect(field.slice(1).map((row) => Number(row[1]))).toEqual(
        hand.trained!.receptive_fields[0]!.weights[12],
      );
      const second = await goTo(page, "hardness");
      const d = await figureOf(second, "Winners").locator("[data-cell]").first().getAttribute("d");
      expect(d!.split(/[ML]/).length).toBe(7); // six corners
      await page.evaluate(() => (location.hash = "curves"));
      const curve = await savedRows(page.locator("#curves figure"));
      expect(curve.length - 1).toBe(data.curves[0]!.lines.flatMap((line) => line.points).length);
      expect(problems).toEqual([]);
    });

    test("a neuron shows its hand, an element its plane", async () => {
      const map = figureOf(section, "Component plane of an element of touch");
      const onHand = figureOf(section, "Weights of one neuron on the hand");
      await map.locator('[data-cell="100"]').click();
      const touch = hand.trained!.planes[0]!;
      expect((await savedRows(onHand)).slice(1).map((row) => Number(row[1]))).toEqual(touch.values[100]);
      await onHand.locator('[data-cell="7"]').click();
      expect(await map.locator(".what").textContent()).toBe("finger1_distal_1");
      expect(await map.getByRole("combobox", { name: "Element" }).inputValue()).toBe("7");
      const all = figureOf(section, "Component planes of touch, arranged on the hand");
      expect(await all.locator("image").count()).toBe(45);
      await all.locator('[data-element="12"]').click();
      expect(await map.getByRole("combobox", { name: "Element" }).inputValue()).toBe("12");
      await section.getByRole("combobox", { name: "Channel" }).selectOption({ label: "joints" });
      expect(await figureOf(section, "Weights of one neuron on the hand").locator("[data-cell]").count()).toBe(6);
    });

    test("goes from seed to seed by arrow keys", async () => {
      await section.getByRole("slider", { name: "Seed" }).focus();
      await page.keyboard.press("ArrowRight");
      await page.keyboard.press("ArrowRight");
      const third = hand.protocols[0]!.runs[2]!;
      const rows = await savedRows(figureOf(section, "Winners"));
      expect(rows.slice(1).map((row) => Number(row[1]) - 1)).toEqual(third.winners);
    });

    test("changes with seed, label and protocol", async () => {
      const winners = figureOf(section, "Winners");
      await section.getByRole("slider", { name: "Seed" }).fill("4");
      const fifth = hand.protocols[0]!.runs[4]!;
      expect((await savedRows(winners)).slice(1).map((row) => Number(row[1]) - 1)).toEqual(fifth.winners);
      await section.getByRole("radio", { name: "shape" }).check();
      expect(await winners.locator(".what").textContent()).toContain("by shape");
      expect(await winners.locator(".marker-legend text").count()).toBe(3);
      await section
        .getByRole("combobox", { name: "Protocol" })
        .selectOption({ label: "Leave out each object" });
      // Each object was tested on a map of its own: never several maps in one picture.
      const { runs, folds } = hand.protocols[1]!;
      const held = runs[4]!;
      await section.getByRole("combobox", { name: "Map" }).selectOption({ index: 2 });
      const own = held.winners.filter((_, sample) => folds![sample] === 2);
      const rows = (await savedRows(winners)).slice(1);
      expect(rows.map((row) => Number(row[1]) - 1)).toEqual(own);
      expect(rows.map((row) => Number(row[0]) - 1)).toEqual([10, 11, 12, 13, 14]);
      expect(await winners.locator(".what").textContent()).toContain("by shape, seed 5, fold 3 of 6");
    });

    test("a module shows its settings", async () => {
      await section.getByRole("button", { name: /^hand/ }).press("Enter");
      const details = await section.locator(".module-details").textContent();
      expect(details).toContain("arbor_sigma");
      expect(details).toContain("not given in the paper");
    });
  });
});

test("shows the verdicts, and comparisons of our own apart", async () => {
  const [one, other, ...rest] = data.claims;
  const chance = "holds, but so does chance" as const;
  const undecided = { verdict: "cannot be decided here", reason: "12 pairs; 20 are needed" } as const;
  const against = { than: "small", than_metric: "baseline_accuracy" };
  const own = { ...other!, paper: "", ...against, ...undecided };
  const claims = [own, { ...one!, verdict: chance, at_least: 4, at_most: 6 }];
  expect(rest.length).toBeGreaterThan(0);
  const { page } = await report.open({ ...data, claims });
  const rows = page.locator("#claims tbody tr");
  const texts = await rows.allTextContents();
  expect(texts.findIndex((text) => text.includes(one!.text))).toBe(1);
  expect(texts[1]).toContain("between 4 and 6");
  expect(texts[2]).toBe("Additional comparisons");
  expect(texts[4]).toContain("minus baseline_accuracy of small");
  expect(texts[4]).toContain("cannot be decided here, 12 pairs; 20 are needed");
  expect(await page.locator("#claims .share").first().getAttribute("class")).toBe("share neutral");
  expect(await page.locator(".tiles").getAttribute("aria-label")).toBe("Of 1 claim of the papers");
  expect(await page.locator(".tile").allTextContents()).toContain(`1${chance}`);
});
