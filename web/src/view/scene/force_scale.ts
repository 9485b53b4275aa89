// The scale of touch while it is measured: that of touch_colours.ts for the exploration so far, or
// fixed while it is held.

import type { NumberOrNull } from "../../parts/data";
import { touchEnd } from "../../parts/hands/touch_colours";

export class ForceScale {
  private most: number[] = []; // of each sensor
  private exploration = -1;
  private known: number | null = null;
  held = false;
  private measure = "";

  set unit(unit: string) {
    if (unit !== this.measure) this.known = null;
    this.measure = unit;
  }

  /** Called for every frame that is drawn. */
  see(exploration: number, values: readonly NumberOrNull[]): void {
    if (this.held) return;
    if (exploration !== this.exploration) this.clear();
    this.exploration = exploration;
    values.forEach((value, i) => {
      const size = Math.abs(value ?? 0) || 0;
      if (size <= (this.most[i] ?? 0)) return;
      this.most[i] = size;
      this.known = null;
    });
  }

  get end(): number {
    this.known ??= touchEnd(this.most, this.measure);
    return this.known;
  }

  /** The share of a value, 0 to 1; null if it is missing. */
  share(value: NumberOrNull | undefined): number | null {
    if (value === null || value === undefined) return null;
    return Math.min(1, Math.max(0, Math.abs(value) / this.end || 0));
  }

  private clear(): void {
    this.most = [];
    this.known = null;
  }
}
