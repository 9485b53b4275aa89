// The view page against a server that speaks its protocol: unknown things, and names that the system learns.

import { beforeEach, describe, expect, it } from "vitest";

import type { State, Taught } from "../../src/view/data";
import { kColourRules } from "../browser";
import { fakeFrame, fakeState, kFrames, unknownFrame } from "./fake_frames";
import { accessibilityViolations, flatBrowser, frameShown, rulesFor, screenshot, words } from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage(flatBrowser);
const kTaught: Taught = { exploration: 1, name: "cup", before: "unknown", neuron: 17, problem: null };
const kTeaching: State = { ...fakeState(), teaches: true };
const question = () => view.page.getByRole("form", { name: "Name for the system to learn" });
const input = () => view.page.getByLabel("What is it?");

async function showUnknown(exploration = 1): Promise<void> {
  view.server.send("frame", unknownFrame(exploration));
  await soon(() => words(view.page, ".reading-answer")).toBe("unknown");
}

describe("an unknown thing", () => {
  beforeEach(() => view.open());

  it("is shown with the most similar class and its novelty", async () => {
    await showUnknown();
    const frame = unknownFrame(1);
    expect(await words(view.page, ".reading-similar")).toBe(`Most similar: ${frame.reading!.candidates[0]!.name}`);
    const meter = view.page.getByRole("meter", { name: "Novelty" });
    expect(await meter.getAttribute("aria-valuenow")).toBe("1.43");
    expect(await words(view.page, ".novelty")).toMatch(/Novelty\s+1\.43\s+above 1: unknown/);
    expect(await view.page.getByRole("meter", { name: "Confidence" }).isVisible()).toBe(false);
    expect(await words(view.page, ".verdict")).toBe("✗ Not recognized: it is boccia cylinder");
    await soon(() => view.page.locator(".reading-spoken").innerText()).toContain("unknown, Most similar:");
    expect(await question().isVisible()).toBe(false); // the system does not learn names
  });

  it("has no meter where the system has no threshold, and neither has what is known", async () => {
    view.server.show(1, 40);
    await frameShown(view.page, 40);
    expect(await view.page.getByRole("meter", { name: "Novelty" }).isVisible()).toBe(false);
    expect(await view.page.locator(".reading-similar").isVisible()).toBe(false);
    expect(await view.page.getByRole("meter", { name: "Confidence" }).isVisible()).toBe(true);
  });
});

