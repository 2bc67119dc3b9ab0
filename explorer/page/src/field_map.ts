// Fields of a contact on a canvas: smooth, up to its outline, with the border of adhesion and slip and arrows that stay inside.

import { arrows, fitToScreen, label, line, roundLength, text, ticks, type Box, type Drawing, type Point } from "./canvas.ts";
import { css, of, ramps, token, type Rgb } from "./colours.ts";
import { quantities, type Quantity, type Sheet, type Values } from "./sheet.ts";
import { digits } from "./units.ts";

/** What a map shows: friction in MPa or as a share of what can be borne, both by where it sticks and slides; and others. */
export type Shown = "friction" | "used" | "adhesion and slip" | "slip" | "pressure" | "px" | "py";

/** From the contact to the page: x to the right and y upwards, or, as seen on a rail from above, x upwards and y to the left. */
export interface Place { scale: Point; isTurned: boolean; at: (x: number, y: number) => Point; back: (px: number, py: number) => Point }

export function upright([ox, oy]: Point, [along, across]: Point): Place {
  return { scale: [along, across], isTurned: false, at: (x, y) => [ox + x * along, oy - y * across], back: (px, py) => [(px - ox) / along, (oy - py) / across] };
}
export function turned([ox, oy]: Point, scale: number): Place {
  return { scale: [scale, scale], isTurned: true, at: (x, y) => [ox - y * scale, oy - x * scale], back: (px, py) => [(oy - py) / scale, (ox - px) / scale] };
}

export interface Scale { shown: Shown; largest: number; unit: string; factor: number }
export const isByState = (shown: Shown): boolean => shown === "friction" || shown === "used" || shown === "adhesion and slip";

/** Places of the quantities of a chord. */
const at = Object.fromEntries(quantities.map((name, q) => [name, q])) as Record<Quantity, number>;
const largestOf = new WeakMap<Sheet, Map<string, number>>(); // sizes that were asked for

/** The largest size of one or, together, two quantities of a sheet. */
function largest(sheet: Sheet, name: Quantity, second?: Quantity): number {
  const known = largestOf.get(sheet) ?? new Map<string, number>(), key = name + (second ?? "");
  largestOf.set(sheet, known);
  let found = known.get(key);
  if (found !== undefined) return found;
  found = 0;
  for (const { values } of sheet.chords) {
    const [one, other] = [values[at[name]]!, second && values[at[second]]!];
    for (let i = 0; i < one.length; ++i) found = Math.max(found, one[i]! ** 2 + (other ? other[i]! ** 2 : 0));
  }
  known.set(key, found = Math.sqrt(found));
  return found;
}

/** Scale of what is shown of all sheets. */
export function scaleOf(sheets: readonly Sheet[], shown: Shown): Scale {
  const most = (...of: [Quantity, Quantity?]) => Math.max(1e-30, ...sheets.map((sheet) => largest(sheet, ...of)));
  if (shown === "used" || shown === "adhesion and slip") return { shown, largest: 1, unit: "%", factor: 100 };
  if (shown === "friction") return { shown, largest: most("px", "py"), unit: "MPa", factor: 1e-6 };
  return shown === "slip" ? { shown, largest: most("slip"), unit: "%", factor: 100 } : { shown, largest: most(shown), unit: "MPa", factor: 1e-6 };
}

export function valueOf(values: Values, shown: Shown): number {
  if (shown === "friction") return Math.hypot(values.px, values.py);
  return shown === "adhesion and slip" ? 0.6 : values[shown];
}

/** A colour of a pixel, in the order of bytes of images, from values by the places of their quantities; and which it needs. */
interface Painter { needs: Quantity[]; paint: (values: Float64Array) => number }
const packed = new WeakMap<Rgb[], Uint32Array>();
function pack(colours: Rgb[]): Uint32Array {
  let found = packed.get(colours);
  if (!found) packed.set(colours, found = Uint32Array.from(colours, ([red, green, blue]) => ((255 << 24) | (blue << 16) | (green << 8) | red) >>> 0));
  return found;
}

