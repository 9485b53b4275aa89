// Tables as LaTeX, for the package booktabs; every character stands for itself.

import type { Cell, Table } from "./csv";
import { significant } from "./numbers";

const kSpecial: Record<string, string> = {
  "\\": "\\textbackslash{}",
  "~": "\\textasciitilde{}",
  "^": "\\textasciicircum{}",
  "−": "$-$",
  "±": "$\\pm$",
  "×": "$\\times$",
  "≥": "$\\geq$",
  "≤": "$\\leq$",
};

const kFigures = 4; // significant ones

export function latex(table: Table, caption: string): string {
  const columns = table.columns.map((_, i) => (isNumeric(table, i) ? "r" : "l")).join("");
  const line = (cells: readonly Cell[]) => `    ${cells.map(cellText).join(" & ")} \\\\`;
  return [
    "% \\usepackage{booktabs}",
    "\\begin{table}",
    `  \\caption{${escaped(caption)}}`,
    `  \\begin{tabular}{${columns}}`,
    "    \\toprule",
    line(table.columns),
    "    \\midrule",
    ...table.rows.map(line),
    "    \\bottomrule",
    "  \\end{tabular}",
    "\\end{table}",
    "",
  ].join("\n");
}

function isNumeric({ rows }: Table, column: number): boolean {
  return rows.length > 0 && rows.every((row) => typeof row[column] !== "string");
}

function cellText(cell: Cell): string {
  if (cell === null || (typeof cell === "number" && !Number.isFinite(cell))) return "--";
  if (typeof cell === "number") return escaped(significant(cell, Number.isInteger(cell) ? 15 : kFigures));
  return escaped(cell);
}

function escaped(words: string): string {
  return words.replaceAll(/[\\~^−±×≥≤]|[&%$#_{}]/g, (letter) => kSpecial[letter] ?? `\\${letter}`);
}
