// Sizes of pictures that fit the window, so that a telephone does not shrink their texts.

const kAround = 76; // pixels beside a picture: the margins of the page and of its figure

export function fitting(size: number): number {
  return Math.max(160, Math.min(size, document.documentElement.clientWidth - kAround));
}
