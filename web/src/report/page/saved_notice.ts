// A line that states which map a figure of the trained system shows, because only the system of one
// seed was saved.

import { element } from "../../parts/dom";
import { shownOfSaved } from "./origin";
import type { Selection } from "./selection";

/** With a button that selects the winners of the same map where others are selected. */
export function savedNotice(selection: Selection): HTMLElement {
  const { words } = shownOfSaved(selection.system);
  if (selection.isOfSavedMap) return element("p", { class: "small what" }, [words]);
  const notice = element("p", { class: "small what other-map" }, [
    `${words}: another map than that of the selected winners. `,
  ]);
  const index = selection.savedRunIndex;
  if (index < 0) return notice;
  const select = () => {
    selection.setRun(index);
    if (selection.folds > 0) selection.setFold(null);
  };
  const button = element("button", { type: "button", class: "quiet", onclick: select }, [
    selection.isOfSavedRun ? "Select it" : "Select its seed",
  ]);
  notice.append(button);
  return notice;
}
