// The proposals of the program for what to try next, with the commands for it.

import { element, type Child } from "../../parts/dom";
import type { SystemReport } from "./unpacked";

export function nextSteps({ summary }: SystemReport): Child {
  const steps = summary?.next ?? [];
  if (steps.length === 0) return null;
  const items = steps.map(({ text, commands, page }) =>
    element("li", {}, [
      element("p", {}, [text, ...(page === "" ? [] : [" (", element("code", {}, [page]), ")"])]),
      commands.length === 0 ? null : element("pre", { tabindex: 0 }, [element("code", {}, [commands.join("\n")])]),
    ]),
  );
  return element("div", { class: "next-steps", role: "group", "aria-label": "What to try next" }, [
    element("h2", { class: "gallery-title" }, ["What to try next"]),
    element("ol", {}, items),
  ]);
}
