// Asks the program, once an exploration, what was told before anybody looked.

import type { History } from "./history";
import type { Server } from "./server";

export class HistorySource {
  private asking = false;

  constructor(
    private readonly server: Server,
    private readonly history: History,
    private readonly taken: () => void,
  ) {}

  /** With each frame. An answer about another exploration is no answer: its frame is on its way. */
  async look(): Promise<void> {
    if (this.asking || !this.history.isLacking) return;
    this.asking = true;
    try {
      const strips = await this.server.strips();
      if (strips !== null && this.history.take(strips)) this.taken();
    } catch {
      this.history.doWithout();
    } finally {
      this.asking = false;
    }
  }
}
