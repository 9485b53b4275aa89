// Light or dark theme: that of the system until the user selects one. The selection is stored if
// the browser allows it.
//
//   place.append(themeButton());

import { element } from "./dom";
import { keep, kept } from "./kept";

const kKey = "somato-theme";

type Theme = "light" | "dark";

export function themeButton(): HTMLButtonElement {
  const button = element("button", { type: "button", class: "theme-button no-print" });
  const show = (theme: Theme) => {
    const other = theme === "dark" ? "light" : "dark";
    button.textContent = other === "dark" ? "Dark" : "Light";
    button.setAttribute("aria-label", `Use ${other} colours`);
  };
  apply(keptTheme());
  show(current());
  button.addEventListener("click", () => {
    const next: Theme = current() === "dark" ? "light" : "dark";
    apply(next);
    keep(kKey, next);
    show(next);
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => show(current()));
  return button;
}

export function current(): Theme {
  const chosen = document.documentElement.dataset["theme"];
  if (chosen === "light" || chosen === "dark") return chosen;
  return matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

function apply(theme: Theme | null): void {
  if (theme !== null) document.documentElement.dataset["theme"] = theme;
}

function keptTheme(): Theme | null {
  const value = kept(kKey);
  return value === "light" || value === "dark" ? value : null;
}
