// Requests the earlier history from the program, once per exploration.

import type { History } from "./history";
import type { Server } from "./server";

export class HistorySource {
  private asking = false;

  constructor(
    private readonly server: Server,
    private readonly history: History,
    private readonly taken: () => void,
  ) {}

  /** Called for each frame. A reply for another exploration is ignored: its frame is on its way. */
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
