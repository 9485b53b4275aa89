// States by how much the page is behind the program, while it is connected and the delay can be noticed:
// on a slow line, or where drawing takes long.

import { element } from "../../parts/dom";
import { kNoticed } from "../session/freshness";
import type { Model } from "../session/model";
import { isPicture } from "./picture";

const kLook = 250; // ms
const kTitle = "The line to the program or this browser is slow: the page shows what was felt so long ago";

export function ageNote(model: Model): HTMLElement {
  const note = element("span", { class: "age", title: kTitle, hidden: true });
  const show = () => {
    const age = model.freshness.age(performance.now());
    note.hidden = model.shownLink.value.kind !== "open" || age <= kNoticed;
    if (!note.hidden) note.textContent = `${Math.round(age / 1000)} s behind`;
  };
  if (!isPicture()) window.setInterval(show, kLook); // a picture waits for its moment
  model.shownLink.watch(show);
  return note;
}
