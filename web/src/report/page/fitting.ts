// Sizes of pictures that fit the window, so that a telephone does not shrink their texts.

const kAround = 76; // pixels beside a picture: the margins of the page and of its figure

let paper: number | null = null;

/** From now on pictures fit a width on paper in mm, so that their texts have the size of other texts. */
export function fitPaper(width: number): void {
  paper = (width * 96) / 25.4;
}

export function fitting(size: number): number {
  return Math.max(160, Math.min(size, paper ?? document.documentElement.clientWidth - kAround));
}
