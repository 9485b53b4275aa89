// The settings that a text has not yet stated, so that it states each once and omits none.

import type { SystemReport } from "../page/unpacked";
import type { Sentence } from "./cited_text";
import { inWords, unquoted } from "./printed";

export class SettingsLeft {
  private readonly left: Map<string, Map<string, string>>;

  constructor(settings: SystemReport["settings"]) {
    const parts = Object.entries(settings);
    this.left = new Map(parts.map(([part, own]) => [part, new Map(Object.entries(own))]));
  }

  /** The parts that have settings left, whose names match. */
  parts(pattern: RegExp): string[] {
    return [...this.left].filter(([part, own]) => pattern.test(part) && own.size > 0).map(([part]) => part);
  }

  /** The modules except `other`. */
  modules(other: string | null): string[] {
    return this.parts(/^module\./).filter((part) => part !== other);
  }

  type(part: string): string {
    return this.look(part, "type");
  }

  look(part: string, name: string): string {
    return unquoted(this.left.get(part)?.get(name) ?? "");
  }

  /** The same, which is then stated. */
  take(part: string, name: string): string {
    const value = this.look(part, name);
    this.left.get(part)?.delete(name);
    return value;
  }

  /** All that is left of a part: " with rows = 15, columns = 15". */
  listed(part: string): string {
    const own = [...(this.left.get(part) ?? [])];
    this.left.delete(part);
    return own.length === 0 ? "" : ` with ${own.map(([name, value]) => `${inWords(name)} = ${valueWords(value)}`).join(", ")}`;
  }

  /** `begin` with all that is left of a part. */
  sentence(part: string, begin: string): Sentence {
    return [`${begin}${this.listed(part)}.`];
  }
}

function valueWords(value: string): string {
  return value === '""' || value === "[]" ? "none" : unquoted(value);
}
