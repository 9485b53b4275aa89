// Labelled controls.
//
//   choice("seed", names, 0, (index) => draw(index))   a list; arrow keys go through it
//   segments("label", names, 0, (index) => draw(index)) few options side by side

import { element, uniqueId } from "./dom";

export interface Choice {
  element: HTMLElement;
  set(index: number): void; // without telling
  setOptions(names: readonly string[], index: number): void;
}

export function choice(
  name: string,
  options: readonly string[],
  index: number,
  onChange: (index: number) => void,
): Choice {
  const id = uniqueId("choice");
  const list = element("select", { id });
  const setOptions = (names: readonly string[], at: number) => {
    list.replaceChildren(...names.map((one, i) => element("option", { value: i }, [one])));
    list.selectedIndex = at;
    list.disabled = names.length < 2;
  };
  setOptions(options, index);
  list.addEventListener("change", () => onChange(list.selectedIndex));
  const whole = element("span", { class: "control" }, [element("label", { for: id }, [name]), list]);
  const set = (at: number) => {
    list.selectedIndex = at;
  };
  return { element: whole, set, setOptions };
}

export function segments(
  name: string,
  options: readonly string[],
  index: number,
  onChange: (index: number) => void,
): HTMLElement {
  const group = uniqueId("segments");
  const labels = options.map((option, i) => {
    const input = element("input", { type: "radio", name: group, value: i, onchange: () => onChange(i) });
    input.checked = i === index;
    return element("label", {}, [input, option]);
  });
  const all = element("span", { class: "segments", role: "radiogroup", "aria-label": name }, labels);
  return element("span", { class: "control" }, [element("span", { class: "name" }, [name]), all]);
}
