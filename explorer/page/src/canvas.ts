// What pictures on a canvas have in common, in pixels of the page: sizes, texts, arrows, axes.

import { token } from "./colours.ts";

export interface Drawing { context: CanvasRenderingContext2D; width: number; height: number }
export type Point = readonly [x: number, y: number];
export interface Box { left: number; top: number; width: number; height: number }

/** Clears the canvas and makes it as fine as the screen. */
export function fitToScreen(canvas: HTMLCanvasElement): Drawing {
  const { clientWidth: width, clientHeight: height } = canvas, fine = devicePixelRatio;
  const [wide, high] = [Math.round(width * fine), Math.round(height * fine)];
  if (canvas.width !== wide || canvas.height !== high) Object.assign(canvas, { width: wide, height: high });
  const context = canvas.getContext("2d")!;
  context.setTransform(fine, 0, 0, fine, 0, 0);
  context.clearRect(0, 0, width, height);
  context.fillStyle = token("--panel"); // pictures that are saved have a ground
  context.fillRect(0, 0, width, height);
  return { context, width, height };
}

/** Nothing to draw, and what is missing for screen readers. */
export function clearCanvas(canvas: HTMLCanvasElement, missing: string): void {
  fitToScreen(canvas);
  canvas.setAttribute("aria-label", missing);
}

export interface TextStyle { size?: number; bold?: boolean; align?: CanvasTextAlign; colour?: string; halo?: boolean; turned?: boolean }

export function text(context: CanvasRenderingContext2D, words: string, [x, y]: Point, style: TextStyle = {}): void {
  const { size = 12, bold = false, align = "left", colour = "--ink", halo = false, turned = false } = style;
  context.save();
  context.font = `${bold ? "650 " : ""}${String(size)}px system-ui, sans-serif`;
  context.textAlign = align;
  context.translate(x, y);
  if (turned) context.rotate(-Math.PI / 2);
  if (halo) {
    context.strokeStyle = token("--panel");
    context.lineWidth = 4;
    context.lineJoin = "round";
    context.strokeText(words, 0, 0);
  }
  context.fillStyle = token(colour);
  context.fillText(words, 0, 0);
  context.restore();
}

export function line(context: CanvasRenderingContext2D, points: readonly Point[], colour: string, width = 1, dash: number[] = []): void {
  context.save();
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.strokeStyle = token(colour);
  context.lineWidth = width;
  context.lineJoin = "round";
  context.setLineDash(dash);
  context.stroke();
  context.restore();
}

/** A round mark with an edge of a colour. */
export function dot(context: CanvasRenderingContext2D, [x, y]: Point, radius: number, edge: string, width: number): void {
  context.save();
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = token("--panel");
  context.fill();
  context.strokeStyle = token(edge);
  context.lineWidth = width;
  context.stroke();
  context.restore();
}

/** Of arrows in one colour, which stay readable on any ground. */
export function arrows(context: CanvasRenderingContext2D, all: readonly (readonly [from: Point, to: Point])[], colour: string, width: number, head: number, halo = false): void {
  const shafts = new Path2D(), heads = new Path2D();
  for (const [[fromX, fromY], [toX, toY]] of all) {
    const [dx, dy] = [toX - fromX, toY - fromY], size = Math.hypot(dx, dy);
    if (size < 1.5) continue;
    const [ux, uy] = [dx / size, dy / size], tip = Math.min(head, 0.7 * size);
    shafts.moveTo(fromX, fromY);
    shafts.lineTo(toX - 0.8 * tip * ux, toY - 0.8 * tip * uy);
    heads.moveTo(toX, toY);
    heads.lineTo(toX - tip * (ux + 0.42 * uy), toY - tip * (uy - 0.42 * ux));
    heads.lineTo(toX - tip * (ux - 0.42 * uy), toY - tip * (uy + 0.42 * ux));
    heads.closePath();
  }
  context.save();
  context.lineJoin = "round";
  if (halo) {
    context.strokeStyle = token("--halo");
    context.globalAlpha = 0.7;
    context.lineWidth = width + 1.6;
    context.stroke(shafts);
    context.lineWidth = 1.6;
    context.stroke(heads);
    context.globalAlpha = 1;
  }
  context.strokeStyle = context.fillStyle = token(colour);
  context.lineWidth = width;
  context.stroke(shafts);
  context.fill(heads);
  context.restore();
}

/** At most the given one, of one digit. */
export function roundLength(rough: number): number {
  const power = 10 ** Math.floor(Math.log10(rough));
  return power * (rough / power >= 5 ? 5 : rough / power >= 2 ? 2 : 1);
}

/** Round numbers between two ends, about so many. */
export function ticks(from: number, to: number, count: number): number[] {
  const step = roundLength(Math.abs(to - from) / Math.max(count, 1) || 1), first = Math.ceil(Math.min(from, to) / step - 1e-9);
  return Array.from({ length: Math.floor(Math.max(from, to) / step + 1e-9) - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** A number in a picture, with a true minus. */
export const label = (value: number): string => String(Number(value.toPrecision(6))).replace("-", "−");

/** A cut-off body ends in a wavy line: its points from left to right. */
export function wave(left: number, right: number, y: number): Point[] {
  const count = Math.max(2, Math.round((right - left) / 4));
  return Array.from({ length: count + 1 }, (_, i): Point => [left + ((right - left) * i) / count, y + 2.2 * Math.sin((i * 4 * 2 * Math.PI) / 34)]);
}

export function inBox({ left, top, width, height }: Box, [x, y]: Point): boolean {
  return x >= left && x <= left + width && y >= top && y <= top + height;
}
