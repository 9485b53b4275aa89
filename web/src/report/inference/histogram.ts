// Small pictures in the rows of a table: the prior and the posterior of an unknown, and the ranks of its check.

import { percent } from "../../parts/numbers";
import { rounded, shape, svg } from "../../parts/svg";
import type { CalibratedData, UnknownData } from "../page/unpacked";
import { cellWords } from "./names";

const kWidth = 132;
const kHeight = 40;
const kGap = 2;

/** Bars for the posterior and lines for the prior, from the lowest cell to the highest. */
export function priorAndPosterior({ name, cells }: UnknownData): SVGSVGElement {
  const most = Math.max(0.01, ...cells.flatMap(({ prior, posterior }) => [prior, posterior]));
  const width = kWidth / Math.max(1, cells.length);
  const top = (share: number) => rounded(kHeight - 1 - ((kHeight - 3) * share) / most);
  const marks = cells.flatMap(({ prior, posterior }, i) => {
    const [from, to] = [rounded(i * width + kGap / 2), rounded((i + 1) * width - kGap / 2)];
    const y = top(posterior);
    return [
      shape("rect", { x: from, y, width: rounded(to - from), height: rounded(kHeight - 1 - y), class: "posterior" }),
      shape("line", { x1: from, x2: to, y1: top(prior), y2: top(prior), class: "prior" }),
    ];
  });
  const base = shape("line", { x1: 0, x2: kWidth, y1: kHeight - 0.5, y2: kHeight - 0.5, class: "axis" });
  const words = cells.map((cell) => `${cellWords(cell)}: ${percent(cell.prior)}, ${percent(cell.posterior)}`);
  return small(svg(kWidth, kHeight, `Prior and posterior of ${name}: ${words.join("; ")}`, [...marks, base]));
}

const kRankHeight = 18;

/** A line for each rank from 0 to 1, on the interval that should contain nine of ten. */
export function rankStrip({ name, ranks }: CalibratedData): SVGSVGElement {
  const ticks = ranks.map((rank) => {
    const x = rounded(1 + rank * (kWidth - 2));
    return shape("line", { x1: x, x2: x, y1: 2, y2: kRankHeight - 2, class: "rank" });
  });
  const central = shape("rect", { x: 0.05 * kWidth, y: 0, width: 0.9 * kWidth, height: kRankHeight, class: "central" });
  return small(svg(kWidth, kRankHeight, `Ranks of ${name}, from 0 to 1`, [central, ...ticks]));
}

function small(picture: SVGSVGElement): SVGSVGElement {
  picture.classList.add("in-table");
  return picture;
}
