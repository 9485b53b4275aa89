// The view page against a server that speaks its protocol: names, files and the invitation of a demonstration.

import { readFileSync } from "node:fs";

import { expect, it } from "vitest";

import { bodyState } from "./fake_frames";
import { flatBrowser, frameShown } from "./view_browser";
import { soon, ViewedPage } from "./viewed_page";

const view = new ViewedPage(flatBrowser);

it("names what is touched by a click", async () => {
  await view.open();
  await view.page.locator(".naming-name").click();
  const input = view.page.getByLabel("Name of what is touched");
  await input.fill("tea cup");
  await view.page.keyboard.press("Enter");
  await view.received({ command: "name", label: "object", value: "tea cup", id: 100 });
  view.server.change({ labels: { object: "tea cup" } });
  await soon(() => view.page.locator(".naming-name").innerText()).toContain("tea cup");
});

it("saves the recording and the system of a session", async () => {
  await view.open();
  for (const [button, name, content] of [
    ["Save recording", "hand2.mcap", "a recording"],
    ["Save system", "tensor_chain.somato", "a system"],
  ] as const) {
    const download = view.page.waitForEvent("download");
    await view.page.getByRole("button", { name: button }).click();
    const saved = await download;
    expect(saved.suggestedFilename()).toBe(name);
    expect(readFileSync(await saved.path(), "utf8")).toBe(content);
  }
});

it("shows what is saved on the disk", async () => {
  await view.open();
  const saved = view.page.locator(".session-saved");
  expect(await saved.textContent()).toBe("");
  view.server.change({ saved: { file: "hand.mcap", explorations: 1 } });
  await soon(() => saved.textContent()).toBe("1 exploration saved in hand.mcap");
  view.server.change({ saved: { file: "hand.mcap", explorations: 4 } });
  await soon(() => saved.textContent()).toBe("4 explorations saved in hand.mcap");
});

it("shows what is no longer kept", async () => {
  await view.open();
  const kept = view.page.locator(".session-kept");
  expect(await kept.textContent()).toBe("");
  view.server.change({ dropped: 12 });
  await soon(() => kept.textContent()).toBe("Explorations 1 to 12 are no longer kept");
  view.server.change({ first_frame: 30 });
  await soon(() => kept.textContent()).toBe("Frames 1 to 30 of this exploration are no longer kept");
  view.server.change({ dropped: 0, first_frame: 0, losses: { failed: 2, unsaved: 1, viewers: 0 } });
  await soon(() => kept.textContent()).toBe("2 explorations failed, 1 could not be saved");
});

it("invites after a round of a demonstration, until it is closed", async () => {
  await view.open({ ...bodyState(), demonstrated: 0 });
  const invitation = view.page.getByRole("complementary", { name: "Invitation" });
  await view.page.locator(".session").waitFor();
  expect(await invitation.isVisible()).toBe(false);
  view.server.change({ demonstrated: 1 });
  await invitation.getByRole("button", { name: "Explore an object" }).click();
  await view.received({ command: "explore" });
  await soon(() => invitation.isVisible()).toBe(false);
  view.server.change({ demonstrated: 2 });
  expect(await invitation.isVisible()).toBe(false);
});

it("saves a picture and a film of the tab", async () => {
  await view.open();
  const saved = async (button: string): Promise<Buffer> => {
    const download = view.page.waitForEvent("download");
    await view.page.getByRole("button", { name: button }).click();
    return readFileSync(await (await download).path());
  };
  const picture = await saved("Save picture");
  expect(picture.subarray(1, 4).toString()).toBe("PNG");
  expect(picture.length).toBeGreaterThan(10_000); // an empty picture has less
  await view.page.getByRole("button", { name: "Record film" }).click();
  await view.page.getByRole("button", { name: "Stop film" }).waitFor();
  // A page at rest is not drawn, and a tab that is not drawn is not captured.
  const redrawn = view.page.locator(".film-redrawn");
  expect(await redrawn.evaluate((mark) => mark.getAnimations().map((one) => one.playState))).toEqual(["running"]);
  for (let frame = 1; frame <= 10; frame += 1) {
    view.server.show(0, frame * 5);
    await frameShown(view.page, frame * 5);
    await view.page.waitForTimeout(50); // a film takes time
  }
  const film = await saved("Stop film");
  expect(film.subarray(0, 4).toString("hex")).toBe("1a45dfa3"); // of every WebM file
  expect(film.length).toBeGreaterThan(1000);
  await view.page.getByRole("button", { name: "Record film" }).waitFor();
  expect(await redrawn.count()).toBe(0);
});
