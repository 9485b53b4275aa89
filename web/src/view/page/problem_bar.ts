// The last error, until it is closed.

import { element } from "../../parts/dom";
import type { Model } from "../session/model";

export function problemBar(model: Model): HTMLElement {
  const words = element("p");
  const close = element("button", { type: "button", onclick: () => void model.dismiss() }, ["Close"]);
  const bar = element("div", { class: "problem-bar", hidden: true }, [words, close]);
  model.problem.watch((problem) => {
    bar.hidden = problem === null;
    words.textContent = problem === null ? "" : problem.charAt(0).toUpperCase() + problem.slice(1);
  });
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape" && model.problem.value !== null) void model.dismiss();
  });
  return element("div", { role: "alert", class: "problem-place" }, [bar]);
}
