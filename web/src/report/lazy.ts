// Draws parts of the page when they come near to what is seen, or when the page is printed.

import { element, type Child } from "./../parts/dom";

const waiting = new Map<Element, () => void>();

const watcher =
  typeof IntersectionObserver === "undefined"
    ? null
    : new IntersectionObserver(
        (entries) => entries.filter((entry) => entry.isIntersecting).forEach((entry) => drawNow(entry.target)),
        { rootMargin: "600px" },
      );

/** A place that is filled by `make` when it is needed. What cannot be drawn says so. */
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

/** What `make` makes, or a sentence that says why not. */
export function tried(make: () => Child[]): (Node | string)[] {
  try {
    return make().filter((child) => child !== null);
  } catch (problem) {
    const words = `This part cannot be drawn from what the page carries (${String(problem)}).`;
    return [element("p", { class: "message problem" }, [words])];
  }
}

export function drawNow(place: Element): void {
  const draw = waiting.get(place);
  waiting.delete(place);
  watcher?.unobserve(place);
  draw?.();
}

/** Draws what waits inside `place`, such as before it is scrolled to. */
export function drawInside(place: Element): void {
  // What is drawn may bring parts that wait in their turn.
  for (const one of waiting.keys()) if (place.contains(one)) drawNow(one);
}

export function drawAllForPrint(): void {
  const drawAll = () => {
    // What is folded away is not printed.
    for (const one of waiting.keys()) if (!one.closest("details:not([open])")) drawNow(one);
  };
  addEventListener("beforeprint", drawAll);
  matchMedia("print").addEventListener("change", (event) => (event.matches ? drawAll() : undefined));
}