describe("a system that learns names", () => {
  beforeEach(() => view.open(kTeaching));

  it("asks for the name of an unknown thing at its end, and learns it", async () => {
    const middle = unknownFrame(1);
    view.server.send("frame", { ...middle, frame: 40, last: false });
    await frameShown(view.page, 40);
    expect(await question().isVisible()).toBe(false);
    await view.page.locator(".naming-name").focus();
    await showUnknown();
    await question().waitFor();
    expect(await view.page.evaluate(() => document.activeElement?.className)).toBe("naming-name");
    await soon(() => view.page.locator(".question-spoken").innerText()).toContain("What is it?");
    await input().fill("tea cup");
    await view.page.keyboard.press("Enter");
    await view.received({ command: "name", label: "object", value: "tea cup", id: 101 });
    await question().waitFor({ state: "hidden" });
    expect(view.server.commands.map(({ command }) => command)).toEqual(["name"]); // nothing played
  });

  it("does not ask again for an exploration after Escape or Not now, but for another one", async () => {
    await showUnknown(1);
    await input().focus();
    await view.page.keyboard.press("Escape");
    await question().waitFor({ state: "hidden" });
    expect(await view.page.evaluate(() => document.activeElement?.className)).toContain("reading-answer");
    await showUnknown(2);
    await question().waitFor();
    await view.page.getByRole("button", { name: "Not now" }).click();
    await question().waitFor({ state: "hidden" });
    await showUnknown(1);
    await view.page.waitForTimeout(200);
    expect(await question().isVisible()).toBe(false);
    expect(view.server.commands).toEqual([]);
  });

  it("waits while a name is typed", async () => {
    view.server.change({ playing: true });
    await showUnknown(0);
    await input().focus();
    await view.page.keyboard.type("cu"); // the second letter may come before the new state
    await view.received({ command: "pause" });
    view.server.change({ playing: false });
    await view.page.keyboard.type("p");
    await view.page.keyboard.press("Enter");
    await soon(() => view.server.commands.map(({ command }) => command)).toEqual(["pause", "name", "play"]);
    expect(await view.page.evaluate(() => document.activeElement?.className)).toContain("reading-answer");
    await view.page.getByText("Learned as “cup”").waitFor();
  });

  it("keeps a name that is refused", async () => {
    await showUnknown();
    view.server.refusal = "A name has at most 256 bytes.";
    await input().fill("cup");
    await view.page.getByRole("button", { name: "Teach" }).click();
    await view.page.getByRole("alert").getByText("A name has at most 256 bytes.").waitFor();
    expect([await input().isVisible(), await input().inputValue()]).toEqual([true, "cup"]);
  });

  it("states what was learned from an exploration, and marks the neuron", async () => {
    view.server.change({ taught: [kTaught] });
    await showUnknown();
    expect(await question().isVisible()).toBe(false);
    await soon(() => words(view.page, ".taught")).toContain("Learned as “cup” (read as unknown before)");
    expect(await view.page.locator(".panel-map .map-ring.marked").count()).toBe(1);
    view.server.change({ taught: [{ ...kTaught, neuron: null, problem: "The map is full." }] });
    await soon(() => words(view.page, ".taught.failed")).toBe("The map is full.");
    expect(await view.page.locator(".panel-map .map-ring.marked").count()).toBe(0);
    view.server.show(2, 40);
    await frameShown(view.page, 40);
    await soon(() => view.page.locator(".taught:visible").count()).toBe(0);
  });

  it("remarks that a name was learned before in this session", async () => {
    view.server.change({ taught: [{ ...kTaught, name: "block" }] });
    const frame = fakeFrame(2, kFrames - 1);
    frame.maps["map"]!.winner = 17;
    view.server.send("frame", frame);
    await soon(() => view.page.locator(".taught:visible").allInnerTexts()).toEqual([
      "Learned in this session, from exploration 2.",
    ]);
  });

  it("says at the name that it is learned", async () => {
    await soon(() => view.page.locator(".naming-name").getAttribute("title")).toContain("the system learns it");
    view.server.change({ teaches: false });
    await soon(() => view.page.locator(".naming-name").getAttribute("title")).not.toContain("learns");
  });
});

it("invites to teach only where the system learns names", async () => {
  await view.open({ ...kTeaching, demonstrated: 1 });
  const sentence = view.page.getByRole("complementary", { name: "Invitation" }).getByText("the system learns it");
  await sentence.waitFor();
  view.server.change({ teaches: false });
  await sentence.waitFor({ state: "hidden" });
});

describe("for everyone", () => {
  for (const [colorScheme, width] of [
    ["light", 1366],
    ["dark", 1920],
    ["light", 390],
    ["dark", 390],
  ] as const)
    it(`has no faults that axe finds, ${colorScheme}, ${width} pixels wide`, async () => {
      await view.open(kTeaching, { colorScheme, width });
      const rules = width === 390 && colorScheme === "dark" ? kColourRules : rulesFor(colorScheme, width);
      await showUnknown();
      await question().waitFor();
      await question().scrollIntoViewIfNeeded();
      expect(await view.page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      await screenshot(view.page, `view-${width}-${colorScheme}-unknown`);
      expect(await accessibilityViolations(view.page, rules)).toEqual([]);
      view.server.change({ taught: [kTaught] });
      await view.page.locator(".taught:visible").waitFor();
      await screenshot(view.page, `view-${width}-${colorScheme}-taught`);
      expect(await accessibilityViolations(view.page, rules)).toEqual([]);
    });
});
