// The report of data that are missing, damaged, hostile or many.

import { describe, expect, test } from "vitest";

import { accessibilityViolations, screenshotPath } from "../browser";
import { goTo, ReportBrowser } from "./report_browser";
import { hostileFixture, largeFixture, reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();

describe("what goes wrong", () => {
  test.each([
    ["null", "contains no results"],
    ['{"version":1,', "damaged"],
    ["[1]", "are not a report"],
    ['{"version":7}', "version 7"],
  ])("says in a sentence what is wrong with %s", async (text, words) => {
    const { page, problems } = await report.open(text);
    expect(await page.getByRole("alert").textContent()).toContain(words);
    expect(problems).toEqual([]);
    expect(await accessibilityViolations(page)).toEqual([]);
  });

  test("a report without systems says so", async () => {
    const { page, problems } = await report.open({
      version: 2,
      somato: "1",
      systems: [],
      claims: [],
      curves: [],
    });
    expect(await page.locator("#overview").textContent()).toContain("No results were given");
    expect(problems).toEqual([]);
  });

  test("says what is missing and how to get it", async () => {
    const { page } = await report.open(data);
    expect(await (await goTo(page, "bare")).textContent()).toContain("keep system.somato beside results.json");
  });

  test("a system with half its fields is shown as far as it goes", async () => {
    const half = {
      version: 2,
      somato: "1",
      systems: [{ name: "half", protocols: [{ protocol: "train_is_test" }], trained: { planes: [{}] } }],
    };
    const { page, problems } = await report.open(JSON.stringify(half));
    expect(await page.locator("section.system h2").first().textContent()).toBe("half");
    await goTo(page, "half");
    expect(problems).toEqual([]);
  });

  test("hostile names are text, and numbers that are none are not drawn", async () => {
    const nasty = hostileFixture();
    const { page, problems } = await report.open(nasty);
    await goTo(page, (await page.locator("section.system").first().getAttribute("id"))!);
    expect(await page.locator("section.system h2").first().textContent()).toBe(nasty.systems[0]!.name);
    expect(await page.evaluate(() => (globalThis as { __hurt?: number }).__hurt)).toBeUndefined();
    expect(await page.locator("main img").count()).toBe(0);
    expect(await page.locator("svg [d*=NaN], svg [cx=NaN], svg [x=NaN]").count()).toBe(0);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(1280);
    expect(problems).toEqual([]);
    await page.screenshot({ path: screenshotPath("report-hostile"), fullPage: true });
  });

  test("thirty systems of 900 neurons and 500 runs open at once", async () => {
    const { page, problems } = await report.open(largeFixture());
    // Only what is near to what is seen is drawn.
    expect(await page.locator("[data-cell]").count()).toBeLessThan(20_000);
    await goTo(page, "system_30");
    expect(await page.locator("#system_30 [data-cell]").count()).toBeGreaterThan(900);
    expect(problems).toEqual([]);
  });
});
