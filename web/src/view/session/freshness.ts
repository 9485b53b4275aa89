// The age of what the page shows. The clocks of the program and the browser may differ, so that the page
// uses its own only: what arrives with a ping was the latest when it was sent, which was later than the
// acknowledgement before it by the time that the program waited. The age is therefore never stated too low.

export const kNoticed = 1000; // ms, from which the age is shown

export class Freshness {
  private requested = 0; // ms, when the last acknowledgement was sent, or the stream was opened
  private number = 0; // of the last ping
  private received: number | null = null; // ms, when what was received last was the latest
  private shown: number | null = null; // the same of what is shown

  /** A stream is opened. */
  begin(now: number): void {
    this.requested = now;
    this.number = 0;
    this.received = null;
  }

  /** A ping with new events, which are acknowledged now; a repeated one has nothing new. */
  receive(number: number, waited: number, now: number): void {
    if (number === this.number) return;
    this.received = this.requested + 1000 * waited;
    this.requested = now;
    this.number = number;
  }

  /** All that was received is shown. */
  show(): void {
    this.shown = this.received ?? this.shown;
  }

  /** ms by which the page is behind at most; 0 before anything is shown. */
  age(now: number): number {
    return this.shown === null ? 0 : Math.max(0, now - this.shown);
  }
}
