// How alike two pictures of a view are: point by point, or, where fonts or browser are others, by the colours of blocks of its canvases.

import pixelmatch from "pixelmatch";
import type { PNG } from "pngjs";

export interface Box { left: number; top: number; width: number; height: number }

/** Of the points of both pictures those whose colours differ, edges of letters and lines left out; 1 where the sizes differ. */
export function shareOfOtherPoints(one: PNG, other: PNG): number {
  if (one.width !== other.width || one.height !== other.height) return 1;
  return pixelmatch(one.data, other.data, undefined, one.width, one.height, { threshold: 0.05 }) / (one.width * one.height);
}

export const block = 24; // [px], as large as a few letters, whose strokes cover less than half of it

/** Mean red, green and blue of the blocks of a box. */
function blocksOf({ data, width, height }: PNG, box: Box): number[][] {
  const means: number[][] = [];
  for (let top = box.top; top + block <= Math.min(box.top + box.height, height); top += block)
    for (let left = box.left; left + block <= Math.min(box.left + box.width, width); left += block) {
      const sums = [0, 0, 0];
      for (let y = top; y < top + block; ++y) for (let x = left; x < left + block; ++x) for (let c = 0; c < 3; ++c) sums[c]! += data[4 * (y * width + x) + c]!;
      means.push(sums.map((sum) => sum / block ** 2));
    }
  return means;
}

/**
 * Of the blocks of a canvas those whose mean colours are apart by more than a twentieth of the way from black to white: in
 * lightness by four times as much, as letters darken a block but are grey. 1 where the canvas has another size.
 */
function shareOfOtherBlocks(one: PNG, box: Box, other: PNG, otherBox: Box): number {
  if (Math.abs(box.width - otherBox.width) > 2 || Math.abs(box.height - otherBox.height) > 2) return 1;
  const [mine, yours] = [blocksOf(one, box), blocksOf(other, otherBox)], count = Math.min(mine.length, yours.length);
  let differ = 0;
  for (let k = 0; k < count; ++k) {
    const [red, green, blue] = [0, 1, 2].map((c) => mine[k]![c]! - yours[k]![c]!) as [number, number, number];
    if (Math.max(Math.abs(red - green), Math.abs(blue - green)) > 0.05 * 255 || Math.abs(red + green + blue) / 3 > 0.2 * 255) ++differ;
  }
  return differ / Math.max(count, 1);
}

/** The largest share of other blocks of a canvas; 1 where one is missing. */
export function otherBlocks(one: PNG, boxes: Box[], other: PNG, otherBoxes: Box[]): number {
  if (boxes.length !== otherBoxes.length) return 1;
  return Math.max(...boxes.map((box, k) => shareOfOtherBlocks(one, box, other, otherBoxes[k]!)));
}
