// A figure: a title, a body, and buttons that save it as SVG and PNG and its data as CSV.
//
//   const shown = figure({ title: "U-matrix", file: "system-u-matrix", body: picture.element,
//                          picture: () => picture.svg, numbers: () => table });
//
// `picture` and `numbers` are called when a button is pressed, so they return the current content.
// A figure without a picture (a table) offers only CSV.

import { csv, type Table } from "./csv";
import { element, type Child } from "./dom";
import { pngOf, saveFile, svgText } from "./save";

export interface FigureOptions {
  title: string;
  note?: string; // a sentence below
  file: string; // what saved files are called, without the ending
  controls?: Child[];
  body: Node;
  picture?: () => SVGSVGElement | null;
  numbers: () => Table;
  wide?: boolean;
}

const kPngScale = 3;

export function figure(options: FigureOptions): HTMLElement {
  const title = element("p", { class: "figure-title" }, [options.title]);
  const header = element("header", {}, [title, saveButtons(options)]);
  const controls = options.controls ? element("div", { class: "controls" }, options.controls) : null;
  const note = options.note ? element("figcaption", {}, [options.note]) : null;
  const kind = options.wide ? "figure wide" : "figure";
  return element("figure", { class: kind, "aria-label": options.title }, [
    header,
    controls,
    options.body,
    note,
  ]);
}

/** A table in a place that scrolls sideways where the table is too wide. */
export function scrolled(label: string, table: HTMLTableElement): HTMLElement {
  return element("div", { class: "table-wrap", tabindex: 0, role: "group", "aria-label": label }, [table]);
}

function saveButtons(options: FigureOptions): HTMLElement {
  const { picture, numbers, title } = options;
  const name = fileName(options.file);
  const buttons: Child[] = picture
    ? [
        saver("SVG", title, () => saveSvg(name, picture())),
        saver("PNG", title, () => savePng(name, picture())),
      ]
    : [];
  buttons.push(saver("CSV", title, () => saveCsv(name, numbers())));
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

async function saveSvg(name: string, picture: SVGSVGElement | null): Promise<void> {
  if (picture === null) return;
  saveFile(`${name}.svg`, new Blob([svgText(picture)], { type: "image/svg+xml" }));
}

async function savePng(name: string, picture: SVGSVGElement | null): Promise<void> {
  if (picture === null) return;
  saveFile(`${name}.png`, await pngOf(svgText(picture), kPngScale));
}

async function saveCsv(name: string, table: Table): Promise<void> {
  saveFile(`${name}.csv`, new Blob([csv(table)], { type: "text/csv" }));
}

/** A name that is valid on every file system. */
export function fileName(words: string): string {
  const name = words.replaceAll(/[^\p{L}\p{N}._-]+/gu, "-").replaceAll(/^[-.]+|[-.]+$/g, "");
  return [...name].slice(0, 80).join("") || "figure";
}
