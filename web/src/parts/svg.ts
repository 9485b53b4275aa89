// Creates elements of a picture: shape("circle", { r: 3, class: "dot" }). svg(width, height) is a
// picture that shrinks with its element; its texts are styled by the classes of style.css.

import { append, setAttribute, type Attributes, type Child } from "./dom";

const kNamespace = "http://www.w3.org/2000/svg";

export function shape<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  children: Child[] = [],
): SVGElementTagNameMap[Tag] {
  const made = document.createElementNS(kNamespace, tag);
  for (const [name, value] of Object.entries(attributes)) setAttribute(made, name, value);
  append(made, children);
  return made;
}

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export function svg(width: number, height: number, label: string, children: Child[] = []): SVGSVGElement {
  const box = `0 0 ${rounded(width)} ${rounded(height)}`;
  const attributes = { viewBox: box, width: rounded(width), height: rounded(height) };
  return shape("svg", { ...attributes, role: "img", "aria-label": label, class: "picture" }, children);
}

export function text(x: number, y: number, words: string, attributes: Attributes = {}): SVGTextElement {
  return shape("text", { x: rounded(x), y: rounded(y), ...attributes }, [words]);
}

/** Two decimals, to keep pictures small. */
export function rounded(value: number): number {
  return Math.round(value * 100) / 100;
}

/** The approximate width of `words` in pixels. */
export function textWidth(words: string, size: number): number {
  return [...words].length * size * 0.56;
}

/** `words`, truncated to `width`. */
export function shortened(words: string, width: number, size: number): string {
  const letters = [...words];
  const room = Math.max(1, Math.floor(width / (size * 0.56)));
  return letters.length <= room ? words : `${letters.slice(0, room - 1).join("")}…`;
}
