// Creates elements of the page: element("p", { class: "note" }, ["text"]). Children that are strings
// become text, never markup. An attribute that is a function is a listener: { onclick: run }; true
// means an attribute without a value, false and null mean none. Styles are set through the
// object model, which a strict content security policy allows.

export type Child = Node | string | null;
export type Attribute = string | number | boolean | null | ((event: Event) => void);
export type Attributes = Record<string, Attribute>;

export function element<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  children: Child[] = [],
): HTMLElementTagNameMap[Tag] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) setAttribute(made, name, value);
  append(made, children);
  return made;
}

export function setAttribute(of: Element, name: string, value: Attribute): void {
  if (typeof value === "function") of.addEventListener(name.replace(/^on/, ""), value);
  else if (value === null || value === false) of.removeAttribute(name);
  else if (name === "style") (of as HTMLElement | SVGElement).style.cssText = String(value);
  else of.setAttribute(name, value === true ? "" : String(value));
}

export function append(to: Node, children: Child[]): void {
  for (const child of children) {
    if (child !== null) to.appendChild(typeof child === "string" ? document.createTextNode(child) : child);
  }
}

/** Replaces the content by `children`. */
export function fill(to: Element, children: Child[]): void {
  to.replaceChildren();
  append(to, children);
}

/** Sets the text of an element if it changes: a new text costs a layout. */
export function write(to: Element, text: string): void {
  if (to.textContent !== text) to.textContent = text;
}

/** A name that may be wrapped after each underscore. */
export function breakable(name: string): Child[] {
  return name
    .split(/(?<=[_/])/)
    .flatMap((part, i) => (i === 0 ? [part] : [document.createElement("wbr"), part]));
}

let lastNumber = 0;

/** An id that is unique on the page. */
export function uniqueId(stem: string): string {
  lastNumber += 1;
  return `${stem}-${lastNumber}`;
}
