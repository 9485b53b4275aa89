// A text with citations, written plainly or as LaTeX.

import { escaped } from "../../parts/latex";
import type { Reference } from "./reference_list";
import { listedReference } from "./references";

/** Words, and what is cited after them. */
export type Sentence = (string | Reference[])[];

/** Paragraphs of sentences. */
export type Text = Sentence[][];

/** With the references as a list below the text. */
export function asPlain(text: Text): string {
  const cited = [...new Set(text.flat(2).flatMap((piece) => (typeof piece === "string" ? [] : piece)))];
  const paragraphs = written(text, " ", (words) => words, (cited) => ` (${cited.map(({ short }) => short).join("; ")})`);
  return `${[...paragraphs, ["References", ...cited.map(listedReference)].join("\n")].join("\n\n")}\n`;
}

/** With the keys of the report's BibTeX. */
export function asLatex(text: Text): string {
  const paragraphs = written(text, "\n", escaped, (cited) => `~\\cite{${cited.map(({ key }) => key).join(",")}}`);
  return `${paragraphs.join("\n\n")}\n`;
}

function written(
  text: Text,
  between: string,
  words: (piece: string) => string,
  cite: (cited: Reference[]) => string,
): string[] {
  const pieceOf = (piece: string | Reference[]) => {
    if (typeof piece === "string") return words(piece);
    return piece.length === 0 ? "" : cite(piece);
  };
  return text.map((sentences) => sentences.map((sentence) => sentence.map(pieceOf).join("")).join(between));
}
