// A contact's fields drawn on a canvas: cells in colours, traction or slip as arrows.

import { adhesion, ofSigned, ofSize, slip } from "./colours.ts";
import type { CellPart } from "./row_edge.ts";
import { digits } from "./units.ts";

export interface Cells {
  x: number[]; y: number[]; width: number[]; // [m]
  height: number;
  state: number[]; // 0 exterior, 1 adhesion, 2 slip
}
export interface MapContent {
  cells: Cells;
  colour: { values: number[]; unit: string; scale: number; signed: boolean } | "state";
  arrows?: { x: number[]; y: number[]; longest: number };
  outline?: { a: number; b: number };
  parts?: CellPart[]; // of the cells, where there is no such outline
  cutAt?: number; // y [m]
  isStretched?: boolean; // fills the picture: lengths along x and y have scales of their own
}

function ink(): string {
  return getComputedStyle(document.body).getPropertyValue("--ink").trim() || "#222";
}

/** Heights of regular rows from the cells' y. */
export function rowHeight(y: number[]): number {
  const rows = [...new Set(y)].sort((one, other) => one - other);
  return rows.length > 1 ? (rows.at(-1)! - rows[0]!) / (rows.length - 1) : 1e-3;
}

/** Canvas pixels of a length, and of positions: x to the right, y upwards, the contact in the middle. */
interface Place { scale: readonly [along: number, across: number]; at: (x: number, y: number) => [number, number] }

function place(canvas: HTMLCanvasElement, content: MapContent): Place {
  const { x, y, width, height, state } = content.cells;
  let left = Infinity, right = -Infinity, low = Infinity, high = -Infinity;
  for (let k = 0; k < x.length; ++k) {
    if (state[k] === 0) continue;
    left = Math.min(left, x[k]! - width[k]! / 2);
    right = Math.max(right, x[k]! + width[k]! / 2);
    low = Math.min(low, y[k]! - height / 2);
    high = Math.max(high, y[k]! + height / 2);
  }
  if (content.outline) {
    const { a, b } = content.outline;
    [left, right, low, high] = [-a, a, -b, b];
  }
  const margin = 34 * devicePixelRatio;
  const fitting = [(canvas.width - 2 * margin) / (right - left), (canvas.height - 2 * margin) / (high - low)] as const;
  const least = Math.min(...fitting), scale = content.isStretched ? fitting : ([least, least] as const);
  const [cx, cy] = [(left + right) / 2, (low + high) / 2];
  return { scale, at: (px, py) => [canvas.width / 2 + (px - cx) * scale[0], canvas.height / 2 - (py - cy) * scale[1]] };
}

export function fitToScreen(canvas: HTMLCanvasElement): CanvasRenderingContext2D {
  const width = Math.round(canvas.clientWidth * devicePixelRatio), height = Math.round(canvas.clientHeight * devicePixelRatio);
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const context = canvas.getContext("2d")!;
  context.clearRect(0, 0, canvas.width, canvas.height);
  return context;
}

function styleOf({ cells, colour }: MapContent): (k: number) => string {
  if (colour === "state") return (k) => (cells.state[k] === 2 ? slip : adhesion);
  const largest = Math.max(...colour.values.map(Math.abs), Number.MIN_VALUE);
  return (k) => (colour.signed ? ofSigned(colour.values[k]! / largest) : ofSize(colour.values[k]! / largest));
}

function fillParts(context: CanvasRenderingContext2D, content: MapContent, parts: CellPart[], { at }: Place): void {
  const style = styleOf(content);
  context.lineWidth = 0.6;
  for (const { k, low, high, y } of parts) {
    context.beginPath();
    for (const [px, py] of [[low[0], y[0]], [low[1], y[0]], [high[1], y[1]], [high[0], y[1]]] as const) context.lineTo(...at(px, py));
    context.closePath();
    context.fillStyle = context.strokeStyle = style(k);
    context.fill();
    context.stroke(); // over the seams
  }
}

/** Each cell enlarged by `more` of its size on all sides. */
function fillCells(context: CanvasRenderingContext2D, content: MapContent, { scale, at }: Place, more: number): void {
  const { cells } = content, style = styleOf(content);
  for (let k = 0; k < cells.x.length; ++k) {
    if (cells.state[k] === 0) continue;
    const width = cells.width[k]! * (1 + 2 * more), height = cells.height * (1 + 2 * more);
    const [px, py] = at(cells.x[k]! - width / 2, cells.y[k]! + height / 2);
    context.fillStyle = style(k);
    context.fillRect(px, py, width * scale[0] + 0.6, height * scale[1] + 0.6);
  }
}

/** Within the contact's outline, where it is known: enlarged cells fill what elements leave free at the edge. */
function drawCells(context: CanvasRenderingContext2D, content: MapContent, where: Place): void {
  context.save();
  if (content.outline) {
    const [cx, cy] = where.at(0, 0), { a, b } = content.outline;
    context.beginPath();
    context.ellipse(cx, cy, a * where.scale[0], b * where.scale[1], 0, 0, 2 * Math.PI);
    context.clip();
    fillCells(context, content, where, 1);
  }
  if (content.parts) fillParts(context, content, content.parts, where);
  else fillCells(context, content, where, 0);
  context.restore();
}

