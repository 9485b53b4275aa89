// The files of a report's figures by name, for `somato figure` (program/report/figure_page.cc), which
// opens the page without a window and calls these functions.

import { append, element } from "../../parts/dom";
import { endingsOf, fileOf, optionsOf, type Ending, type FigureOptions } from "../../parts/figure";
import { kSaving, printablePage } from "../../parts/save";
import { fitPaper } from "../page/fitting";
import { drawAllInside } from "../page/lazy";
import { refused, restored } from "../page/selection_state";
import type { ReportData } from "../page/unpacked";
import { asLatex, asPlain } from "./cited_text";
import { figureName, unique } from "./figure_names";
import { sourcesOf, type Source } from "./figure_sources";
import { methodsOf } from "./methods";
import { bibtex } from "./references";

interface Listed {
  name: string;
  title: string;
  endings: string[];
}

interface Wanted {
  name: string;
  ending: string;
  caption: boolean;
  selection: string; // as in the address of the page
}

/** The file: a text, bytes in base64, or a page in millimetres that is printed as PDF. */
type Made = { text: string } | { base64: string } | { page: string; width: number; height: number } | { problem: string };

interface Found {
  source: Source;
  options: FigureOptions;
  body: Element;
}

export class FigureFiles {
  private readonly figures: [name: string, found: Found][];
  private readonly texts: Record<string, { title: string; files: Record<string, () => string> }>;

  /** Draws all figures for a width in mm. */
  constructor(place: HTMLElement, data: ReportData, width: number) {
    kSaving.width = width;
    fitPaper(width - kMargins);
    const found = sourcesOf(data).flatMap((source) => foundIn(source, place));
    const names = unique(found.map(({ source, options, body }) => figureName(body.id || options.file, source.system, source.prefix)));
    this.figures = found.map((one, i) => [names[i] ?? "", one]);
    const methods = () => methodsOf(data);
    this.texts = {
      methods: { title: "Methods", files: { tex: () => asLatex(methods()), txt: () => asPlain(methods()) } },
      references: { title: "References", files: { bib: () => bibtex(data) } },
    };
  }

  list(): Listed[] {
    const figures = this.figures.map(([name, { options }]) => ({ name, title: options.title, endings: withPdf(options) }));
    const texts = Object.entries(this.texts).map(([name, { title, files }]) => ({ name, title, endings: Object.keys(files) }));
    return [...figures, ...texts];
  }

  async file(wanted: Wanted): Promise<Made> {
    const text = this.texts[wanted.name]?.files[wanted.ending];
    if (text) return wanted.selection === "" ? { text: text() } : { problem: kNoSelection };
    const found = this.figures.find(([name]) => name === wanted.name)?.[1];
    if (!found) return { problem: "there is no such figure" };
    const problem = select(found.source, wanted.selection);
    if (problem !== "") return { problem };
    kSaving.hasCaption = wanted.caption;
    return made(found, wanted.ending);
  }
}

const kMargins = (2 * 8 * 25.4) / 96; // mm, around a saved picture

const kNoSelection = "nothing can be selected for it";

/** The figures of a source, drawn. */
function foundIn(source: Source, place: HTMLElement): Found[] {
  const part = element("div");
  place.append(part);
  append(part, source.make());
  drawAllInside(part);
  return [...part.querySelectorAll("figure")].flatMap((body) => {
    const options = optionsOf(body);
    return options ? [{ source, options, body }] : [];
  });
}

function withPdf(options: FigureOptions): string[] {
  return endingsOf(options).flatMap((ending) => (ending === "svg" ? ["svg", "pdf"] : [ending]));
}

/** Selects as `words` state; the error as a sentence, or "". */
function select({ selection }: Source, words: string): string {
  if (words === "") return "";
  if (!selection) return kNoSelection;
  const state = new URLSearchParams(words);
  restored(selection, state);
  const wrong = refused(selection, state);
  return wrong.length === 0 ? "" : `the system has no such ${wrong.join(", ")}`;
}

async function made({ options, body }: Found, ending: string): Promise<Made> {
  const blob = await fileOf(options, ending === "pdf" ? "svg" : (ending as Ending));
  if (blob === null) return { problem: `there is no picture: ${body.querySelector(".message")?.textContent ?? ""}` };
  if (ending === "pdf") return printablePage(await blob.text(), options.title);
  return ending === "png" ? { base64: await base64Of(blob) } : { text: await blob.text() };
}

function base64Of(blob: Blob): Promise<string> {
  return new Promise((resolve, reject) => {
    const reader = new FileReader();
    reader.onload = () => resolve(String(reader.result).replace(/^.*,/s, ""));
    reader.onerror = () => reject(new Error("the picture cannot be read"));
    reader.readAsDataURL(blob);
  });
}
