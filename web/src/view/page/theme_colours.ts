// The colours of style.css for canvases, to which style sheets do not apply.

const probe = document.createElement("span");
probe.hidden = true;

/** themeColour("ink"): as "rgb(...)", of the current theme. */
export function themeColour(name: string): string {
  if (!probe.isConnected) document.body.append(probe);
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}

export function watchTheme(changed: () => void): void {
  new MutationObserver(changed).observe(document.documentElement, { attributeFilter: ["data-theme"] });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", changed);
}
