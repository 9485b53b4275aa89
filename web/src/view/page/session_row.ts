// The row of the session: the name of what is touched, pictures, and files. On a narrow screen pictures
// and files are behind a button.

import { element, uniqueId } from "../../parts/dom";
import { FilmButtons } from "./film";
import type { Model } from "../session/model";
import type { Naming } from "../naming/naming";
import { sessionFiles } from "./session_files";

export function sessionRow(model: Model, naming: Naming): HTMLElement {
  const files = element("div", { class: "session-all", id: uniqueId("session") }, [
    new FilmButtons(model).root,
    sessionFiles(model),
  ]);
  const more = element("button", {
    type: "button",
    class: "session-more",
    "aria-expanded": "false",
    "aria-controls": files.id,
  }, ["Save …"]);
  more.addEventListener("click", () => {
    const isOpen = files.classList.toggle("open");
    more.setAttribute("aria-expanded", String(isOpen));
  });
  return element("div", { class: "session" }, [naming.root, more, files]);
}
