// Saves the explorations of this session as a recording, and the selected system, as downloads.

import { element } from "../../parts/dom";
import { saveFile } from "../../parts/save";
import type { State } from "../data";
import type { Model } from "../session/model";

export function sessionFiles(model: Model): HTMLElement {
  const recording = element("button", { type: "button", title: "All explorations that are kept, as an MCAP file" }, [
    "Save recording",
  ]);
  const system = element("button", { type: "button", title: "The trained system, for somato apply and somato live" }, [
    "Save system",
  ]);
  recording.addEventListener("click", () => void save(model, "recording", (state) => `${stem(state.name)}.mcap`));
  system.addEventListener("click", () => void save(model, "system", (state) => `${stem(state.system ?? "system")}.somato`));
  const saved = element("span", { class: "session-saved" });
  const kept = element("span", { class: "session-kept" });
  model.shownState.watch((state) => {
    saved.textContent = savedText(state?.saved ?? null);
    kept.textContent = state === null ? "" : [droppedText(state), lossesText(state.losses)].filter(Boolean).join("; ");
    recording.disabled = (state?.explorations.length ?? 0) === 0;
    system.disabled = !(state?.maps.some(({ classes }) => classes.length > 0) ?? false);
  });
  return element("div", { class: "session-files", role: "group", "aria-label": "Save" }, [saved, kept, recording, system]);
}

/** The losses, such as "2 explorations failed, 1 could not be saved". */
function lossesText({ failed, unsaved }: State["losses"]): string {
  const failures = failed === 0 ? [] : [`${failed === 1 ? "1 exploration" : `${failed} explorations`} failed`];
  return [...failures, ...(unsaved === 0 ? [] : [`${unsaved} could not be saved`])].join(", ");
}

/** Explorations and frames that are no longer kept, such as "Explorations 1 to 12 are no longer kept". */
function droppedText({ dropped, first_frame }: Pick<State, "dropped" | "first_frame">): string {
  if (first_frame > 0) return `Frames 1 to ${first_frame} of this exploration are no longer kept`;
  if (dropped === 0) return "";
  return dropped === 1 ? "Exploration 1 is no longer kept" : `Explorations 1 to ${dropped} are no longer kept`;
}

/** The file of the session on the machine of the body, such as "4 explorations saved in hand.mcap". */
function savedText(saved: State["saved"]): string {
  if (saved === null) return "";
  const explorations = saved.explorations === 1 ? "1 exploration" : `${saved.explorations} explorations`;
  return `${explorations} saved in ${saved.file}`;
}

async function save(model: Model, what: "recording" | "system", name: (state: State) => string): Promise<void> {
  const state = model.shownState.value;
  const file = await model.file(what);
  if (state !== null && file !== null) saveFile(name(state), file);
}

/** The name of a file without its ending. */
function stem(name: string): string {
  return name.replace(/\.(mcap|somato)$/, "");
}
