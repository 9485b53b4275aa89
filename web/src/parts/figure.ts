// A figure: a title, a body, and buttons that save it as SVG and PNG and its data as CSV.
//
//   const shown = figure({ title: "U-matrix", file: "system-u-matrix", body: picture.element,
//                          picture: () => picture.svg, numbers: () => table });
//
// `picture`, `numbers` and `about` are called when a file is made, so they return the current
// content. A figure without a picture (a table) offers CSV and LaTeX. Its `file` is its id as well,
// so that a link can lead to it.

import { csv, type Table } from "./csv";
import { element, type Child } from "./dom";
import { latex } from "./latex";
import { pngOf, saveFile, svgText, type About } from "./save";

/** The present content of a figure, and its origin. */
export interface Shown {
  words: string; // such as "Train = test, by object, seed 2011"
  name: string; // such as "train_is_test-object-seed2011": a part of the names of files
  facts: [name: string, value: string][];
}

/** The table of a paper: few columns, in words, with a sentence for its caption. */
export interface Printed {
  table: () => Table;
  note: string;
}

export interface FigureOptions {
  title: string;
  note?: string; // a sentence below, also in saved files
  hint?: string; // how to use it on the page
  file: string; // what saved files are called, without the ending
  controls?: Child[];
  body: Node;
  picture?: () => SVGSVGElement | null;
  numbers: () => Table;
  printed?: Printed; // without it `numbers`
  about?: () => Shown;
  wide?: boolean;
}

const kOptions = new WeakMap<Element, FigureOptions>();

/** The options of a figure that figure() has made. */
export function optionsOf(made: Element): FigureOptions | undefined {
  return kOptions.get(made);
}

export function figure(options: FigureOptions): HTMLElement {
  const id = idOf(options.file);
  const link = element("a", { href: `#${id}`, class: "figure-link no-print", "aria-label": `Link to ${options.title}` }, [
    "#",
  ]);
  const title = element("p", { class: "figure-title" }, [options.title, " ", link]);
  const header = element("header", {}, [title, saveButtons(options)]);
  const controls = options.controls ? element("div", { class: "controls" }, options.controls) : null;
  const note = options.note ? element("figcaption", {}, [options.note]) : null;
  const kind = options.wide ? "figure wide" : "figure";
  const made = element("figure", { id, class: kind, "aria-label": options.title }, [
    header,
    controls,
    options.body,
    note,
    options.hint ? element("p", { class: "small muted no-print" }, [options.hint]) : null,
  ]);
  kOptions.set(made, options);
  return made;
}

/** The part of an address that leads to a figure or a section called `name`. */
export function idOf(name: string): string {
  return fileName(name).toLowerCase();
}

/** A table in a place that scrolls sideways where the table is too wide. */
export function scrolled(label: string, table: HTMLTableElement): HTMLElement {
  return element("div", { class: "table-wrap", tabindex: 0, role: "group", "aria-label": label }, [table]);
}

const kKinds = { svg: "SVG", png: "PNG", tex: "LaTeX", csv: "CSV" } as const;

export type Ending = keyof typeof kKinds;

/** The endings of the files in which a figure can be saved. */
export function endingsOf({ picture, printed }: FigureOptions): Ending[] {
  if (!picture) return ["tex", "csv"];
  return printed ? ["svg", "png", "tex", "csv"] : ["svg", "png", "csv"];
}

/** The content of the file; null without a picture at present. */
export async function fileOf(options: FigureOptions, ending: Ending): Promise<Blob | null> {
  const { picture, numbers } = options;
  if (ending === "csv") return textBlob(csv(numbers()));
  if (ending === "tex") return textBlob(latexOf(options));
  const shown = picture?.() ?? null;
  if (shown === null) return null;
  const svg = svgText(shown, aboutOf(options));
  return ending === "svg" ? new Blob([svg], { type: "image/svg+xml" }) : pngOf(svg, aboutOf(options));
}

function latexOf(options: FigureOptions): string {
  const { table, note } = options.printed ?? { table: options.numbers, note: options.note ?? "" };
  return latex(table(), captionOf({ ...options, note }), idOf(options.file));
}

function textBlob(words: string): Blob {
  return new Blob([words], { type: "text/plain" });
}

function saveButtons(options: FigureOptions): HTMLElement {
  const buttons = endingsOf(options).map((ending) => saver(options, ending));
  return element("div", { class: "save no-print", role: "group", "aria-label": `Save ${options.title}` }, buttons);
}

function saver(options: FigureOptions, ending: Ending): HTMLElement {
  const kind = kKinds[ending];
  const label = `${kind}: save ${options.title}`;
  const button = element(
    "button",
    { type: "button", class: "quiet", "aria-label": label, title: `Save as ${kind}` },
    [kind],
  );
  button.addEventListener("click", () => {
    save(options, ending).catch(() => {
      button.textContent = `${kind} failed`;
    });
  });
  return button;
}

async function save(options: FigureOptions, ending: Ending): Promise<void> {
  const blob = await fileOf(options, ending);
  if (blob !== null) saveFile(nameOf(options, ending), blob);
}

function nameOf({ file, about }: FigureOptions, ending: string): string {
  const name = about?.().name ?? "";
  return `${fileName(name === "" ? file : `${file}-${name}`)}.${ending}`;
}

function captionOf({ title, note, about }: FigureOptions): string {
  return [title, about?.().words ?? "", note ?? ""].filter((part) => part !== "").join(". ");
}

function aboutOf({ title, note, about }: FigureOptions): About {
  const shown = about?.();
  const words = shown?.words ?? "";
  const caption = [words === "" ? "" : `${words}.`, note ?? ""].filter((part) => part !== "").join(" ");
  return { title, caption, facts: shown?.facts ?? [] };
}

/** A name that is valid on every file system. */
export function fileName(words: string): string {
  const name = words.replaceAll(/[^\p{L}\p{N}._-]+/gu, "-").replaceAll(/^[-.]+|[-.]+$/g, "");
  return [...name].slice(0, 120).join("") || "figure";
}
