// The view page by keyboard: every control, those of the scene too, can be reached, and shows that it has the focus.

import { expect, it } from "vitest";

import { fakeState } from "./fake_frames";
import { kTaxels } from "./fake_hand";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage();

it("needs no mouse", async () => {
  await view.open();
  const keys: [string, object][] = [
    ["ArrowRight", { command: "step", frames: 1 }],
    ["ArrowLeft", { command: "step", frames: -1 }],
    ["Shift+ArrowRight", { command: "step", frames: 10 }],
    ["ArrowUp", { command: "speed", speed: 2 }],
    ["End", { command: "seek", exploration: 0, frame: 59 }],
    ["]", { command: "seek", exploration: 1, frame: 0 }],
    ["Space", { command: "play" }],
  ];
  for (const [key, command] of keys) {
    await view.page.keyboard.press(key);
    await view.received(command);
  }
  await view.page.keyboard.press("4");
  expect(await view.page.evaluate(() => document.activeElement?.textContent)).toContain("Map");
  await view.page.locator(".panel-map svg[role=application]").focus();
  for (const key of ["ArrowDown", "ArrowRight", "Enter"]) await view.page.keyboard.press(key);
  await view.page.waitForSelector('.closer h3:text-is("Neuron at row 2, column 2")');
  await view.page.getByLabel("Touch sensor", { exact: true }).focus();
  await view.page.keyboard.press("ArrowDown");
  await view.page.waitForSelector(`.closer h3:text-is("Touch sensor ${kTaxels[0]}")`);
  await view.page.keyboard.press("Escape");
  await view.page.locator(".drawer").waitFor({ state: "hidden" });
  await view.page.keyboard.press("?");
  await view.page.getByRole("dialog").waitFor();
  await view.page.keyboard.press("Escape");
  expect(await reachedByTab()).toEqual(await view.page.locator(kControls).count());
});

it("gives names by keys, and undoes them", async () => {
  const names = [{ name: "cup", explorations: 2 }, { name: "tea ball", explorations: 0 }];
  const naming = { names, each: 5, next: { name: "cup", number: 3 }, id: 100, given: null, last: null };
  await view.open({ ...fakeState(), naming });
  const note = () => view.page.locator(".naming-note > span").first().innerText();
  await view.page.keyboard.press("Numpad2");
  await view.received({ command: "name", label: "object", value: "tea ball", id: 100 });
  await soon(note).toBe("✓ Exploration 1: tea ball");
  await view.page.keyboard.press("0"); // it has a name
  await soon(note).toBe("✗ Exploration 1 has the name “tea ball”.");
  view.server.change({ naming: { ...naming, given: "tea ball", last: { exploration: 0, id: 100, label: "object", name: "tea ball" } } });
  await view.page.getByText("Next: cup, 3 of 5").waitFor();
  await view.page.keyboard.press("u");
  await view.received({ command: "undo_name", id: 100, label: "object", value: "tea ball" });
  await soon(note).toBe("✓ Undone: Exploration 1: tea ball");
  await view.page.keyboard.press("n");
  await view.page.keyboard.type("12u"); // in the field
  await view.page.keyboard.press("Enter");
  await view.received({ command: "name", label: "object", value: "12u", id: 100 });
  await view.page.keyboard.press("Shift+4");
  expect(await view.page.evaluate(() => document.activeElement?.textContent)).toContain("Map");
  await view.page.keyboard.press("?");
  await view.page.keyboard.press("1"); // the dialog is open
  await view.page.keyboard.press("Escape");
  expect(view.server.commands.map(({ command }) => command)).toEqual(["name", "undo_name", "name"]);
});

it("shows where the focus is", async () => {
  await view.open();
  const unseen: (string | null)[] = [];
  await reachedByTab(async () => void unseen.push(await hasVisibleFocus()));
  expect(unseen.length).toBeGreaterThan(20);
  expect(unseen.filter((name) => name !== null)).toEqual([]);
});

const kControls =
  "button:visible:enabled, summary:visible, select:visible:enabled, input:visible:enabled:not([type=radio]), input[type=radio]:checked, [tabindex='0']:visible";

/** The controls that Tab comes by on its way around the page; `at` is done at each. */
async function reachedByTab(at: () => Promise<void> = async () => undefined): Promise<number> {
  await view.page.evaluate(() => {
    (document.activeElement as HTMLElement | null)?.blur();
    (window as { seen?: Set<Element> }).seen = new Set();
  });
  let reached = 0;
  for (let i = 0; i < 120; i += 1) {
    await view.page.keyboard.press("Tab");
    const stop = await view.page.evaluate(() => {
      const { seen } = window as unknown as { seen: Set<Element> };
      const at = document.activeElement!;
      if (at === document.body) return "outside"; // between the page's end and its beginning
      return seen.size < seen.add(at).size ? "new" : "known";
    });
    if (stop === "known") break;
    if (stop === "outside") continue;
    reached += 1;
    await at();
  }
  return reached;
}

/** Whether what has the focus, or its label, looks different without it. */
async function hasVisibleFocus(): Promise<string | null> {
  const focused = await view.page.evaluate(() => {
    const at = document.activeElement!;
    const { x, y, width, height } = (at.closest(".segments label") ?? at).getBoundingClientRect();
    const name = at.getAttribute("aria-label") ?? at.textContent ?? "";
    const clip = { x: x - 5, y: y - 5, width: width + 10, height: height + 10 };
    return { name: `${at.tagName} ${name}`, clip };
  });
  const { name, clip } = focused;
  const before = await view.page.screenshot({ clip });
  await view.page.evaluate(() => (document.activeElement as HTMLElement).blur());
  return before.equals(await view.page.screenshot({ clip })) ? name : null;
}
