// Draws parts of the page when they approach the visible area, or when the page is printed.

import { element, type Child } from "../../parts/dom";

const waiting = new Map<Element, () => void>();

const watcher =
  typeof IntersectionObserver === "undefined"
    ? null
    : new IntersectionObserver(
        (entries) =>
          entries.filter((entry) => entry.isIntersecting).forEach((entry) => drawNow(entry.target)),
        { rootMargin: "600px" },
      );

/** An element that is filled by `make` when needed, or by an error message. */
export function lazy(height: number, make: () => Child[]): HTMLElement {
  const place = element("div", { class: "lazy", style: `min-height:${height}px` });
  waiting.set(place, () => {
    place.style.minHeight = "";
    place.append(...tried(make));
  });
  if (watcher) watcher.observe(place);
  else drawNow(place);
  return place;
}

/** The result of `make`, or an error message. */
export function tried(make: () => Child[]): (Node | string)[] {
  try {
    return make().filter((child) => child !== null);
  } catch (problem) {
    const words = `This part cannot be drawn from the data of the page (${String(problem)}).`;
    return [element("p", { class: "message problem" }, [words])];
  }
}

export function drawNow(place: Element): void {
  const draw = waiting.get(place);
  waiting.delete(place);
  watcher?.unobserve(place);
  draw?.();
}

/** Draws the pending parts inside `place` that are not collapsed, for example before scrolling to it. */
export function drawInside(place: Element): void {
  // Drawn parts may contain further pending parts.
  for (const one of waiting.keys()) if (place.contains(one) && !isCollapsed(one)) drawNow(one);
}

/** The same with collapsed parts. */
export function drawAllInside(place: Element): void {
  for (const one of waiting.keys()) if (place.contains(one)) drawNow(one);
}

function isCollapsed(one: Element): boolean {
  return one.closest("details:not([open])") !== null;
}

export function drawAllForPrint(): void {
  const drawAll = () => {
    // Collapsed parts are not printed.
    for (const one of waiting.keys()) if (!isCollapsed(one)) drawNow(one);
  };
  addEventListener("beforeprint", drawAll);
  matchMedia("print").addEventListener("change", (event) => (event.matches ? drawAll() : undefined));
}
