// Short tones for a person who does not look at the page. They can be switched off; the browser
// keeps that.

import { keep, kept } from "../../parts/kept";
import { Observable } from "../session/observable";

export type Tone = "done" | "undone" | "refused";

const kKey = "somato-tones";
const kLoudness = 0.15;
const kNotes: Record<Tone, { hertz: number; begin: number; length: number }[]> = {
  done: [{ hertz: 880, begin: 0, length: 0.12 }],
  undone: [
    { hertz: 660, begin: 0, length: 0.1 },
    { hertz: 440, begin: 0.11, length: 0.12 },
  ],
  refused: [
    { hertz: 196, begin: 0, length: 0.14 },
    { hertz: 196, begin: 0.2, length: 0.14 },
  ],
};

export class Tones {
  readonly isOn = new Observable(kept(kKey) !== "off");
  private context: AudioContext | null = null;

  turn(on: boolean): void {
    keep(kKey, on ? "on" : "off");
    this.isOn.set(on);
  }

  /** A browser permits sound from a key press or a click on, in which this is called. */
  prepare(): void {
    if (!this.isOn.value || typeof AudioContext === "undefined") return;
    this.context ??= new AudioContext();
    if (this.context.state === "suspended") void this.context.resume();
  }

  play(tone: Tone): void {
    this.prepare();
    if (!this.isOn.value || this.context === null) return;
    for (const note of kNotes[tone]) sound(this.context, note);
  }
}

/** Without a click at the end. */
function sound(context: AudioContext, { hertz, begin, length }: (typeof kNotes)["done"][number]): void {
  const source = context.createOscillator();
  const loudness = context.createGain();
  const at = context.currentTime + begin;
  source.frequency.value = hertz;
  loudness.gain.setValueAtTime(kLoudness, at);
  loudness.gain.exponentialRampToValueAtTime(0.001, at + length);
  source.connect(loudness).connect(context.destination);
  source.start(at);
  source.stop(at + length);
}
