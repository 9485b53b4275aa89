// The browser's renderer for three dimensions, determined once with a hidden canvas.

let found: string | null | undefined;

export function drawsAtAll(): boolean {
  return renderer() !== null;
}

/** Without a graphics processor drawing is slow: the page then draws less and simpler. */
export function drawsInSoftware(): boolean {
  return /swiftshader|llvmpipe|software|softpipe/i.test(renderer() ?? "software");
}

function renderer(): string | null {
  if (found === undefined) found = findRenderer();
  return found;
}

function findRenderer(): string | null {
  const context = document.createElement("canvas").getContext("webgl2");
  if (context === null) return null;
  const known = context.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = known === null ? "" : context.getParameter(known.UNMASKED_RENDERER_WEBGL);
  context.getExtension("WEBGL_lose_context")?.loseContext(); // their number is limited
  return String(name);
}
