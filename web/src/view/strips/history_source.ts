// Requests the earlier history from the program: when it begins, and again after frames were missed,
// but not with each frame of a page that draws slowly, nor without a pause on a slow line, on which the
// history delays the frames.

import type { History } from "./history";
import type { Server } from "../session/server";

const kPause = 2000; // ms, between two requests for the same history
const kRest = 4; // times as long as the last answer took

export class HistorySource {
  private requesting = false;
  private requested = { beginnings: -1, next: 0 }; // ms
  private timer = 0;

  constructor(
    private readonly server: Server,
    private readonly history: History,
    private readonly taken: () => void,
  ) {}

  /** Called for each frame. */
  look(): void {
    if (this.requesting || !this.history.isLacking) return;
    window.clearTimeout(this.timer);
    const { beginnings, next } = this.requested;
    const wait = beginnings === this.history.beginnings ? next - performance.now() : 0;
    if (wait > 0) this.timer = window.setTimeout(() => this.look(), wait);
    else void this.ask();
  }

  /**
   * A reply for another exploration is ignored: its frame is on its way. One that lacks frames which
   * arrived before it is requested again, though no frame may follow.
   */
  private async ask(): Promise<void> {
    this.requesting = true;
    const begin = performance.now();
    this.requested = { beginnings: this.history.beginnings, next: begin + kPause };
    let isTaken = false;
    try {
      const strips = await this.server.strips();
      isTaken = strips !== null && this.history.take(strips);
      if (isTaken) this.taken();
    } catch {
      this.history.doWithout();
    } finally {
      const end = performance.now();
      this.requested.next = Math.max(this.requested.next, end + kRest * (end - begin));
      this.requesting = false;
      if (isTaken) this.look();
    }
  }
}
