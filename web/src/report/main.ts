// The report: a page that shows the data written by `somato report`.

import "../parts/style.css";
import "./report.css";

import { element } from "../parts/dom";
import { themeButton } from "../parts/theme";
import { parsedAddress } from "./page/address";
import { drawAllForPrint } from "./page/lazy";
import { reportPage } from "./page/page";
import { readReport } from "./page/read";
import { FigureFiles } from "./paper/figure_files";

/** The address by which `somato figure` opens the page (program/report/figure_page.cc). */
const kFiguresOnly = "figures-only";

function start(): void {
  const place = document.getElementById("report");
  const text = document.getElementById("report-data")?.textContent ?? "";
  if (!place) return;
  const read = readReport(text);
  if ("problem" in read) {
    place.append(problemPage(read.problem));
    return;
  }
  const { id, state } = parsedAddress(location.hash);
  if (id === kFiguresOnly) {
    Object.assign(globalThis, { somatoFigures: new FigureFiles(place, read.data, Number(state.get("width"))) });
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
