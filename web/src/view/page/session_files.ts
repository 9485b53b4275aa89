// Saves the explorations of this session as a recording, and the selected system, as downloads.

import { element } from "../../parts/dom";
import { saveFile } from "../../parts/save";
import type { State } from "../data";
import type { Model } from "../session/model";

export function sessionFiles(model: Model): HTMLElement {
  const recording = element("button", { type: "button", title: "All explorations, as an MCAP file" }, [
    "Save recording",
  ]);
  const system = element("button", { type: "button", title: "The trained system, for somato apply and somato live" }, [
    "Save system",
  ]);
  recording.addEventListener("click", () => void save(model, "recording", (state) => `${stem(state.name)}.mcap`));
  system.addEventListener("click", () => void save(model, "system", (state) => `${stem(state.system ?? "system")}.somato`));
  const saved = element("span", { class: "session-saved" });
  model.shownState.watch((state) => {
    saved.textContent = savedText(state?.saved ?? null);
    recording.disabled = (state?.explorations.length ?? 0) === 0;
    system.disabled = !(state?.maps.some(({ classes }) => classes.length > 0) ?? false);
  });
  return element("div", { class: "session-files", role: "group", "aria-label": "Save" }, [saved, recording, system]);
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
