// The keys, and the state of the page for developers, in a dialog.

import { element } from "../../parts/dom";
import { kKeys } from "./keys";

export function helpDialog(status: HTMLElement): { root: HTMLDialogElement; show: () => void } {
  const rows = kKeys.map(([keys, does]) =>
    element("tr", {}, [
      element("th", { scope: "row" }, [element("kbd", {}, [keys])]),
      element("td", {}, [does]),
    ]),
  );
  const title = element("h2", { id: "help-title" }, ["Keys"]);
  const close = element("button", { type: "button", class: "primary", onclick: () => root.close() }, [
    "Close",
  ]);
  const table = element("table", {}, [element("tbody", {}, rows)]);
  const root = element("dialog", { class: "help", "aria-labelledby": "help-title" }, [
    title,
    table,
    element("h2", {}, ["State of the page"]),
    status,
    close,
  ]);
  return { root, show: () => root.open || root.showModal() };
}
