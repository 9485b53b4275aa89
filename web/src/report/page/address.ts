// The address of the page leads to a section or a figure, and contains what is selected there:
// #tensor_chain?protocol=1&label=shape&seed=3. A link to the page therefore shows the same.

export interface Address {
  id: string;
  state: URLSearchParams;
}

export function addressOf(id: string, state: Record<string, string> = {}): string {
  const words = new URLSearchParams(state).toString();
  return `#${id}${words === "" ? "" : `?${words}`}`;
}

export function parsedAddress(hash: string): Address {
  const [id = "", state = ""] = hash.replace(/^#/, "").split("?");
  return { id: decoded(id), state: new URLSearchParams(state) };
}

function decoded(id: string): string {
  try {
    return decodeURIComponent(id);
  } catch {
    return id;
  }
}

/** A part of the page with a selection. */
export interface Stateful {
  state: () => Record<string, string>;
  restore: (state: URLSearchParams) => void;
}

const sections = new Map<string, Stateful>();

export function registerSection(id: string, section: Stateful): void {
  sections.set(id, section);
}

/** Puts the selection of a section into the address, without a new entry in the history. */
export function showInAddress(id: string): void {
  replaceAddress(addressOf(id, sections.get(id)?.state() ?? {}));
}

/** The same for a figure of a section. */
export function showFigureInAddress(figure: string): void {
  const section = sections.get(sectionOf(figure) ?? "");
  replaceAddress(addressOf(figure, section?.state() ?? {}));
}

function replaceAddress(address: string): void {
  try {
    history.replaceState(history.state, "", address);
  } catch {
    // A page inside another one, such as in a notebook, may have no address of its own.
  }
}

/** The section of a figure, whose id begins that of each of its figures. */
function sectionOf(id: string): string | null {
  const names = [...sections.keys()].filter((one) => id === one || id.startsWith(`${one}-`));
  return names.sort((one, other) => other.length - one.length)[0] ?? null;
}

/** Selects what an address states, if it states anything; the section that it leads to. */
export function restoreSection({ id, state }: Address): HTMLElement | null {
  const name = sectionOf(id);
  if (name === null) return document.getElementById(id);
  if (state.size > 0) sections.get(name)?.restore(state);
  return document.getElementById(name);
}
