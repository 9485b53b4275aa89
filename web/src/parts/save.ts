// Saves content of the page as a file, without a server.
//
//   svgText(picture, about)   the picture as a self-contained SVG file, always in the light theme
//   pngOf(text, about)        the same as a PNG
//   saveFile(name, blob)
//
// A file contains its fonts, and where it came from in its metadata. kSaving is what the reader
// chose for all files: their width and whether they contain title and caption.

import { element } from "./dom";
import { fontSheet, kFontFamily } from "./font";
import { pixelPaths } from "./maps/painter";
import { withText } from "./png_text";
import { shape, text, textWidth } from "./svg";

/** The title, the caption and the origin that a saved file contains. */
export interface About {
  title: string;
  caption: string;
  facts: [name: string, value: string][]; // such as the seed and the hash of the data
}

export const kSaving: { width: number | null; hasCaption: boolean } = {
  width: null, // in mm; null: as on the page
  hasCaption: true,
};

const kProperties = [
  "fill",
  "fill-opacity",
  "stroke",
  "stroke-width",
  "stroke-opacity",
  "stroke-dasharray",
  "stroke-linecap",
  "stroke-linejoin",
  "opacity",
  "font-size",
  "font-weight",
  "font-style",
  "font-variant-numeric",
  "image-rendering",
  "shape-rendering",
  "text-anchor",
  "dominant-baseline",
  "letter-spacing",
  "paint-order",
];

