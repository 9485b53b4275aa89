// The view page against a server that speaks its protocol: the commands that it sends to the program.

import { describe, expect, it } from "vitest";

import { bodyState, fakeFrame, fakeState } from "./fake_frames";
import { flatBrowser, frameShown, screenshot, words } from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage(flatBrowser);

describe("the commands that it sends", () => {
  it("plays, pauses, steps, scrubs and chooses", async () => {
    await view.open();
    await view.page.getByRole("button", { name: "Play", exact: true }).click();
    await view.received({ command: "play" });
    await view.page.getByRole("button", { name: "Pause", exact: true }).click();
    await view.received({ command: "pause" });
    await view.page.getByRole("button", { name: "Step forward" }).click();
    await view.received({ command: "step", frames: 1 });
    await view.page.getByRole("slider", { name: "Frame" }).fill("30");
    await view.received({ command: "seek", exploration: 0, frame: 30 });
    await frameShown(view.page, 30);
    await view.page.getByLabel("Speed").selectOption("4");
    await view.received({ command: "speed", speed: 4 });
    await view.page.getByLabel("Exploration", { exact: true }).selectOption("4");
    await view.received({ command: "seek", exploration: 4, frame: 0 });
    await view.page.getByLabel("System", { exact: true }).selectOption("shape_and_size");
    await view.received({ command: "system", name: "shape_and_size" });
    const learn = view.page.getByRole("button", { name: "Train", exact: true });
    await soon(() => learn.isDisabled()).toBe(true); // it was given as it has learned
  });

  it("scrubs through what is shown, though the state with it has not arrived yet", async () => {
    await view.open();
    view.server.show(2, 5);
    await frameShown(view.page, 5);
    await view.page.getByRole("slider", { name: "Frame" }).fill("30");
    await view.received({ command: "seek", exploration: 2, frame: 30 });
  });

  it("goes back in what a body still explores", async () => {
    await view.open({ ...bodyState(), live: true, exploration: 0, frames: null, duration: null });
    const slider = view.page.getByRole("slider", { name: "Frame" });
    const explored = (frame: number) =>
      soon(() => {
        view.server.send("frame", { ...fakeFrame(0, frame), frames: null, last: false });
        return slider.getAttribute("aria-valuetext");
      }).toContain(`frame ${frame + 1},`);
    await explored(20); // once the page listens
    await slider.fill("5");
    await view.received({ command: "seek", exploration: 0, frame: 5 });
    await explored(5);
    expect(await slider.getAttribute("max")).toBe("20");
  });

  it("offers no place where a body takes none", async () => {
    await view.open({ ...bodyState(), name: "texture", placement: null });
    await view.page.getByLabel("Object", { exact: true }).waitFor();
    expect(await view.page.getByLabel("turn (°)").isVisible()).toBe(false);
  });

  it("gives a body something to explore", async () => {
    await view.open(bodyState());
    await soon(() => words(view.page, ".scene-note")).toContain("There is no exploration yet");
    await view.page.getByLabel("Object", { exact: true }).selectOption("block");
    await view.received({ command: "thing", name: "block" });
    await view.page.getByLabel("turn (°)").fill("15");
    await view.page.getByLabel("x (mm)").fill("-4");
    await view.page.getByLabel("y (mm)").focus();
    await view.received({ command: "placement", x: -4, y: 0, turn: 15 });
    await view.page.getByRole("button", { name: "Explore", exact: true }).click();
    await view.received({ command: "explore" });
    view.server.refusal = "The hand cannot hold that.";
    await view.page.getByRole("button", { name: "Explore", exact: true }).click();
    await view.page.getByRole("alert").getByText("The hand cannot hold that.").waitFor();
  });

  it("starts a real body by a press of Start only", async () => {
    await view.open({ ...bodyState(), awaits_start: true });
    await soon(() => words(view.page, ".scene-note")).toContain("it moves when you press Start");
    await view.page.reload();
    await view.page.getByRole("button", { name: "Start", exact: true }).waitFor();
    await view.server.stop();
    await view.server.start();
    await view.page.getByRole("button", { name: "Try now" }).click();
    await view.page.getByRole("button", { name: "Try now" }).waitFor({ state: "hidden" });
    expect(view.server.commands).toEqual([]);
    await view.page.getByRole("button", { name: "Start", exact: true }).click();
    await view.received({ command: "explore" });
    view.server.change({ awaits_start: false, live: true });
    await view.page.getByRole("button", { name: "Restart", exact: true }).waitFor();
  });

  it("lets one watch a map learn, and stops it", async () => {
    await view.open();
    await view.page.getByRole("button", { name: "Train", exact: true }).click();
    await view.received({ command: "train" });
    await view.page.getByText(/map: step \d+ of 1000, radius/).waitFor();
    await view.page.getByRole("button", { name: "Stop training" }).click();
    await view.received({ command: "stop_training" });
    await screenshot(view.page, "view-learning");
    expect(await view.page.locator(".training .marker").count()).toBeGreaterThan(3);
  });

  it("closes a problem in all pages", async () => {
    await view.open({ ...fakeState(), problem: "A servo does not answer." });
    await view.page.getByRole("alert").getByRole("button", { name: "Close" }).click();
    await view.received({ command: "dismiss" });
    await view.page.getByText("A servo does not answer.").waitFor({ state: "hidden" });
  });

  it("groups the explorations of several recordings", async () => {
    const state = fakeState();
    state.explorations.forEach((one, i) => (one.recording = i < 3 ? "monday.mcap" : "tuesday.mcap"));
    await view.open(state);
    const groups = view.page.locator(".exploration optgroup");
    expect(await groups.evaluateAll((all) => all.map((one) => one.getAttribute("label")))).toEqual([
      "monday.mcap",
      "tuesday.mcap",
    ]);
    expect(await groups.last().locator("option").count()).toBe(3);
  });

  it("explains the page in five steps", async () => {
    await view.open();
    await view.page.getByRole("button", { name: "Tour" }).click();
    for (const panel of ["hand", "skin", "code", "map", "name"]) {
      await view.page.locator(`.panel-${panel}.toured`).waitFor();
      await view.page.keyboard.press("Enter");
    }
    await view.page.locator(".tour").waitFor({ state: "hidden" });
    expect(await view.page.locator(".toured").count()).toBe(0);
  });
});
