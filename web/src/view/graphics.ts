// What this browser draws three dimensions with: asked once, of a picture that nobody sees.

let asked: string | null | undefined;

export function drawsAtAll(): boolean {
  return renderer() !== null;
}

/** Without a graphics processor drawing is slow: the page then draws less and simpler. */
export function drawsInSoftware(): boolean {
  return /swiftshader|llvmpipe|software|softpipe/i.test(renderer() ?? "software");
}

function renderer(): string | null {
  if (asked === undefined) asked = ask();
  return asked;
}

function ask(): string | null {
  const context = document.createElement("canvas").getContext("webgl2");
  if (context === null) return null;
  const known = context.getExtension("WEBGL_debug_renderer_info");
  const name: unknown = known === null ? "" : context.getParameter(known.UNMASKED_RENDERER_WEBGL);
  context.getExtension("WEBGL_lose_context")?.loseContext(); // there are only so many
  return String(name);
}
