// The stream of events and its state: it is lost if the browser reports an error or if no event has
// arrived within three ping intervals. It is then reconnected every few seconds, or on request.

import type { Events, Scene, State } from "../data";
import type { Server } from "./server";

export type Link =
  | { kind: "connecting" }
  | { kind: "open" }
  | { kind: "lost"; seconds: number; full: boolean } // until the next attempt; full: too many viewers
  | { kind: "refused" }; // the token is invalid

export interface Listener {
  link(link: Link): void;
  state(state: State): void;
  scene(scene: Scene | null): void;
  frame(text: string): void; // not parsed: most frames may be dropped
  training(text: string): void;
}

const silence = 6500; // ms
const pause = 3; // s

export class Connection {
  private events: EventSource | null = null;
  private silent = 0;
  private countdown = 0;
  private full = false;
  private known = false; // whether the scene was requested since connecting

  constructor(
    private readonly server: Server,
    private readonly listener: Listener,
  ) {}

  open(): void {
    this.close();
    this.listener.link({ kind: "connecting" });
    const events = this.server.events();
    this.events = events;
    events.onerror = () => void this.lose();
    events.onopen = () => this.greet();
    this.listen(events);
    this.restartTimeout();
  }

  close(): void {
    this.events?.close();
    this.events = null;
    window.clearTimeout(this.silent);
    window.clearInterval(this.countdown);
  }

  private listen(events: EventSource): void {
    const on = (name: keyof Events, take: (text: string) => void) =>
      events.addEventListener(name, (event: MessageEvent<string>) => {
        this.restartTimeout();
        take(event.data);
      });
    on("state", (text) => this.listener.state(JSON.parse(text) as Events["state"]));
    on("scene", (text) => this.tellScene(JSON.parse(text) as Events["scene"]));
    on("frame", (text) => this.listener.frame(text));
    on("training", (text) => this.listener.training(text));
    on("ping", () => undefined);
  }

  private greet(): void {
    this.known = false;
    this.listener.link({ kind: "open" });
    void this.askScene();
  }

  private async askScene(): Promise<void> {
    try {
      const scene = await this.server.scene();
      if (!this.known) this.tellScene(scene);
    } catch {
      // The end of the stream reports the error.
    }
  }

  private tellScene(scene: Scene | null): void {
    this.known = true;
    this.listener.scene(scene);
  }

  private restartTimeout(): void {
    window.clearTimeout(this.silent);
    this.silent = window.setTimeout(() => void this.lose(), silence);
  }

  private async lose(): Promise<void> {
    this.close();
    this.full = false;
    this.wait(pause);
    const status = await this.server.status();
    this.full = status === 503;
    if (status !== 401 && status !== 403) return;
    this.close();
    this.listener.link({ kind: "refused" });
  }

  private wait(seconds: number): void {
    let left = seconds;
    const report = () => this.listener.link({ kind: "lost", seconds: left, full: this.full });
    report();
    this.countdown = window.setInterval(() => {
      left -= 1;
      if (left <= 0) this.open();
      else report();
    }, 1000);
  }
}
