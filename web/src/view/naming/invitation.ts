// After the first round of a demonstration: an invitation to train a system or to explore.

import { element } from "../../parts/dom";
import type { State } from "../data";
import type { Model } from "../session/model";

export function invitation(model: Model): HTMLElement {
  const train = element("button", { type: "button", class: "primary" }, ["Train another system"]);
  const explore = element("button", { type: "button" }, ["Explore an object"]);
  const close = element("button", { type: "button" }, ["Close"]);
  const teaching = element("span", {}, [" If the system reads an object as unknown, give its name, and the system learns it."]);
  const root = element("aside", { class: "invitation", "aria-label": "Invitation", hidden: true }, [
    element("p", {}, [
      "The hand has explored every object once, and now repeats the explorations. You can train another system on them, or select an object and let the hand explore it.",
      teaching,
    ]),
    element("div", { class: "invitation-buttons" }, [train, explore, close]),
  ]);
  let dismissed = false;
  const show = (): void => {
    root.hidden = dismissed || (model.shownState.value?.demonstrated ?? 0) === 0;
  };
  const dismiss = (): void => {
    dismissed = true;
    show();
  };
  model.shownState.watch((state) => {
    train.hidden = state === null || other(state) === null;
    train.disabled = state?.training ?? false;
    teaching.hidden = !(state?.teaches ?? false);
    show();
  });
  train.addEventListener("click", () => {
    void trainOther(model);
    dismiss();
  });
  explore.addEventListener("click", () => {
    void model.send({ command: "explore" });
    dismiss();
  });
  close.addEventListener("click", dismiss);
  return root;
}

async function trainOther(model: Model): Promise<void> {
  const state = model.shownState.value;
  const name = state && other(state);
  if (name === null) return;
  await model.send({ command: "system", name });
  await model.send({ command: "train" });
}

/** The next system of the list that can be trained. */
function other(state: State): string | null {
  const chosen = state.systems.findIndex(({ name }) => name === state.system);
  const next = [...state.systems.slice(chosen + 1), ...state.systems.slice(0, Math.max(0, chosen))];
  return next.find(({ learns }) => learns)?.name ?? null;
}
