// The font of saved figures (Source Sans 3, SIL Open Font License), which each of them contains,
// because the machine that shows them may not have the fonts of the page.

import bold from "@fontsource/source-sans-3/files/source-sans-3-latin-600-normal.woff2?inline";
import regular from "@fontsource/source-sans-3/files/source-sans-3-latin-400-normal.woff2?inline";

const kName = "Source Sans 3";

export const kFontFamily = `'${kName}', Arial, sans-serif`;

export function fontSheet(): string {
  const face = (weight: number, address: string) =>
    `@font-face{font-family:'${kName}';font-weight:${weight};src:url(${address}) format('woff2')}`;
  return face(400, regular) + face(600, bold);
}
