// The keys, in a dialog.

import { element } from "../parts/dom";
import { kKeys } from "./keys";

export function helpDialog(): { root: HTMLDialogElement; show: () => void } {
  const rows = kKeys.map(([keys, does]) =>
    element("tr", {}, [element("th", { scope: "row" }, [element("kbd", {}, [keys])]), element("td", {}, [does])]),
  );
  const title = element("h2", { id: "help-title" }, ["Keys"]);
  const close = element("button", { type: "submit", class: "primary" }, ["Close"]);
  const form = element("form", { method: "dialog" }, [title, element("table", {}, [element("tbody", {}, rows)]), close]);
  const root = element("dialog", { class: "help", "aria-labelledby": "help-title" }, [form]);
  return { root, show: () => root.open || root.showModal() };
}
