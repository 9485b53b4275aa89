// A collapsible part of the page with a heading. Collapsed panels are not drawn.

import { append, type Child, element, uniqueId } from "../../parts/dom";
import { icon } from "./icons";
import { Observable } from "../session/observable";

export class Panel {
  readonly root: HTMLElement;
  readonly body: HTMLElement;
  readonly isOpen = new Observable(true);
  private readonly tools = element("div", { class: "panel-tools" });
  private readonly button: HTMLButtonElement;
  private readonly title: HTMLElement;

  constructor(
    readonly number: number,
    readonly name: string,
    title: string,
  ) {
    const id = uniqueId("panel");
    this.body = element("div", { class: "panel-body", id });
    this.title = element("span", { class: "panel-title" }, [title]);
    this.button = this.makeButton(id);
    const head = element("header", { class: "panel-head" }, [element("h2", {}, [this.button]), this.tools]);
    const attributes = { class: `panel panel-${name}`, "aria-label": title };
    this.root = element("section", attributes, [head, this.body]);
  }

  add(...children: Child[]): void {
    append(this.body, children);
  }

  addTools(...children: Child[]): void {
    append(this.tools, children);
  }

  rename(title: string): void {
    if (this.title.textContent === title) return;
    this.title.textContent = title;
    this.root.setAttribute("aria-label", title);
  }

  /** Runs `draw` immediately if open, and whenever the panel is opened. */
  whenOpen(draw: () => void): void {
    this.isOpen.watch((open) => open && draw());
  }

  toggle(): void {
    const open = !this.isOpen.value;
    this.root.classList.toggle("folded", !open);
    this.body.hidden = !open;
    this.button.setAttribute("aria-expanded", String(open));
    this.isOpen.set(open);
  }

  /** Moves the focus to the panel, or collapses it if it already has the focus. */
  visit(): void {
    if (document.activeElement === this.button || !this.isOpen.value) this.toggle();
    this.button.focus();
  }

  private makeButton(controls: string): HTMLButtonElement {
    const attributes = {
      type: "button",
      class: "panel-fold",
      "aria-expanded": "true",
      "aria-controls": controls,
    };
    const number = element("span", { class: "panel-number", "aria-hidden": "true" }, [String(this.number)]);
    const button = element("button", attributes, [number, this.title, icon("fold")]);
    button.addEventListener("click", () => this.toggle());
    return button;
  }
}
