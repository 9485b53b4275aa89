// A figure: a title, a body, and buttons that save it as SVG and PNG and its data as CSV.
//
//   const shown = figure({ title: "U-matrix", file: "system-u-matrix", body: picture.element,
//                          picture: () => picture.svg, numbers: () => table });
//
// `picture`, `numbers` and `about` are called when a button is pressed, so they return the current
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

export interface FigureOptions {
  title: string;
  note?: string; // a sentence below, also in saved files
  hint?: string; // how to use it on the page
  file: string; // what saved files are called, without the ending
  controls?: Child[];
  body: Node;
  picture?: () => SVGSVGElement | null;
  numbers: () => Table;
  about?: () => Shown;
  wide?: boolean;
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
  return element("figure", { id, class: kind, "aria-label": options.title }, [
    header,
    controls,
    options.body,
    note,
    options.hint ? element("p", { class: "small muted no-print" }, [options.hint]) : null,
  ]);
}

/** The part of an address that leads to a figure or a section called `name`. */
export function idOf(name: string): string {
  return fileName(name).toLowerCase();
}

/** A table in a place that scrolls sideways where the table is too wide. */
export function scrolled(label: string, table: HTMLTableElement): HTMLElement {
  return element("div", { class: "table-wrap", tabindex: 0, role: "group", "aria-label": label }, [table]);
}

function saveButtons(options: FigureOptions): HTMLElement {
  const { picture, numbers, title } = options;
  const buttons = picture
    ? [
        saver("SVG", title, () => saveSvg(options, picture())),
        saver("PNG", title, () => savePng(options, picture())),
      ]
    : [saver("LaTeX", title, () => saveText(options, "tex", latex(numbers(), captionOf(options))))];
  buttons.push(saver("CSV", title, () => saveText(options, "csv", csv(numbers()))));
  return element("div", { class: "save no-print", role: "group", "aria-label": `Save ${title}` }, buttons);
}

function saver(kind: string, title: string, save: () => Promise<void>): HTMLElement {
  const label = `${kind}: save ${title}`;
  const button = element(
    "button",
    { type: "button", class: "quiet", "aria-label": label, title: `Save as ${kind}` },
    [kind],
  );
  button.addEventListener("click", () => {
    save().catch(() => {
      button.textContent = `${kind} failed`;
    });
  });
  return button;
}

async function saveSvg(options: FigureOptions, picture: SVGSVGElement | null): Promise<void> {
  if (picture === null) return;
  saveFile(nameOf(options, "svg"), new Blob([svgText(picture, aboutOf(options))], { type: "image/svg+xml" }));
}

async function savePng(options: FigureOptions, picture: SVGSVGElement | null): Promise<void> {
  if (picture === null) return;
  const about = aboutOf(options);
  saveFile(nameOf(options, "png"), await pngOf(svgText(picture, about), about));
}

async function saveText(options: FigureOptions, ending: string, words: string): Promise<void> {
  saveFile(nameOf(options, ending), new Blob([words], { type: "text/plain" }));
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
