import "uplot/dist/uPlot.min.css";
import "../parts/style.css";
import "./view.css";

import { Connection } from "./session/connection";
import type { Frame, Training } from "./data";
import { FrameLoop } from "./session/frame_loop";
import { Model } from "./session/model";
import { buildPage } from "./page/page";
import { beginPicture, isPicture } from "./page/picture";
import { Server } from "./session/server";
import { watchTheme } from "./page/theme_colours";
import { takeToken } from "./session/token";

const root = document.getElementById("view");
if (root !== null) start(root);

function start(place: HTMLElement): void {
  const whole = document.documentElement; // its data are for `somato view --render`
  beginPicture(window.location.href);
  const server = new Server(takeToken());
  const model = new Model(server);
  const frames = new FrameLoop(
    (text) => {
      const frame = JSON.parse(text) as Frame;
      model.draw(frame);
      model.freshness.show();
      whole.dataset["shown"] = `${frame.exploration}:${frame.frame}`;
    },
    (work) => page.status.work(work),
    () => (isPicture() ? 0 : model.budget.pause),
  );
  const trainings = new FrameLoop(
    (text) => model.training.set(JSON.parse(text) as Training),
    () => undefined,
  );
  const connection = new Connection(server, model.freshness, {
    link: (link) => model.link(link),
    state: (state) => model.state(state),
    scene: (scene) => model.scene(scene),
    frame: (text) => frames.take(text),
    training: (text) => trainings.take(text),
    received: () => {
      if (!frames.isWaiting) model.freshness.show();
    },
  });
  connection.open(); // first: the program answers while the page is built
  model.frame.watch(() => (whole.dataset["curves"] = String(model.history.isWhole)));
  const page = buildPage(place, model, () => connection.open());
  watchTheme(() => model.theme.set(model.theme.value + 1));
}
