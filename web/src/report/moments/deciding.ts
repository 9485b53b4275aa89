// Which sensors separate two classes for single explorations: the contributions of channels in a table,
// those of their elements on the skin. They sum to the difference of the two distances.

import { choice } from "../../parts/controls";
import type { Table } from "../../parts/csv";
import { element, fill, type Child } from "../../parts/dom";
import { figure, scrolled, type Shown } from "../../parts/figure";
import {
  coloursInWords,
  contributionPicture,
  greatestOf,
  signed,
  strongestOf,
  type Contributed,
} from "../../parts/hands/contributions";
import { isSkin } from "../../parts/hands/skin_layout";
import { capital, readable, withUnit } from "../../parts/numbers";
import { fitting } from "../page/fitting";
import { shownOfSaved } from "../page/origin";
import type { DecidingData, SystemReport } from "../page/unpacked";
import { systemName } from "../page/words";
import { nameOf } from "./samples";

type Decision = DecidingData["decisions"][number];
type Source = DecidingData["sources"][number];

const kMostListed = 3; // elements of a channel
const kNote =
  "Distances are those of the trained system, which has learned all explorations and can answer otherwise than the tests.";

export function decidingFigures(system: SystemReport): Child[] {
  const { deciding } = system;
  if (!deciding) return [];
  const place = element("div", { class: "figures" });
  const show = (index: number) => {
    const shown = deciding.decisions[index];
    if (shown) fill(place, new ShownDecision(system, deciding, index, shown).figures());
  };
  show(0);
  const names = deciding.decisions.map((one) => `${nameOf(system, one.sample)}: ${kindOf(one)}`);
  return [element("div", { class: "controls" }, [choice("Exploration of", names, 0, show).element]), place];
}

function kindOf({ predicted, confused, nearest, other, label }: Decision): string {
  const isOfConfusion = confused > 0 && [nearest, other].includes(predicted) && [nearest, other].includes(label);
  return isOfConfusion ? `confused with ${predicted}` : `between ${nearest} and ${other}`;
}

class ShownDecision {
  constructor(
    private readonly system: SystemReport,
    private readonly deciding: DecidingData,
    private readonly index: number,
    private readonly decision: Decision,
  ) {}

  figures(): Child[] {
    const skins = this.deciding.sources.filter(({ channel, values }) => isSkin(channel) && values.length > 0);
    return [this.channels(), ...skins.map((source) => this.skin(source))];
  }

  private channels(): Child {
    const table = this.channelTable();
    return figure({
      title: "Contributions of channels",
      file: `${systemName(this.system)}-deciding`,
      body: element("div", {}, [...this.sentences(), tableOf(table)]),
      numbers: () => this.elementTable(),
      printed: { table: () => table, note: `${this.sentence()} ${kNote}` },
      about: () => this.about(),
      note: kNote,
      hint: "The CSV contains the contributions of all elements.",
    });
  }

  private skin(source: Source): Child {
    const { channel } = source;
    const { nearest, other } = this.decision;
    const picture = contributionPicture(channel, { unit: this.deciding.unit, size: fitting(380) });
    picture.show(this.valuesOf(source), greatestOf(this.deciding.sources.map((one) => this.valuesOf(one))));
    return figure({
      title: `Contributions of ${channel.name}`,
      file: `${systemName(this.system)}-deciding-${channel.name}`,
      body: element("div", {}, [picture.element]),
      picture: () => picture.svg,
      numbers: () => this.elementTable([source]),
      about: () => this.about(),
      note: coloursInWords(nearest, other),
    });
  }

  private valuesOf({ values }: Source): readonly (number | null)[] {
    return values[this.index] ?? [];
  }

  private contributed(source: Source): Contributed {
    return { name: source.channel.name, elements: source.channel.elements, values: this.valuesOf(source) };
  }

  private sentences(): Child[] {
    const { predicted, confused, tests, answer, label } = this.decision;
    const named = confused > 0 ? [`${confused} of ${tests} tests named it ${predicted}.`] : [];
    const truth = label === "" ? "" : `It is ${label}. `;
    return [
      element("p", { class: "small" }, [[`${truth}The trained system answers ${answer}.`, ...named].join(" ")]),
      element("p", { class: "small" }, [this.sentence()]),
    ];
  }

  /** Positive contributions are similar to the first class. */
  private sentence(): string {
    const { nearest, other, of_nearest, of_other } = this.decision;
    const { unit, products } = this.deciding;
    const value = (one: number) => withUnit(readable(one), unit);
    const kind = products ? "product with" : "distance from";
    return (
      `The ${kind} ${nearest} is ${value(of_nearest)}, the ${kind} ${other} ${value(of_other)}. ` +
      `Positive contributions are those of elements that are closer to ${nearest}, negative ones to ${other}.`
    );
  }

  /** Channels in descending order of their contributions, for either class; then the sum. */
  private channelTable(): Table {
    const { unit, products, sources } = this.deciding;
    const { sums, of_nearest, of_other } = this.decision;
    const rows = sources
      .map((source, i) => ({ source, sum: sums[i] ?? 0 }))
      .sort((one, other) => Math.abs(other.sum) - Math.abs(one.sum))
      .map(({ source, sum }) => {
        const strongest = strongestOf([this.contributed(source)], kMostListed);
        const words = strongest.map(({ element: one, value }) => `${one} ${signed(value, unit)}`).join(", ");
        return [source.channel.name, signed(sum, unit), words];
      });
    const difference = products ? of_nearest - of_other : of_other - of_nearest;
    const last = products ? "difference of the products" : "difference of the distances";
    return { columns: ["channel", "contribution", "strongest elements"], rows: [...rows, [last, signed(difference, unit), ""]] };
  }

  private elementTable(sources = this.deciding.sources): Table {
    const { unit } = this.deciding;
    const rows = sources.flatMap((source) => {
      const { name, elements } = source.channel;
      return this.valuesOf(source).map((value, i) => [name, elements[i] ?? String(i + 1), value]);
    });
    return { columns: ["channel", "element", unit === "" ? "contribution" : `contribution (${unit})`], rows };
  }

  private about(): Shown {
    const { nearest, other, sample } = this.decision;
    const shown = shownOfSaved(this.system);
    const words = `${nameOf(this.system, sample)}, ${nearest} against ${other}`;
    return {
      words: `${shown.words}, ${words}`,
      name: `${shown.name}-sample${sample + 1}`,
      facts: [...shown.facts, ["Exploration", words]],
    };
  }
}

function tableOf({ columns, rows }: Table): HTMLElement {
  const kinds = ["", "number", ""];
  const cells = (row: Table["rows"][number]) =>
    row.map((cell, i) => element("td", { class: kinds[i] ?? "" }, [i === 0 ? capital(String(cell)) : String(cell)]));
  const head = columns.map((name, i) => element("th", { scope: "col", class: kinds[i] ?? "" }, [name]));
  const table = element("table", { class: "wide-table" }, [
    element("thead", {}, [element("tr", {}, head)]),
    element(
      "tbody",
      {},
      rows.map((row) => element("tr", {}, cells(row))),
    ),
  ]);
  return scrolled("Contributions of channels", table);
}