/** The picture with inline colours and fonts, on white. */
export function svgText(picture: SVGSVGElement, about: About): string {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  drawPixelsAsPaths(picture, copy);
  const place = element("div", { class: "theme-light off-screen", style: "position:absolute;left:-10000px;top:0" }, [
    copy,
  ]);
  document.body.append(place);
  try {
    copy.querySelectorAll("[data-transient]").forEach((mark) => mark.remove());
    writeOutStyles(copy);
  } finally {
    place.remove();
  }
  copy.querySelectorAll("style").forEach((sheet) => sheet.remove());
  frame(copy, about);
  describe(copy, about);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

function drawPixelsAsPaths(picture: SVGSVGElement, copy: SVGSVGElement): void {
  const images = [...picture.querySelectorAll("image")].map((image) => pixelPaths(image));
  copy.querySelectorAll("image").forEach((image, i) => {
    const paths = images[i];
    if (paths) image.replaceWith(paths);
  });
}

function writeOutStyles(copy: SVGSVGElement): void {
  const all = [copy, ...copy.querySelectorAll<SVGElement>("*")];
  const styles = all.map((one) => stylesOf(one));
  all.forEach((one, i) => writeOut(one, styles[i] ?? []));
}

function stylesOf(one: SVGElement): [string, string][] {
  const computed = getComputedStyle(one);
  const parent = one.parentElement instanceof SVGElement ? getComputedStyle(one.parentElement) : null;
  return kProperties
    .map((name): [string, string] => [name, computed.getPropertyValue(name)])
    .filter(([name, value]) => value !== "" && value !== parent?.getPropertyValue(name));
}

function writeOut(one: SVGElement, styles: [string, string][]): void {
  for (const name of ["class", "style", "tabindex", "role", "font-family", ...kProperties]) one.removeAttribute(name);
  for (const { name } of [...one.attributes]) {
    if (/^(aria-|data-|on)/.test(name)) one.removeAttribute(name);
  }
  for (const [name, value] of styles) one.setAttribute(name, value);
}

const kMargin = 8;
const kTitle = { size: 14, row: 22 };
const kCaption = { size: 11, row: 15 };

/** A white background, and title and caption if they are wanted. */
function frame(copy: SVGSVGElement, about: About): void {
  const [x = 0, y = 0, width = 0, height = 0] = sizeOf(copy);
  const { above, below } = kSaving.hasCaption ? words(about, x, y, width, height) : { above: [], below: [] };
  const top = y - kMargin - above.length * kTitle.row;
  const bottom = y + height + kMargin + below.length * kCaption.row + (below.length > 0 ? kMargin : 0);
  // Whole numbers, so that a PNG is not stretched to whole pixels.
  const [wide, tall] = [Math.ceil(width + 2 * kMargin), Math.ceil(bottom - top)];
  const back = { x: x - kMargin, y: top, width: wide, height: tall, fill: "#ffffff" };
  copy.prepend(shape("rect", back));
  copy.append(...above, ...below);
  copy.setAttribute("viewBox", [x - kMargin, top, wide, tall].join(" "));
  const mm = kSaving.width;
  copy.setAttribute("width", mm === null ? String(wide) : `${mm}mm`);
  copy.setAttribute("height", mm === null ? String(tall) : `${Math.round((mm * tall * 100) / wide) / 100}mm`);
}

function words(
  { title, caption }: About,
  x: number,
  y: number,
  width: number,
  height: number,
): { above: SVGTextElement[]; below: SVGTextElement[] } {
  const titles = wrapped(title, width, kTitle.size);
  const above = titles.map((line, i) =>
    text(x, y - kMargin - (titles.length - 1 - i) * kTitle.row, line, { "font-size": kTitle.size, "font-weight": 600 }),
  );
  const below = wrapped(caption, width, kCaption.size).map((line, i) =>
    text(x, y + height + kMargin + (i + 1) * kCaption.row, line, { "font-size": kCaption.size, fill: "#444444" }),
  );
  return { above, below };
}

function wrapped(words: string, width: number, size: number): string[] {
  const lines: string[] = [];
  for (const word of words.split(" ").filter((one) => one !== "")) {
    const longer = `${lines.at(-1) ?? ""} ${word}`;
    if (lines.length > 0 && textWidth(longer, size) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

const kRdf = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
const kDublinCore = "http://purl.org/dc/elements/1.1/";

/** Title, description and origin, for programs and people who find the file without the page. */
function describe(copy: SVGSVGElement, about: About): void {
  const work = document.createElementNS(kRdf, "rdf:Description");
  const say = (name: string, words: string) => {
    const made = document.createElementNS(kDublinCore, `dc:${name}`);
    made.textContent = words;
    work.append(made);
  };
  say("title", about.title);
  say("description", about.caption);
  about.facts.forEach(([name, value]) => say("source", `${name}: ${value}`));
  const rdf = document.createElementNS(kRdf, "rdf:RDF");
  rdf.append(work);
  copy.setAttribute("font-family", kFontFamily);
  copy.prepend(
    shape("title", {}, [about.title]),
    shape("desc", {}, [about.caption]),
    shape("metadata", {}, [rdf]),
    shape("style", {}, [fontSheet()]),
  );
}

/** x, y, width and height of the content of a picture. */
export function sizeOf(picture: SVGSVGElement): number[] {
  const box = picture.getAttribute("viewBox");
  if (box !== null) return box.split(/[ ,]+/).map(Number);
  return [0, 0, Number(picture.getAttribute("width")), Number(picture.getAttribute("height"))];
}

const kScale = 3; // pixels of a PNG for each of the page
const kDotsPerMm = 600 / 25.4; // where a width is chosen

/** The SVG as a PNG with the same facts. */
export async function pngOf(svg: string, about: About): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const width = kSaving.width === null ? image.naturalWidth * kScale : kSaving.width * kDotsPerMm;
  const canvas = document.createElement("canvas");
  canvas.width = Math.ceil(width);
  canvas.height = Math.ceil((width * image.naturalHeight) / image.naturalWidth);
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  const blob = await new Promise<Blob>((resolve, reject) => {
    canvas.toBlob((made) => (made === null ? reject(new Error("no picture")) : resolve(made)), "image/png");
  });
  const bytes = new Uint8Array(await blob.arrayBuffer());
  return new Blob([withText(bytes, textsOf(about))], { type: "image/png" });
}

function textsOf({ title, caption, facts }: About): [string, string][] {
  return [["Title", title], ["Description", caption], ...facts];
}

export function saveFile(name: string, blob: Blob): void {
  const address = URL.createObjectURL(blob);
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  link.click();
  // The browser reads the address asynchronously, before it requests the file name.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

/** A page of HTML that contains only the picture, at its size in millimetres. */
export function printablePage(svg: string, title: string): { page: string; width: number; height: number } {
  const picture = new DOMParser().parseFromString(svg, "image/svg+xml").documentElement;
  const [width, height] = ["width", "height"].map((name) => Number.parseFloat(picture.getAttribute(name) ?? "0"));
  const head = element("title", {}, [title]).outerHTML;
  const style = "<style>html,body{margin:0}svg{display:block}</style>";
  const page = `<!doctype html><html data-picture><meta charset="utf-8">${head}${style}${picture.outerHTML}</html>`;
  return { page, width: width ?? 0, height: height ?? 0 };
}
