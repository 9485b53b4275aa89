// The report for all who read it: by keyboard, by a reading machine, in the dark, on paper, on a telephone.

import { describe, expect, test } from "vitest";

import { accessibilityViolations, screenshotPath } from "../browser";
import { figureOf, goTo, ReportBrowser } from "./report_browser";
import { reportFixture } from "./report_fixture";

const report = new ReportBrowser();
const data = reportFixture();

const kSizes: [width: number, height: number][] = [
  [1366, 768],
  [1920, 1080],
  [390, 844],
];

describe("who reads it", () => {
  test("finds no barrier in either colours, at three sizes, and nothing scrolls sideways", async () => {
    const { page } = await report.open(data, { colorScheme: "light", reducedMotion: "reduce" });
    for (const system of ["t_mpsom_multiplied", "hardness", "bare"]) await goTo(page, system);
    for (const colorScheme of ["light", "dark"] as const) {
      await page.emulateMedia({ colorScheme });
      for (const [width, height] of kSizes) {
        await page.setViewportSize({ width, height });
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
        // Nothing but colours differs in the dark, and nothing but sizes in another window.
        const isFirst = width === kSizes[0]![0];
        const rules = colorScheme === "dark" ? ["color-contrast"] : isFirst ? [] : ["target-size"];
        if (isFirst || colorScheme === "light") expect(await accessibilityViolations(page, rules)).toEqual([]);
        await page.evaluate(() => scrollTo(0, 0));
        await page.screenshot({ path: screenshotPath(`report-first-${width}-${colorScheme}`) });
        await page.evaluate(() => document.querySelector("#t_mpsom_multiplied")?.scrollIntoView());
        await page.screenshot({ path: screenshotPath(`report-system-${width}-${colorScheme}`) });
      }
    }
  });

  test("needs no mouse", async () => {
    const { page } = await report.open(data);
    const names = new Set<string>();
    for (let i = 0; i < 14; i += 1) {
      await page.keyboard.press("Tab");
      names.add(await page.evaluate(() => document.activeElement?.tagName ?? ""));
    }
    expect([...names].sort()).toEqual(expect.arrayContaining(["A", "BUTTON"]));
    const section = await goTo(page, "t_mpsom_multiplied");
    const map = figureOf(section, "Winners").getByRole("application");
    await map.focus();
    for (const key of ["Home", "ArrowRight", "ArrowDown"]) await page.keyboard.press(key);
    expect(await figureOf(section, "Winners").locator(".readout").textContent()).toContain("row 2, column 2");
    const planes = figureOf(section, "Component plane of an element of touch");
    await planes.getByRole("application").focus();
    await page.keyboard.press("Home");
    await page.keyboard.press("Enter");
    expect(await figureOf(section, "Weights of one neuron on the hand").locator(".what").textContent()).toBe(
      "Neuron at row 1, column 1",
    );
  });

  test("turns the colours round with a button, and finds them so again", async () => {
    const { page } = await report.open(data, { colorScheme: "light" });
    const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
    const light = await background();
    await page.getByRole("button", { name: "Use dark colours" }).click();
    expect(await background()).not.toBe(light);
    await page.reload();
    expect(await background()).not.toBe(light);
    await page.evaluate(() => localStorage.clear()); // all files have the same
  });

  test("has no sideways scrolling where it is drawn for a telephone", async () => {
    const { page } = await report.open(data, { width: 390, height: 844 });
    for (const system of ["t_mpsom_multiplied", "hardness"]) await goTo(page, system);
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await page.screenshot({ path: screenshotPath("report-390") });
  });

  test("prints light, without controls, everything drawn", async () => {
    const { page } = await report.open(data, { colorScheme: "dark" });
    await page.emulateMedia({ media: "print", colorScheme: "dark" });
    await expect.poll(() => page.locator(".lazy:empty:visible").count()).toBe(0);
    expect(await page.evaluate(() => getComputedStyle(document.body).backgroundColor)).toBe(
      "rgb(255, 255, 255)",
    );
    expect(await page.locator("button:visible, select:visible, nav:visible").count()).toBe(0);
    // On A4 with margins of 14 mm no figure is taller than a page; tables may go over pages.
    await page.setViewportSize({ width: 688, height: 1017 });
    const heights = await page
      .locator("figure:not(:has(table))")
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().height));
    expect(Math.max(...heights)).toBeLessThan(1017);
    const words = await page.locator("main").evaluate((main) => (main as HTMLElement).innerText);
    expect(words).not.toMatch(/Click|Select a/);
    await page.screenshot({ path: screenshotPath("report-print"), fullPage: true });
    const pdf = await page.pdf({ path: screenshotPath("report-print").replace(/png$/, "pdf"), format: "A4" });
    expect(pdf.length).toBeGreaterThan(50_000);
  });
});
