// Tables as LaTeX, without any package; every character stands for itself.

import type { Cell, Table } from "./csv";
import { significant } from "./numbers";

const kSpecial: Record<string, string> = {
  "\n": " ",
  "\\": "\\textbackslash{}",
  "~": "\\textasciitilde{}",
  "^": "\\textasciicircum{}",
  "−": "$-$",
  "±": "$\\pm$",
  "×": "$\\times$",
  "≥": "$\\geq$",
  "≤": "$\\leq$",
  "<": "$<$",
  ">": "$>$",
  "|": "$|$",
  "–": "--",
};

const kFigures = 4; // significant ones

/** A floating table, to which \ref{tab:NAME} refers. */
export function latex(table: Table, caption: string, name: string): string {
  const columns = table.columns.map((_, i) => alignment(table, i)).join("");
  const line = (cells: readonly Cell[]) => `    ${cells.map(cellText).join(" & ")} \\\\`;
  return [
    "\\begin{table}",
    `  \\caption{${escaped(caption)}}`,
    `  \\label{tab:${labelOf(name)}}`,
    "  \\centering",
    `  \\begin{tabular}{${columns}}`,
    "    \\hline",
    line(table.columns),
    "    \\hline",
    ...table.rows.map(line),
    "    \\hline",
    "  \\end{tabular}",
    "\\end{table}",
    "",
  ].join("\n");
}

/** Only characters that a label may have. */
function labelOf(name: string): string {
  return name.replaceAll(/[^A-Za-z0-9]+/g, "-").replaceAll(/^-|-$/g, "");
}

const kLong = 40; // characters of a cell that is broken into lines
const kNumber = /^[\d.,−±×<>% –-]+$/;

/** Numbers stand on the right; columns of sentences share half of the text's width. */
function alignment({ columns, rows }: Table, column: number): string {
  const texts = (at: number) => rows.map((row) => row[at]).filter((cell) => typeof cell === "string");
  const isLong = (at: number) => texts(at).some((words) => words.length > kLong);
  if (rows.length > 0 && texts(column).every((words) => kNumber.test(words))) return "r";
  if (!isLong(column)) return "l";
  const share = 0.5 / columns.filter((_, at) => isLong(at)).length;
  return `p{${Number(share.toFixed(2))}\\textwidth}`;
}

function cellText(cell: Cell): string {
  if (cell === null || (typeof cell === "number" && !Number.isFinite(cell))) return "--";
  if (typeof cell === "number") return escaped(significant(cell, Number.isInteger(cell) ? 15 : kFigures));
  // After the end of a row, these would be arguments of its command.
  return /^[[*]/.test(cell) ? `{}${escaped(cell)}` : escaped(cell);
}

/** Words of which no character is a command of LaTeX. */
export function escaped(words: string): string {
  return words.replaceAll(/[\n\\~^−±×≥≤<>|–]|[&%$#_{}]/g, (letter) => kSpecial[letter] ?? `\\${letter}`);
}
