// Scrubbing: at most one seek is pending; of the positions requested meanwhile only the newest is
// used.

import type { Model } from "../session/model";

export class Seeker {
  private wanted: { exploration: number; frame: number } | null = null;
  private running = false;

  constructor(private readonly model: Model) {}

  get busy(): boolean {
    return this.running;
  }

  seek(exploration: number, frame: number): void {
    this.wanted = { exploration, frame };
    if (!this.running) void this.run();
  }

  private async run(): Promise<void> {
    this.running = true;
    while (this.wanted !== null) {
      const next = this.wanted;
      this.wanted = null;
      await this.model.send({ command: "seek", ...next });
    }
    this.running = false;
  }
}
