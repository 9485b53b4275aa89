// The moments of a training that were received: the newest is shown, until an earlier one is chosen.

import type { Training } from "../data";

const kMost = 400;

export class TrainingPast {
  private looks: Training[] = [];
  private at: number | null = null;

  take(training: Training | null): void {
    const last = this.looks.at(-1);
    const continues =
      training !== null && last?.system === training.system && training.step >= last.step && !last.done;
    if (!continues && !isSame(last, training)) {
      this.looks = [];
      this.at = null;
    }
    if (training === null || isSame(this.looks.at(-1), training)) return;
    this.looks.push(training);
    if (this.looks.length > kMost) this.looks.shift();
  }

  goTo(look: number): void {
    this.at = look >= this.looks.length - 1 ? null : look;
  }

  get count(): number {
    return this.looks.length;
  }

  get isFollowing(): boolean {
    return this.at === null;
  }

  get shown(): Training | null {
    return this.looks[this.at ?? this.looks.length - 1] ?? null;
  }
}

/** The last moment is sent again to a page that connects again. */
function isSame(one: Training | undefined, other: Training | null): boolean {
  return one !== undefined && JSON.stringify(one) === JSON.stringify(other);
}
