// A part of a system's section, which can be closed.

import { element, type Child } from "../../parts/dom";
import { lazy } from "./lazy";

export interface Part {
  title: string;
  height: number; // about how tall it is, in pixels
  make: () => Child[];
}

export function block({ title, height, make }: Part, isOpen: boolean): HTMLDetailsElement {
  const summary = element("summary", {}, [element("h3", {}, [title])]);
  return element("details", { class: "block", open: isOpen }, [summary, lazy(height, make)]);
}
