// The report: a page that shows the data written by `somato report`.

import "../parts/style.css";
import "./report.css";

import { element } from "../parts/dom";
import { themeButton } from "../parts/theme";
import { drawAllForPrint } from "./page/lazy";
import { reportPage } from "./page/page";
import { readReport } from "./page/read";

function start(): void {
  const place = document.getElementById("report");
  const text = document.getElementById("report-data")?.textContent ?? "";
  if (!place) return;
  const read = readReport(text);
  if ("problem" in read) {
    place.append(problemPage(read.problem));
    return;
  }
  drawAllForPrint();
  reportPage(place, read.data);
}

function problemPage(problem: string): HTMLElement {
  return element("div", { class: "problem-page" }, [
    themeButton(),
    element("h1", {}, ["Somato report"]),
    element("p", { class: "message problem", role: "alert" }, [problem]),
  ]);
}

start();