function drawArrows(context: CanvasRenderingContext2D, { cells, arrows }: MapContent, { scale, at }: Place): void {
  if (!arrows) return;
  const rows = new Set(cells.y).size, every = Math.max(1, Math.round(rows / 14));
  const pixels = (1.35 * every * cells.height * scale[1]) / arrows.longest;
  const arrowPaths = new Path2D();
  const order = [...new Set(cells.y)].sort((one, other) => one - other);
  const rowOf = new Map(order.map((y, j) => [y, j]));
  let inRow = 0, row = -1;
  for (let k = 0; k < cells.x.length; ++k) {
    const j = rowOf.get(cells.y[k]!)!;
    if (j !== row) [row, inRow] = [j, 0];
    if (cells.state[k] === 0 || (j - (every >> 1)) % every !== 0 || inRow++ % every !== every >> 1) continue;
    const [dx, dy] = [arrows.x[k]! * pixels, -arrows.y[k]! * pixels], size = Math.hypot(dx, dy);
    if (size < 1.5) continue;
    const [fromX, fromY] = at(cells.x[k]!, cells.y[k]!), tip = Math.min(5 * devicePixelRatio, size / 2);
    const [toX, toY, ux, uy] = [fromX + dx, fromY + dy, dx / size, dy / size];
    arrowPaths.moveTo(fromX, fromY);
    arrowPaths.lineTo(toX, toY);
    arrowPaths.moveTo(toX - tip * (ux + uy / 2), toY - tip * (uy - ux / 2));
    arrowPaths.lineTo(toX, toY);
    arrowPaths.lineTo(toX - tip * (ux - uy / 2), toY - tip * (uy + ux / 2));
  }
  for (const [colour, width] of [["#fff", 3.2], ["#000", 1.3]] as const) { // seen on light and on dark cells
    context.strokeStyle = colour;
    context.lineWidth = width * devicePixelRatio;
    context.stroke(arrowPaths);
  }
}

/** At most the given one, of one digit. */
function roundLength(rough: number): number {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * (rough / power >= 5 ? 5 : rough / power >= 2 ? 2 : 1);
}

/** The size of the picture, and the direction in which the contact rolls. */
function drawFrame(context: CanvasRenderingContext2D, content: MapContent, { scale, at }: Place): void {
  const pixel = devicePixelRatio, { width, height } = context.canvas;
  context.strokeStyle = context.fillStyle = ink();
  context.lineWidth = pixel;
  if (content.outline) {
    const [cx, cy] = at(0, 0);
    context.beginPath();
    context.ellipse(cx, cy, content.outline.a * scale[0], content.outline.b * scale[1], 0, 0, 2 * Math.PI);
    context.stroke();
  }
  if (content.cutAt !== undefined) {
    const [, cut] = at(0, content.cutAt);
    context.setLineDash([4 * pixel, 4 * pixel]);
    context.beginPath();
    context.moveTo(0, cut);
    context.lineTo(width, cut);
    context.stroke();
    context.setLineDash([]);
  }
  const long = roundLength((80 * pixel) / scale[0]), high = content.isStretched ? roundLength((50 * pixel) / scale[1]) : 0;
  context.beginPath();
  context.moveTo(10 * pixel, height - 10 * pixel - high * scale[1]);
  context.lineTo(10 * pixel, height - 10 * pixel);
  context.lineTo(10 * pixel + long * scale[0], height - 10 * pixel);
  context.stroke();
  context.font = `${12 * pixel}px system-ui, sans-serif`;
  context.fillText(`${digits(long * 1e3)} mm`, 14 * pixel, height - 16 * pixel);
  if (high > 0) context.fillText(`${digits(high * 1e3)} mm`, 10 * pixel, height - 16 * pixel - high * scale[1]);
  context.textAlign = "right";
  context.fillText("rolls this way →", width - 8 * pixel, 16 * pixel);
  context.textAlign = "left";
}

function drawScale(context: CanvasRenderingContext2D, { colour }: MapContent): void {
  const pixel = devicePixelRatio, { width, height } = context.canvas, right = width - 10 * pixel, low = height - 12 * pixel;
  context.font = `${12 * pixel}px system-ui, sans-serif`;
  context.textAlign = "right";
  if (colour === "state") {
    for (const [i, [fill, name]] of ([[adhesion, "adhesion"], [slip, "slip"]] as const).entries()) {
      context.fillStyle = fill;
      context.fillRect(right - 12 * pixel, low - (16 * i + 8) * pixel, 12 * pixel, 12 * pixel);
      context.fillStyle = ink();
      context.fillText(name, right - 18 * pixel, low - (16 * i - 2) * pixel);
    }
  } else {
    const length = 110 * pixel, largest = Math.max(...colour.values.map(Math.abs), Number.MIN_VALUE);
    for (let i = 0; i < length; ++i) {
      const t = i / length;
      context.fillStyle = colour.signed ? ofSigned(2 * t - 1) : ofSize(t);
      context.fillRect(right - length + i, low - 8 * pixel, 1.5, 8 * pixel);
    }
    context.fillStyle = ink();
    const least = colour.signed ? `${digits(-largest * colour.scale)} … ` : "0 … ";
    context.fillText(`${least}${digits(largest * colour.scale)} ${colour.unit}`, right, low - 12 * pixel);
  }
  context.textAlign = "left";
}

/** Nothing to draw, and what is missing for screen readers. */
export function clearMap(canvas: HTMLCanvasElement, missing: string): void {
  fitToScreen(canvas);
  canvas.setAttribute("aria-label", missing);
}

export function drawMap(canvas: HTMLCanvasElement, content: MapContent): void {
  const context = fitToScreen(canvas);
  if (canvas.clientWidth === 0 || !content.cells.state.some((state) => state > 0)) return;
  const where = place(canvas, content);
  drawCells(context, content, where);
  drawFrame(context, content, where);
  drawArrows(context, content, where);
  drawScale(context, content);
}

/** y [m] of a height on the canvas. */
export function yAt(canvas: HTMLCanvasElement, content: MapContent, clientY: number): number {
  const box = canvas.getBoundingClientRect(), { scale, at } = place(canvas, content), [, middle] = at(0, 0);
  return (middle - (clientY - box.top) * devicePixelRatio) / scale[1];
}
