// Saves content of the page as a file, without a server.
//
//   svgText(picture)   the picture as a self-contained SVG file, always in the light theme
//   pngOf(text, ...)   the same as a PNG
//   saveFile(name, blob)

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
  "font-family",
  "font-size",
  "font-weight",
  "font-style",
  "font-variant-numeric",
  "text-anchor",
  "dominant-baseline",
  "letter-spacing",
  "paint-order",
];

/** The picture with inline colours and fonts, on white. */
export function svgText(picture: SVGSVGElement): string {
  const copy = picture.cloneNode(true) as SVGSVGElement;
  const place = document.createElement("div");
  place.className = "theme-light off-screen";
  place.style.cssText = "position:absolute;left:-10000px;top:0";
  place.append(copy);
  document.body.append(place);
  try {
    copy.querySelectorAll("[data-transient]").forEach((mark) => mark.remove());
    writeOutStyles(copy);
  } finally {
    place.remove();
  }
  copy.querySelectorAll("style").forEach((sheet) => sheet.remove());
  return withBackground(copy);
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
  for (const name of ["class", "style", "tabindex", "role", ...kProperties]) one.removeAttribute(name);
  for (const { name } of [...one.attributes]) {
    if (/^(aria-(?!label)|data-|on)/.test(name)) one.removeAttribute(name);
  }
  for (const [name, value] of styles) one.setAttribute(name, value);
}

function withBackground(copy: SVGSVGElement): string {
  const [x = 0, y = 0, width = 0, height = 0] = sizeOf(copy);
  const margin = 8;
  const box = [x - margin, y - margin, width + 2 * margin, height + 2 * margin];
  const back = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  ["x", "y", "width", "height"].forEach((name, i) => back.setAttribute(name, String(box[i])));
  back.setAttribute("fill", "#ffffff");
  copy.prepend(back);
  copy.setAttribute("viewBox", box.join(" "));
  copy.setAttribute("width", String(box[2]));
  copy.setAttribute("height", String(box[3]));
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}

/** x, y, width and height of the content of a picture. */
export function sizeOf(picture: SVGSVGElement): number[] {
  const box = picture.getAttribute("viewBox");
  if (box !== null) return box.split(/[ ,]+/).map(Number);
  return [0, 0, Number(picture.getAttribute("width")), Number(picture.getAttribute("height"))];
}

/** The picture as a PNG with `scale` pixels per SVG pixel. */
export async function pngOf(text: string, scale: number): Promise<Blob> {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = Math.ceil(image.naturalWidth * scale);
  canvas.height = Math.ceil(image.naturalHeight * scale);
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob === null ? reject(new Error("no picture")) : resolve(blob)), "image/png");
  });
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
