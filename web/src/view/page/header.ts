// The source, the selected system, and the settings of the page.

import { element, fill } from "../../parts/dom";
import { themeButton } from "../../parts/theme";
import type { State } from "../data";
import type { Model } from "../session/model";
import { ageNote } from "./age_note";
import { labelled } from "./transport";

const kNone = "";

export interface HeaderActions {
  help: () => void;
  tour: () => void;
}

export function pageHeader(model: Model, { help, tour }: HeaderActions): HTMLElement {
  const source = element("p", { class: "source" });
  const live = element("span", { class: "live" }, ["exploring now"]);
  const system = systemChoice(model);
  const more = element(
    "button",
    { type: "button", "aria-label": "Help: the keys and the connection", title: "Help (?)", onclick: help },
    ["?"],
  );
  const guide = element("button", { type: "button", title: "The page in five steps", onclick: tour }, ["Tour"]);
  model.shownState.watch((state) => {
    live.hidden = !(state?.live ?? false);
    fill(source, state === null ? ["connecting to the program"] : sourceWords(state));
    if (state !== null) document.title = `${state.name} – Somato view`;
  });
  const tools = element("div", { class: "header-tools" }, [labelled("System", system), guide, themeButton(), more]);
  return element("header", { class: "page-head" }, [element("h1", {}, ["Somato"]), source, live, ageNote(model), tools]);
}

function sourceWords(state: State): (Node | string)[] {
  const kind = state.source === "recording" ? "recording" : "body";
  return [element("span", { class: "muted" }, [kind]), element("strong", {}, [state.name])];
}

function systemChoice(model: Model): HTMLSelectElement {
  const choice = element("select", { "aria-label": "System", class: "system-choice" });
  let listed = "";
  choice.addEventListener("change", () => {
    if (choice.value !== kNone) void model.send({ command: "system", name: choice.value });
  });
  model.shownState.watch((state) => {
    const text = JSON.stringify([state?.systems ?? [], state?.system === null]);
    if (text !== listed) fill(choice, state === null ? [] : options(state));
    listed = text;
    choice.disabled = (state?.systems.length ?? 0) === 0;
    choice.value = state?.system ?? kNone;
  });
  return choice;
}

function options(state: State): HTMLOptionElement[] {
  const none = state.system === null ? [element("option", { value: kNone }, ["none"])] : [];
  return [
    ...none,
    ...state.systems.map(({ name, text }) => element("option", { value: name, title: text }, [name])),
  ];
}
