// The page as a picture for `somato view --render`: without controls, and each frame is drawn at once
// and completely, because the program waits until it is drawn.

/** Called before the page is built. */
export function beginPicture(address: string): void {
  document.documentElement.classList.toggle("as-picture", new URL(address).searchParams.has("picture"));
}

export function isPicture(): boolean {
  return document.documentElement.classList.contains("as-picture");
}
