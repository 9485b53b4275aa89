// The places of the elements of a channel: those of a layout file, else on an unfolded hand if the
// names describe one, else in a grid.

import type { ChannelData, LayoutData } from "../data";
import type { Box } from "../svg";
import { gridLayout, hasGrid } from "./grid_layout";
import { handLayout, type HandLayout } from "./hand_layout";

const kAround = 0.75; // from an element of a group to its outline

export function skinLayout({ elements, shape, layout }: ChannelData): HandLayout {
  if (layout?.places.length === elements.length) return placedLayout(layout);
  return handLayout(elements) ?? gridLayout(elements, shape);
}

/** Whether the elements have places, so that neighbours in the picture are neighbours on the skin. */
export function hasPlaces(channel: ChannelData): boolean {
  return skinLayout(channel).kind !== "grid" || hasGrid(channel.elements, channel.shape);
}

/** Whether it is drawn as a skin, and not as separate values. */
export function isSkin(channel: ChannelData): boolean {
  return hasPlaces(channel) || (channel.name.startsWith("touch") && channel.elements.length > 1);
}

/** The names of the groups that an element belongs to. */
export function groupsOf({ layout }: ChannelData, element: number): string[] {
  return (layout?.groups ?? []).filter(({ elements }) => elements.includes(element)).map(({ name }) => name);
}

/** In distances between neighbours, from the upper left corner of all. */
function placedLayout({ places, spacing, groups, background }: LayoutData): HandLayout {
  const corners = background === null ? [] : cornersOf(background);
  const all = boxAround([...places, ...corners]);
  const at = ([x, y]: readonly [number, number]) => ({
    x: (x - all.x) / spacing + kAround,
    y: (y - all.y) / spacing + kAround,
  });
  const dots = places.map(at);
  const boxes = groups.map(({ name, elements }) => ({ name, ...groupBox(elements.map((i) => dots[i]!)) }));
  return {
    kind: "placed",
    width: all.width / spacing + 2 * kAround,
    height: all.height / spacing + 2 * kAround,
    dots,
    segments: boxes,
    fingers: boxes.map(({ name, x, y, width, height }) => ({ name, x: x + width / 2, y: y + height })),
    background:
      background === null
        ? undefined
        : {
            image: background.image,
            ...at([background.x, background.y]),
            width: background.width / spacing,
            height: background.height / spacing,
          },
  };
}

function cornersOf({ x, y, width, height }: Box): [number, number][] {
  return [
    [x, y],
    [x + width, y + height],
  ];
}

function boxAround(points: readonly (readonly [number, number])[]): Box {
  const least = (axis: 0 | 1) => points.reduce((one, point) => Math.min(one, point[axis]), Number.POSITIVE_INFINITY);
  const most = (axis: 0 | 1) => points.reduce((one, point) => Math.max(one, point[axis]), Number.NEGATIVE_INFINITY);
  return { x: least(0), y: least(1), width: most(0) - least(0), height: most(1) - least(1) };
}

function groupBox(dots: readonly { x: number; y: number }[]): Box {
  const { x, y, width, height } = boxAround(dots.map((dot): [number, number] => [dot.x, dot.y]));
  return { x: x - kAround, y: y - kAround, width: width + 2 * kAround, height: height + 2 * kAround };
}