function painter({ shown, largest }: Scale): Painter {
  const [sizes, sticks, slides, signed] = [ramps().sizes, ramps().sticks, ramps().slides, ramps().signed].map(pack) as [Uint32Array, Uint32Array, Uint32Array, Uint32Array];
  const last = sizes.length - 1, pick = (colours: Uint32Array, t: number) => colours[t <= 0 ? 0 : t >= 1 ? last : Math.round(t * last)]!;
  const byState = (values: Float64Array) => (values[at.mark]! < 0 ? sticks : slides);
  if (shown === "friction") return { needs: ["px", "py", "mark"], paint: (values) => pick(byState(values), Math.sqrt(values[at.px]! ** 2 + values[at.py]! ** 2) / largest) };
  if (shown === "used") return { needs: ["used", "mark"], paint: (values) => pick(byState(values), values[at.used]!) };
  if (shown === "adhesion and slip") return { needs: ["mark"], paint: (values) => pick(byState(values), 0.6) };
  if (shown === "px" || shown === "py") return { needs: [shown], paint: (values) => pick(signed, (1 + values[at[shown]]! / largest) / 2) };
  return { needs: [shown], paint: (values) => pick(sizes, values[at[shown]]! / largest) };
}

let raster: HTMLCanvasElement | undefined; // that all maps are painted on first

function fillSheet(context: CanvasRenderingContext2D, sheet: Sheet, { scale: [along, across], isTurned, at: placeOf }: Place, { needs, paint }: Painter): void {
  const { left, right, bottom, top, places } = sheet, size = (length: number, pixels: number) => Math.max(4, Math.min(120, Math.round((length * pixels) / 2.5)));
  const [nx, ny] = [size(right - left, along), size(top - bottom, across)];
  raster ??= document.createElement("canvas");
  Object.assign(raster, { width: nx, height: ny });
  const pixels = raster.getContext("2d")!, image = pixels.createImageData(nx, ny), colours = new Uint32Array(image.data.buffer);
  const values = new Float64Array(quantities.length), rows = needs.map((name) => at[name]);
  for (let j = 0; j < ny; ++j) {
    const chord = sheet.chordAt(top - ((j + 0.5) / ny) * (top - bottom), rows)!, perPlace = chord.right > chord.left ? places / (chord.right - chord.left) : 0;
    for (let i = 0; i < nx; ++i) {
      const s = Math.min(Math.max((left + ((i + 0.5) / nx) * (right - left) - chord.left) * perPlace, 0), places), k = Math.min(Math.floor(s), places - 1), t = s - k;
      for (const q of rows) { const row = chord.values[q]!; values[q] = row[k]! + t * (row[k + 1]! - row[k]!); }
      colours[j * nx + i] = paint(values);
    }
  }
  pixels.putImageData(image, 0, 0);
  context.save();
  outlinePath(context, sheet, placeOf);
  context.clip();
  const [x0, y0] = placeOf(left, top), [dx, dy] = [(right - left) / nx, (top - bottom) / ny]; // of a pixel of the raster
  if (isTurned) context.transform(0, -dx * along, dy * across, 0, x0, y0);
  else context.transform(dx * along, 0, 0, dy * across, x0, y0);
  context.imageSmoothingEnabled = true;
  context.drawImage(raster, 0, 0);
  context.restore();
}

function outlinePath(context: CanvasRenderingContext2D, sheet: Sheet, at: Place["at"]): void {
  const corners = sheet.outline().map(([x, y]) => at(x, y));
  context.beginPath();
  corners.forEach(([x, y], i) => { // through the middles of its sides, round at its corners
    const [nextX, nextY] = corners[(i + 1) % corners.length]!, middle = [(x + nextX) / 2, (y + nextY) / 2] as const;
    if (i === 0) context.moveTo(...middle);
    else context.quadraticCurveTo(x, y, ...middle);
  });
  const [first, second] = [corners[0]!, corners[1]!];
  context.quadraticCurveTo(first[0], first[1], (first[0] + second[0]) / 2, (first[1] + second[1]) / 2);
  context.closePath();
}

/** The outline alone, as of a state that is compared. */
export function strokeOutline(context: CanvasRenderingContext2D, sheets: readonly Sheet[], { at }: Place, colour = "--ink", width = 1.6, dash: number[] = []): void {
  context.save();
  context.strokeStyle = token(colour);
  context.lineWidth = width;
  context.lineJoin = "round";
  context.setLineDash(dash);
  for (const sheet of sheets) { outlinePath(context, sheet, at); context.stroke(); }
  context.restore();
}

/** The line between adhesion and slip. */
export function strokeBorder(context: CanvasRenderingContext2D, sheets: readonly Sheet[], { at }: Place, colour = "--ink", dash: number[] = []): void {
  context.save();
  context.lineCap = context.lineJoin = "round";
  for (const [ink, width, alpha] of [["--halo", 4.6, 0.8], [colour, 2.2, 1]] as const) {
    context.beginPath();
    for (const sheet of sheets)
      for (const [[ax, ay], [bx, by]] of sheet.border()) {
        context.moveTo(...(at(ax, ay) as [number, number]));
        context.lineTo(...(at(bx, by) as [number, number]));
      }
    context.globalAlpha = alpha;
    context.strokeStyle = token(ink);
    context.lineWidth = width;
    context.setLineDash(dash);
    context.stroke();
  }
  context.restore();
}

