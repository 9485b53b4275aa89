// Icons for buttons, 16 x 16. They are hidden from screen readers, because the button has a label.

import { shape } from "../../parts/svg";

const kPaths = {
  play: "M4 2.5v11l9-5.5z",
  pause: "M4 2.5h3v11H4zM9 2.5h3v11H9z",
  back: "M12.5 2.5v11L5.5 8zM3 2.5h2v11H3z",
  forward: "M3.5 2.5v11L10.5 8zM11 2.5h2v11h-2z",
  previous: "M10.8 2.6 5.4 8l5.4 5.4 1.2-1.2L7.8 8 12 3.8z",
  next: "M5.2 2.6 10.6 8l-5.4 5.4L4 12.2 8.2 8 4 3.8z",
  fold: "M3.3 5.5 8 10.2l4.7-4.7 1 1L8 12.2 2.3 6.5z",
};

export function icon(name: keyof typeof kPaths): SVGSVGElement {
  const attributes = { viewBox: "0 0 16 16", width: 16, height: 16, "aria-hidden": "true", class: "icon" };
  return shape("svg", attributes, [shape("path", { d: kPaths[name], fill: "currentColor" })]);
}
