// Records the page as a film, or saves a picture of it: the browser captures this tab with the permission of the user.

import { element } from "../../parts/dom";
import { saveFile } from "../../parts/save";
import type { Model } from "../session/model";

const kPatience = 30_000; // ms until the browser has captured a picture
const kTypes = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"];

export class FilmButtons {
  readonly root = element("div", { class: "session-files", role: "group", "aria-label": "Pictures" });
  private readonly film = element("button", { type: "button", title: "Records this tab as a film (WebM)" });
  private readonly picture = element("button", { type: "button", title: "Saves this tab as a picture (PNG)" }, [
    "Save picture",
  ]);
  private recorder: MediaRecorder | null = null;
  private readonly captured = new Set<MediaStream>();
  // The browser captures the tab only when it is drawn, and a page at rest is not: this pixel changes invisibly.
  private readonly redrawn = element("span", { class: "film-redrawn", "aria-hidden": "true" });

  constructor(private readonly model: Model) {
    this.root.append(this.picture, this.film);
    this.redrawn.animate([{ opacity: 0 }, { opacity: 0.02 }], { duration: 100, iterations: Infinity });
    this.root.hidden = navigator.mediaDevices?.getDisplayMedia === undefined;
    this.film.addEventListener("click", () => void this.press());
    this.picture.addEventListener("click", () => void this.save());
    this.show();
  }

  private show(): void {
    this.film.textContent = this.recorder === null ? "Record film" : "Stop film";
    this.film.setAttribute("aria-pressed", String(this.recorder !== null));
  }

  private async press(): Promise<void> {
    if (this.recorder !== null) return this.recorder.stop();
    const stream = await this.capture();
    if (stream === null) return;
    const type = kTypes.find((one) => MediaRecorder.isTypeSupported(one));
    const recorder = new MediaRecorder(stream, type === undefined ? {} : { mimeType: type });
    const parts: Blob[] = [];
    recorder.addEventListener("dataavailable", ({ data }) => parts.push(data));
    recorder.addEventListener("stop", () => {
      this.end(stream);
      this.recorder = null;
      this.show();
      saveFile(`${this.stem()}.webm`, new Blob(parts, { type: "video/webm" }));
    });
    try {
      recorder.start();
    } catch {
      this.end(stream);
      this.model.problem.set("The browser did not record this tab; press Record film again");
      return;
    }
    this.recorder = recorder;
    this.show();
  }

  private async save(): Promise<void> {
    const stream = await this.capture();
    if (stream === null) return;
    try {
      saveFile(`${this.stem()}.png`, await firstPicture(stream));
    } catch {
      this.model.problem.set("The browser did not capture a picture of this tab; press Save picture again while the tab is visible");
    } finally {
      this.end(stream);
    }
  }

  /** Null if the user or the browser refuses. */
  private async capture(): Promise<MediaStream | null> {
    const options = { video: { frameRate: 30 }, audio: false, preferCurrentTab: true };
    try {
      const stream = await navigator.mediaDevices.getDisplayMedia(options);
      this.captured.add(stream);
      this.root.append(this.redrawn);
      return stream;
    } catch {
      this.model.problem.set("The browser did not permit this tab to be captured");
      return null;
    }
  }

  private end(stream: MediaStream): void {
    for (const track of stream.getTracks()) track.stop();
    this.captured.delete(stream);
    if (this.captured.size === 0) this.redrawn.remove();
  }

  private stem(): string {
    return (this.model.shownState.value?.name ?? "somato").replace(/\.mcap$/, "");
  }
}

async function firstPicture(stream: MediaStream): Promise<Blob> {
  const video = element("video", { muted: true });
  video.srcObject = stream;
  await within(kPatience, video.play());
  const canvas = element("canvas");
  canvas.width = video.videoWidth;
  canvas.height = video.videoHeight;
  canvas.getContext("2d")?.drawImage(video, 0, 0);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png");
  });
}

/** Rejects if `promised` takes more than `patience` ms. */
function within<T>(patience: number, promised: Promise<T>): Promise<T> {
  return new Promise((resolve, reject) => {
    const late = setTimeout(() => reject(new Error(`not within ${patience} ms`)), patience);
    promised.then(resolve, reject).finally(() => clearTimeout(late));
  });
}