/** The largest friction has an arrow of `longest` pixels; of others that would leave the contact only what is inside. */
function drawArrows(context: CanvasRenderingContext2D, sheets: readonly Sheet[], place: Place, spacing: number, largest: number): void {
  const found: (readonly [Point, Point])[] = [], { at, back, isTurned } = place;
  for (const sheet of sheets) {
    const corners = sheet.outline().map(([x, y]) => at(x, y)), [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
    const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
    const first = (low: number, high: number) => (low + high) / 2 - Math.floor((high - low) / 2 / spacing) * spacing;
    const isInside = ([px, py]: Point) => sheet.contains(...(back(px, py) as [number, number]));
    for (let py = first(top, bottom); py < bottom; py += spacing)
      for (let px = first(left, right); px < right; px += spacing) {
        const values = sheet.at(...(back(px, py) as [number, number]));
        if (!values) continue;
        const pixels = (0.92 * spacing) / largest / 2, [dx, dy] = isTurned ? [-values.py * pixels, -values.px * pixels] : [values.px * pixels, -values.py * pixels];
        const ends = [[px - dx, py - dy], [px + dx, py + dy]] as const;
        if (ends.every(isInside)) found.push(ends);
      }
  }
  arrows(context, found, "--arrow", 1.35, 5.5, true);
}

export interface PatchStyle { scale: Scale; spacing?: number; largestArrow?: number }

/** A contact with its outline, the border of adhesion and slip, and arrows of friction where a spacing is given. */
export function drawPatch(context: CanvasRenderingContext2D, sheets: readonly Sheet[], place: Place, { scale, spacing, largestArrow }: PatchStyle): void {
  const paint = painter(scale);
  for (const sheet of sheets) fillSheet(context, sheet, place, paint);
  if (isByState(scale.shown)) strokeBorder(context, sheets, place);
  if (spacing) drawArrows(context, sheets, place, spacing, largestArrow ?? scaleOf(sheets, "friction").largest);
  strokeOutline(context, sheets, place);
}

const strips = new WeakMap<Rgb[], HTMLCanvasElement>();
/** A ramp from left to right, one pixel high. */
function strip(colours: Rgb[]): HTMLCanvasElement {
  let found = strips.get(colours);
  if (!found) {
    strips.set(colours, found = Object.assign(document.createElement("canvas"), { width: colours.length, height: 1 }));
    const pixels = found.getContext("2d")!, image = pixels.createImageData(colours.length, 1);
    new Uint32Array(image.data.buffer).set(pack(colours));
    pixels.putImageData(image, 0, 0);
  }
  return found;
}

/** The bar of a scale of colours with its numbers below it; of friction two, for adhesion and for slip. Their height. */
export function drawScale(context: CanvasRenderingContext2D, { left, top, width }: Pick<Box, "left" | "top" | "width">, { shown, largest, unit, factor }: Scale): number {
  const { sizes, sticks, slides, signed } = ramps(), isSigned = shown === "px" || shown === "py";
  const bars: [string, Rgb[]][] = isByState(shown) ? [["sticks", sticks], ["slides", slides]] : [["", isSigned ? signed : sizes]];
  const wordsWidth = isByState(shown) ? 46 : 0, from = left + wordsWidth, length = width - wordsWidth;
  bars.forEach(([name, colours], row) => {
    const y = top + 13 * row;
    if (name) text(context, name, [left, y + 9]);
    context.fillStyle = css(of(colours, 0.6));
    if (shown === "adhesion and slip") context.fillRect(from, y, length, 10);
    else context.drawImage(strip(colours), from, y, length, 10);
  });
  const low = top + 13 * bars.length, end = largest * factor;
  if (shown !== "adhesion and slip")
    for (const value of isSigned ? [-end, 0, end] : ticks(0, end, Math.min(4, Math.max(1, Math.floor(length / 80))))) text(context, label(Number(value.toPrecision(3))), [from + length * (isSigned ? (value / end + 1) / 2 : value / end), low + 10], { size: 11, align: "center", colour: "--ink2" });
  if (shown !== "adhesion and slip") text(context, unit, [from + length + 14, low + 10], { size: 11, colour: "--ink2" });
  return 13 * bars.length + 14;
}

/** Heights of regular rows from the elements' y. */
export function rowHeight(y: number[]): number {
  const rows = [...new Set(y)].sort((one, other) => one - other);
  return rows.length > 1 ? (rows.at(-1)! - rows[0]!) / (rows.length - 1) : 1e-3;
}

/** `largest`: of the scale, where it is not that of the sheets [Pa]. */
export interface MapContent { sheets: Sheet[]; shown: Shown; largest?: number; isStretched?: boolean; arrows?: boolean; xLabel?: string; yLabel?: string }

/** A place that fits the sheets into a box. */
export function placeIn({ left, top, width, height }: Box, sheets: readonly Sheet[], isStretched = false): Place {
  const corners = sheets.flatMap((sheet) => sheet.outline()), [xs, ys] = [corners.map(([x]) => x), corners.map(([, y]) => y)];
  const [x0, x1, y0, y1] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const fitting: Point = [width / Math.max(x1 - x0, 1e-9), height / Math.max(y1 - y0, 1e-9)], least = Math.min(...fitting);
  const scale: Point = isStretched ? fitting : [least, least];
  return upright([left + width / 2 - ((x0 + x1) / 2) * scale[0], top + height / 2 + ((y0 + y1) / 2) * scale[1]], scale);
}

/** Axes in mm around a box of a picture. */
export function drawAxes(context: CanvasRenderingContext2D, box: Box, { back, at }: Place, { xLabel = "x, along [mm]", yLabel = "y, across [mm]" }: Pick<MapContent, "xLabel" | "yLabel"> = {}): void {
  const [x0, y1] = back(box.left, box.top), [x1, y0] = back(box.left + box.width, box.top + box.height), low = box.top + box.height;
  for (const x of ticks(1e3 * x0, 1e3 * x1, box.width / 70)) {
    const [px] = at(x / 1e3, 0);
    line(context, [[px, box.top], [px, low]], "--line");
    text(context, label(x), [px, low + 14], { size: 11, align: "center", colour: "--ink2" });
  }
  for (const y of ticks(1e3 * y0, 1e3 * y1, box.height / 50)) {
    const [, py] = at(0, y / 1e3);
    line(context, [[box.left, py], [box.left + box.width, py]], "--line");
    text(context, label(y), [box.left - 6, py + 4], { size: 11, align: "right", colour: "--ink2" });
  }
  text(context, xLabel, [box.left + box.width / 2, low + 30], { size: 11, align: "center", colour: "--ink2" });
  text(context, yLabel, [box.left - 44, box.top + box.height / 2], { size: 11, align: "center", colour: "--ink2", turned: true });
}

export function drawRolling(context: CanvasRenderingContext2D, [x, y]: Point, length = 54): void {
  arrows(context, [[[x, y], [x + length, y]]], "--ui", 3, 11);
  text(context, "rolls this way", [x, y + 17], { size: 12.5, bold: true });
}

/** A map in a canvas of its own: scale, axes, rolling direction. */
export function drawMap(canvas: HTMLCanvasElement, { sheets, shown, isStretched = false, arrows: withArrows = false, largest: most, ...labels }: MapContent): void {
  const { context, width, height }: Drawing = fitToScreen(canvas);
  if (width === 0 || sheets.length === 0) return;
  const scale = { ...scaleOf(sheets, shown), ...(most === undefined ? {} : { largest: most }) }, end = Math.min(width - 110, 348), isNarrow = end + 200 > width, head = isNarrow && withArrows ? 66 : 52;
  const box: Box = { left: 58, top: head, width: width - 72, height: height - head - 38 };
  const place = placeIn({ left: box.left + 0.14 * box.width, top: box.top + 12, width: 0.72 * box.width, height: box.height - 24 }, sheets, isStretched);
  drawAxes(context, box, place, labels);
  drawPatch(context, sheets, place, { scale, ...(withArrows ? { spacing: 26, largestArrow: scale.largest } : {}) });
  drawScale(context, { left: isNarrow ? 8 : box.left, top: 6, width: Math.min(210, 0.5 * width) }, scale);
  drawRolling(context, [end, 14]);
  if (withArrows) {
    const { largest } = scale, round = roundLength(largest), [x, y] = isNarrow ? [end, 46] : [end + 120, 14];
    arrows(context, [[[x, y], [x + (0.92 * 26 * round) / largest, y]]], "--arrow", 1.35, 5.5);
    text(context, `${digits(round / 1e6)} MPa`, [x + 32, y + 4], { size: 11, colour: "--ink2" });
  }
}
