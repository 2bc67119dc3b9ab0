// Wheel and rail cut open, the rail head from above below it on the same lateral axis, and a lens on the patches in the same
// orientation: the track's left is at the left, so y grows to the left, and forward is upwards. The field side of a left wheel
// is at the left, that of a right one at the right.

import { arrows, dot, fitToScreen, inBox, label, line, roundLength, text, ticks, wave, type Box, type Point, type TextStyle } from "./canvas.ts";
import { token } from "./colours.ts";
import { drawPatch, drawScale, scaleOf, strokeOutline, turned, valueOf, type Place } from "./field_map.ts";
import type { ElementFields, Sheet } from "./sheet.ts";
import type { WheelSide } from "./state.ts";
import { digits } from "./units.ts";

export interface Outline { y: number[]; z: number[] }
export interface Patch {
  normal_force: number; fx: number; fy: number; possible: number; place_x: number; place_y: number; place_z: number; angle: number; rail_y: number; peak_pressure: number;
  contact_area: number; slip_area: number; fields: ElementFields | undefined; sheets: Sheet[];
}
export interface Scene {
  side: WheelSide;
  rail: Outline; wheel: Outline; patches: Patch[];
  yaw: number; // [rad]
  names: { wheel: string; radius: string; rail: string; lean: string };
  trouble: string; // what is wrong with where the wheel is, in words
  compared: { wheel: Outline; patches: Patch[] } | undefined;
  isComputing: boolean; // the patches
  isTold: boolean; // that the wheel can be dragged
}

/** Pixels of a metre of the section, and where its parts lie. `toField`: 1 where the field side has larger y, at the left, else -1. */
export interface Layout { scale: number; toField: 1 | -1; section: Box; above: Box; lens: Box; legend: Point; middle: number; top: number; height: number; isNarrow: boolean }

const railWidth = 0.0735; // of 60E1 [m], to which the section is laid out
const fieldSide = 0.064, gaugeSide = 0.075, above = 0.035, below = 0.034; // what is shown around the rail's top [m]

export function middleOf({ y }: Outline): number {
  return (Math.min(...y) + Math.max(...y)) / 2;
}

export function layOut(width: number, rail: Outline, side: WheelSide = "left"): Layout {
  const isNarrow = width < 860, size = Math.min(Math.max((Math.max(...rail.y) - Math.min(...rail.y)) / railWidth, 0.5), 3);
  const left = isNarrow ? 26 : 58, plot = isNarrow ? width - left - 4 : Math.min(width - left - 340, 0.63 * width);
  const scale = plot / ((fieldSide + gaugeSide) * size), shown = (isNarrow ? 0.75 : 1) * (above + below) * size * scale;
  const section: Box = { left, top: 26, width: plot, height: shown };
  const head: Box = { left, top: section.top + shown + (isNarrow ? 6 : 26), width: plot, height: (isNarrow ? 0.021 : 0.033) * size * scale };
  const foot = head.top + head.height + (isNarrow ? 20 : 36), glass = Math.max(132, 0.36 * width);
  const lens: Box = isNarrow ? { left: 4, top: foot, width: 0.46 * width, height: glass } : { left: left + plot + 40, top: 178, width: width - left - plot - 70, height: head.top + head.height - 178 };
  return {
    scale, toField: side === "left" ? 1 : -1, section, above: head, lens, isNarrow, middle: middleOf(rail), top: section.top + (isNarrow ? 0.4 : 0.5) * shown,
    legend: isNarrow ? [lens.left + lens.width + 30, foot + 12] : [lens.left, 20], height: isNarrow ? foot + glass + 8 : foot,
  };
}

/** A place across by its share of the section's width from the field side [px]. */
const fromField = ({ section: { left, width }, toField }: Layout, share: number): number => left + (toField > 0 ? share : 1 - share) * width;

export const sectionPlace = (layout: Layout) => (y: number, z: number): Point => {
  const { middle, top, scale } = layout, zero = fromField(layout, fieldSide / (fieldSide + gaugeSide));
  return [zero - (y - middle) * scale, top - z * scale];
};

export const abovePlace = (layout: Layout): Place => {
  const [zero] = sectionPlace(layout)(layout.middle, 0), { above: head, scale } = layout;
  return turned([zero + layout.middle * scale, head.top + head.height / 2], scale);
};

const yawDrawn = 50; // times

/** The handle that turns the wheelset, on the head from above. */
export function yawHandle(layout: Layout, yaw: number): { foot: Point; tip: Point } {
  const { above: head, section } = layout, foot: Point = [fromField(layout, section.width > 450 ? 0.83 : 0.9), head.top + 0.9 * head.height], length = 0.78 * head.height, angle = Math.min(Math.max(yawDrawn * yaw, -1.2), 1.2);
  return { foot, tip: [foot[0] - length * Math.sin(angle), foot[1] - length * Math.cos(angle)] };
}

/** The yaw of a handle that was dragged to here. */
export function yawAt(layout: Layout, [x, y]: Point): number {
  const { foot } = yawHandle(layout, 0);
  return Math.atan2(foot[0] - x, Math.max(foot[1] - y, 8)) / yawDrawn;
}

function fill(context: CanvasRenderingContext2D, points: Point[], colour: string): void {
  context.beginPath();
  for (const [x, y] of points) context.lineTo(x, y);
  context.closePath();
  context.fillStyle = token(colour);
  context.fill();
}

/** A body in section: filled up to where it is cut off, in a wavy line. */
function drawBody(context: CanvasRenderingContext2D, points: Point[], cut: number, colour: string, isAbove: boolean): void {
  const [first, last] = [points[0]!, points.at(-1)!];
  fill(context, [...points, [last[0], cut], [first[0], cut]], colour);
  line(context, [[first[0], cut], ...points, [last[0], cut]], `${colour}-edge`, 2);
  const edge = wave(Math.min(first[0], last[0]) - 6, Math.max(first[0], last[0]) + 6, cut), away = isAbove ? -40 : 40;
  fill(context, [...edge, [edge.at(-1)![0], cut + away], [edge[0]![0], cut + away]], "--panel");
  line(context, edge, "--ink3");
}

/** How far the flange is from the rail's inner side, where the gauge is measured, and between which places [m]. */
export function flangeClearance({ side, rail, wheel }: Pick<Scene, "side" | "rail" | "wheel">): { free: number; rail: number; wheel: number; z: number } | undefined {
  const toField = side === "left" ? 1 : -1, z = Math.max(...rail.z) - 0.014;
  const crossings = ({ y, z: height }: Outline) => y.flatMap((from, i) => {
    const [z0, z1] = [height[i]! - z, (height[i + 1] ?? height[i]!) - z];
    return z0 > 0 !== z1 > 0 ? [from + ((y[i + 1]! - from) * z0) / (z0 - z1)] : [];
  });
  const inner = Math.min(...crossings(rail).map((y) => toField * y)), flank = Math.max(...crossings(wheel).map((y) => toField * y));
  return Number.isFinite(inner) && Number.isFinite(flank) ? { free: inner - flank, rail: toField * inner, wheel: toField * flank, z } : undefined;
}

/** How a text is aligned that ends, or on the other side begins, at its place. */
const endOf = (toField: 1 | -1): CanvasTextAlign => (toField > 0 ? "right" : "left");
const beginOf = (toField: 1 | -1): CanvasTextAlign => (toField > 0 ? "left" : "right");

function drawForces(context: CanvasRenderingContext2D, at: (y: number, z: number) => Point, patches: Patch[], { isNarrow, toField }: Layout): void {
  const [main] = [...patches].sort((one, other) => other.normal_force - one.normal_force), most = main?.normal_force ?? 1;
  for (const patch of patches) {
    const { normal_force, fy, place_y, place_z, angle } = patch, [px, py] = at(place_y, place_z), pixels = (isNarrow ? 62 : 104) / most;
    const [sin, cos] = [Math.sin(angle), Math.cos(angle)];
    const normal: Point = [px + normal_force * pixels * sin, py - normal_force * pixels * cos], across: Point = [px - fy * pixels * cos, py - fy * pixels * sin];
    line(context, [[px - 54 * cos, py - 54 * sin], [px + 54 * cos, py + 54 * sin]], "--ink2", 1, [4, 4]);
    arrows(context, [[[px, py], normal], [[px, py], across]], "--ink", 3, 12, true);
    dot(context, [px, py], 5, "--ink", 2);
    if (normal_force < 0.04 * most) continue;
    const beside = normal[0] + 9 * toField, align = beginOf(toField);
    text(context, `${digits(Math.round(normal_force / 100) / 10)} kN`, [beside, normal[1] + 6], { bold: true, size: 12.5, halo: true, align });
    if (!isNarrow && patch === main) {
      text(context, "square to the surface", [beside, normal[1] + 21], { halo: true, align });
      const isLeft = fy * cos > 0;
      text(context, `${digits(Math.round(Math.abs(fy) / 100) / 10)} kN friction, sideways`, [across[0] + (isLeft ? -8 : 8), across[1] - 10], { bold: true, size: 12.5, halo: true, align: isLeft ? "right" : "left" });
      text(context, `contact plane tilts ${((toField * angle * 180) / Math.PI).toFixed(1).replace("-", "−")}°`, [px - 14 * toField, py + 26], { align: endOf(toField), halo: true });
    }
  }
}

/** An outline on the screen, without points closer than a pixel to the last one. */
function pixelsOf({ y, z }: Outline, at: (y: number, z: number) => Point): Point[] {
  const kept: Point[] = [];
  y.forEach((value, i) => {
    const point = at(value, z[i]!), last = kept.at(-1);
    if (!last || i === y.length - 1 || Math.abs(point[0] - last[0]) + Math.abs(point[1] - last[1]) > 1) kept.push(point);
  });
  return kept;
}

function drawSection(context: CanvasRenderingContext2D, scene: Scene, layout: Layout): void {
  const { section, isNarrow, middle, toField } = layout, at = sectionPlace(layout), points = (outline: Outline) => pixelsOf(outline, at);
  const foot = section.top + section.height, low = Math.max(...scene.rail.z) - (foot - layout.top) / layout.scale, high = (layout.top - section.top) / layout.scale;
  for (const z of ticks(1e3 * low, 1e3 * high, section.height / 60)) {
    const [, y] = at(0, z / 1e3);
    line(context, [[section.left, y], [section.left + section.width, y]], "--line");
    text(context, label(z), [section.left - 6, y + 4], { size: 11, align: "right", colour: "--ink2" });
  }
  if (!isNarrow) text(context, "height over the rail's top [mm]", [14, section.top + section.height / 2], { size: 11, align: "center", colour: "--ink2", turned: true });
  context.save();
  context.beginPath();
  context.rect(section.left, section.top - 4, section.width, section.height + 8);
  context.clip();
  drawBody(context, points(scene.rail), foot, "--rail", false);
  drawBody(context, points(scene.wheel), section.top + 3, "--wheel", true);
  if (scene.compared) line(context, points(scene.compared.wheel), "--ink3", 1.6, [6, 4]);
  context.restore();
  const outer = Math.min(isNarrow ? 0.05 : 0.058, Math.max(...scene.wheel.y.map((y) => toField * (y - middle))) - 4e-3); // within the wheel
  const [wheelX] = at(middle + toField * outer, 0), [railX, railY] = at(middle + toField * 0.01, isNarrow ? -0.012 : -0.022);
  text(context, "Wheel", [wheelX, section.top + (isNarrow ? 26 : 46)], { size: 14, bold: true, align: beginOf(toField) });
  text(context, "Rail", [railX, railY], { size: 14, bold: true, align: "center" });
  if (!isNarrow) {
    [scene.names.wheel, scene.names.radius].forEach((words, i) => { text(context, words, [wheelX, section.top + 63 + 15 * i], { align: beginOf(toField) }); });
    [scene.names.rail, scene.names.lean].forEach((words, i) => { text(context, words, [railX, railY + 17 + 15 * i], { align: "center" }); });
    const ofTread = middle + toField * 0.045, tread = scene.wheel.y.reduce((best, y, i) => (Math.abs(y - ofTread) < Math.abs(scene.wheel.y[best]! - ofTread) ? i : best), 0);
    const tip = scene.wheel.z.reduce((lowest, z, i) => (z < scene.wheel.z[lowest]! ? i : lowest), 0);
    const treadAt = at(scene.wheel.y[tread]!, scene.wheel.z[tread]!), flangeAt = at(scene.wheel.y[tip]!, scene.wheel.z[tip]!);
    text(context, "tread", [treadAt[0], treadAt[1] - 14], { align: "center" });
    text(context, "flange", [flangeAt[0], flangeAt[1] - 30], { align: "center" });
    const field = "field side (outside of the track)", gauge = "gauge side (towards the other rail)";
    text(context, `◂ ${toField > 0 ? field : gauge}`, [section.left + 4, 14], { bold: true, size: 12.5 });
    text(context, `${toField > 0 ? gauge : field} ▸`, [section.left + section.width - 2, 14], { bold: true, size: 12.5, align: "right" });
  } else {
    text(context, toField > 0 ? "◂ outside" : "◂ other rail", [section.left, 14]);
    text(context, toField > 0 ? "other rail ▸" : "outside ▸", [section.left + section.width, 14], { align: "right" });
  }
  const flange = flangeClearance(scene);
  if (flange && !isNarrow && flange.free > 2e-4 && flange.free < 0.02) {
    const [from, to] = [at(flange.rail, flange.z), at(flange.wheel, flange.z)];
    arrows(context, [[[from[0] - 18 * toField, from[1]], from], [[to[0] + 16 * toField, to[1]], to]], "--ink2", 1, 6);
    text(context, `${(1e3 * flange.free).toFixed(1)} mm to the flange`, [from[0] - 22 * toField, from[1] + 4], { align: endOf(toField), halo: true });
  }
  drawForces(context, at, scene.patches, layout);
  if (scene.trouble) {
    const y = section.top + 0.28 * section.height, wide = Math.min(section.width - 20, 7.2 * scene.trouble.length + 30), x = section.left + section.width / 2;
    context.fillStyle = token("--bad-soft");
    context.strokeStyle = token("--bad");
    context.lineWidth = 1.5;
    context.beginPath();
    context.roundRect(x - wide / 2, y - 20, wide, 32, 8);
    context.fill();
    context.stroke();
    text(context, scene.trouble, [x, y + 1], { align: "center", bold: true, size: isNarrow ? 12 : 13, colour: "--bad" });
  }
  if (!scene.isTold) pill(context, [fromField(layout, isNarrow ? 0.82 : 0.5), section.top + 22], isNarrow ? "↔ drag me" : "↔ drag the wheel");
}

function pill(context: CanvasRenderingContext2D, [x, y]: Point, words: string): void {
  context.beginPath();
  const half = 3.2 * words.length + 18;
  context.roundRect(x - half, y - 14, 2 * half, 27, 14);
  context.fillStyle = token("--panel");
  context.fill();
  context.strokeStyle = token("--ui");
  context.lineWidth = 1.4;
  context.stroke();
  text(context, words, [x, y + 4], { align: "center" });
}

/** The place of a patch in track axes: its own y is along the surface. */
function patchPlace({ scale, at, isTurned }: Place, { place_x, place_y, angle }: Patch): Place {
  const cos = Math.cos(angle), [ox, oy] = at(place_x, place_y);
  return { scale: [scale[0], scale[1] * cos], isTurned, at: (x, y) => [ox - y * cos * scale[1], oy - x * scale[0]], back: (px, py) => [(oy - py) / scale[0], (ox - px) / (scale[1] * cos)] };
}

/** What of the head the lens shows [m]: the patches, or nothing. */
function lensFrame(patches: Patch[], lens: Box): { x: number; y: number; pixels: number } | undefined {
  const all = patches.flatMap(({ sheets, place_x, place_y, angle }) => sheets.flatMap((sheet) => sheet.outline().map(([x, y]) => [place_x + x, place_y + y * Math.cos(angle)] as const)));
  if (all.length === 0) return undefined;
  const [xs, ys] = [all.map(([x]) => x), all.map(([, y]) => y)], middle = (of: number[]) => (Math.min(...of) + Math.max(...of)) / 2;
  const length = Math.max(...xs) - Math.min(...xs), width = Math.max(...ys) - Math.min(...ys);
  return { x: middle(xs), y: middle(ys), pixels: Math.min(lens.height / length, lens.width / width) / 1.16 };
}

function drawAbove(context: CanvasRenderingContext2D, scene: Scene, layout: Layout, place: Place): void {
  const { above: head, isNarrow, toField } = layout, [left] = place.at(0, Math.max(...scene.rail.y)), [right] = place.at(0, Math.min(...scene.rail.y));
  if (!isNarrow) text(context, "The same rail head from above", [(left + right) / 2, head.top - 9], { bold: true, size: 12.5, align: "center" });
  const shade = context.createLinearGradient(left, 0, right, 0);
  for (const [at, colour] of [[0, "--rail-side"], [0.2, "--rail"], [0.5, "--rail-top"], [0.8, "--rail"], [1, "--rail-side"]] as const) shade.addColorStop(at, token(colour));
  context.fillStyle = shade;
  context.fillRect(left, head.top, right - left, head.height);
  line(context, [[left, head.top], [left, head.top + head.height]], "--rail-edge", 2);
  line(context, [[right, head.top], [right, head.top + head.height]], "--rail-edge", 2);
  const foot = head.top + head.height, [x1, y0] = place.back(head.left, head.top), [x0, y1] = place.back(head.left + head.width, foot);
  for (const y of ticks(1e3 * (y1 - layout.middle), 1e3 * (y0 - layout.middle), head.width / 80)) {
    const [px] = place.at(0, layout.middle + y / 1e3);
    text(context, String(Math.abs(y)), [px, foot + 14], { size: 11, align: "center", colour: "--ink2" });
  }
  if (!isNarrow) {
    for (const x of ticks(1e3 * x0, 1e3 * x1, 3)) text(context, label(x), [head.left - 6, place.at(x / 1e3, 0)[1] + 4], { size: 11, align: "right", colour: "--ink2" });
    text(context, "along [mm]", [14, head.top + head.height / 2], { size: 11, align: "center", colour: "--ink2", turned: true });
    text(context, `← to the ${toField > 0 ? "field" : "gauge"} side`, [head.left, foot + 30], { size: 11, colour: "--ink2" });
    text(context, "distance from the rail's middle [mm]", [(left + right) / 2, foot + 30], { size: 11, colour: "--ink2", align: "center" });
    text(context, `to the ${toField > 0 ? "gauge" : "field"} side →`, [head.left + head.width, foot + 30], { size: 11, colour: "--ink2", align: "right" });
  }
  const goes = fromField(layout, isNarrow ? 0.08 : 0.07), words: TextStyle = { bold: true, size: 12.5, align: beginOf(toField) };
  arrows(context, [[[goes, foot - 6], [goes, head.top + 8]]], "--ui", 3, 11);
  text(context, "rolls", [goes + 10 * toField, head.top + head.height / 2 - 2], words);
  if (!isNarrow) text(context, "this way", [goes + 10 * toField, head.top + head.height / 2 + 13], words);
  drawYaw(context, scene, layout);
  context.save();
  context.beginPath();
  context.rect(head.left, head.top, head.width, head.height);
  context.clip();
  for (const patch of scene.patches) drawPatch(context, patch.sheets, patchPlace(place, patch), { scale: scaleOf(scene.patches.flatMap(({ sheets }) => sheets), "pressure") });
  context.restore();
}

function drawYaw(context: CanvasRenderingContext2D, { yaw }: Scene, layout: Layout): void {
  const { foot, tip } = yawHandle(layout, yaw), straight = yawHandle(layout, 0).tip, size = Math.abs(1e3 * yaw).toFixed(1);
  line(context, [foot, straight], "--ui", 1.3, [4, 3]);
  arrows(context, [[foot, tip]], "--ui", 3, 10);
  dot(context, tip, 6.5, "--ui", 2);
  if (layout.isNarrow) return;
  const { toField } = layout, at: Point = [foot[0] + 24 * toField, foot[1] - 34], align = beginOf(toField);
  text(context, "wheel points", at, { align });
  text(context, yaw === 0 ? "straight ahead" : `${size} mrad ${yaw > 0 ? "left" : "right"}`, [at[0], at[1] + 15], { align });
  text(context, "(drawn × 50)", [at[0], at[1] + 29], { size: 11, colour: "--ink2", align });
}

function drawLens(context: CanvasRenderingContext2D, scene: Scene, layout: Layout, place: Place): void {
  const { lens, legend, isNarrow, scale } = layout, frame = lensFrame(scene.patches, layout.lens), sheets = scene.patches.flatMap(({ sheets: of }) => of);
  const friction = scaleOf(sheets, "friction"), largest = friction.largest;
  const inside: Box = { left: lens.left + 1, top: lens.top + 1, width: lens.width - 2, height: lens.height - 2 };
  if (frame) {
    const { pixels } = frame, [cx, cy] = place.at(frame.x, frame.y), half = [(lens.width / 2 / pixels) * scale, (lens.height / 2 / pixels) * scale] as const;
    const box: Box = { left: cx - half[0], top: cy - half[1], width: 2 * half[0], height: 2 * half[1] };
    context.save();
    context.strokeStyle = token("--ui");
    context.lineWidth = 1.6;
    context.strokeRect(box.left, box.top, box.width, box.height);
    context.restore();
    if (isNarrow) line(context, [[box.left, box.top + box.height], [lens.left, lens.top]], "--ui", 1.2);
    else line(context, [[box.left + box.width, box.top], [lens.left, layout.above.top + 4]], "--ui", 1.2); // clear of the section
    line(context, [[box.left + box.width, box.top + box.height], isNarrow ? [lens.left + lens.width, lens.top] : [lens.left, lens.top + lens.height]], "--ui", 1.2);
    context.save();
    context.beginPath();
    context.roundRect(inside.left, inside.top, inside.width, inside.height, 8);
    context.fillStyle = token("--panel");
    context.fill();
    context.clip();
    const big = turned([lens.left + lens.width / 2 + frame.y * pixels, lens.top + lens.height / 2 + frame.x * pixels], pixels);
    for (const patch of scene.patches) drawPatch(context, patch.sheets, patchPlace(big, patch), { scale: friction, spacing: isNarrow ? 22 : 25, largestArrow: largest });
    for (const patch of scene.compared?.patches ?? []) strokeOutline(context, patch.sheets, patchPlace(big, patch), "--ink3", 1.6, [5, 4]);
    context.restore();
    drawLensAxes(context, layout, pixels);
    const times = pixels / scale;
    if (!isNarrow) {
      text(context, `The contact patch${scene.patches.length > 1 ? "es" : ""}, ${times.toFixed(times < 3 ? 1 : 0)} times larger`, [legend[0], legend[1] + 4], { size: 14.5, bold: true });
      text(context, "seen from above, turned as at the left", [legend[0], legend[1] + 22], { colour: "--ink2" });
      text(context, "Friction per area, on the wheel [MPa]", [legend[0], legend[1] + 42], { bold: true, size: 12.5 });
    } else text(context, "friction, MPa", [legend[0] - 14, legend[1]], { bold: true });
    drawScale(context, { left: legend[0] - (isNarrow ? 14 : 0), top: legend[1] + (isNarrow ? 8 : 50), width: isNarrow ? lens.width - 26 : Math.min(230, lens.width - 20) }, { ...friction, unit: "" });
    const round = roundLength(largest), y = legend[1] + (isNarrow ? 62 : 104), x = legend[0] - (isNarrow ? 14 : 0);
    arrows(context, [[[x, y], [x + (0.92 * 25 * round) / largest, y]]], "--arrow", 1.35, 5.5);
    text(context, `${digits(round / 1e6)} MPa`, [x + 30, y + 4]);
    line(context, [[x + (isNarrow ? 0 : 92), y + (isNarrow ? 20 : 0)], [x + (isNarrow ? 24 : 116), y + (isNarrow ? 20 : 0)]], "--ink", 2.4);
    text(context, isNarrow ? "border" : "border of both areas", [x + (isNarrow ? 30 : 122), y + (isNarrow ? 24 : 4)]);
    const pressure = scaleOf(sheets, "pressure");
    if (!isNarrow) {
      text(context, "Small picture: pressure", [x, y + 26]);
      drawScale(context, { left: x + 152, top: y + 17, width: Math.max(60, lens.width - 184) }, { ...pressure, unit: "MPa" });
    } else text(context, `up to ${digits(Math.round(pressure.largest / 1e6))} MPa pressure`, [x, y + 46], { size: 11 });
  }
  context.save();
  context.beginPath();
  context.roundRect(lens.left, lens.top, lens.width, lens.height, 8);
  context.strokeStyle = token("--ui");
  context.lineWidth = 1.6;
  context.stroke();
  context.restore();
  if (!frame) text(context, scene.isComputing ? "computing …" : "no contact", [lens.left + lens.width / 2, lens.top + lens.height / 2], { align: "center", colour: "--ink2" });
}

function drawLensAxes(context: CanvasRenderingContext2D, { lens, isNarrow }: Layout, pixels: number): void {
  if (isNarrow) {
    const length = roundLength((0.4 * lens.width) / pixels);
    line(context, [[lens.left + 10, lens.top + lens.height - 10], [lens.left + 10 + length * pixels, lens.top + lens.height - 10]], "--ink", 2);
    text(context, `${label(1e3 * length)} mm`, [lens.left + 10, lens.top + lens.height - 15], { size: 11, halo: true });
    return;
  }
  const [wide, high] = [lens.width / 2 / pixels, lens.height / 2 / pixels], [cx, cy] = [lens.left + lens.width / 2, lens.top + lens.height / 2];
  for (const y of ticks(-1e3 * wide, 1e3 * wide, lens.width / 45)) text(context, String(Math.abs(y)), [cx + (y / 1e3) * pixels, lens.top + lens.height + 14], { size: 11, align: "center", colour: "--ink2" });
  for (const x of ticks(-1e3 * high, 1e3 * high, lens.height / 45)) text(context, label(x), [lens.left + lens.width + 22, cy - (x / 1e3) * pixels + 4], { size: 11, align: "right", colour: "--ink2" });
  text(context, "mm", [lens.left + lens.width + 24, lens.top + lens.height + 28], { size: 11, align: "right", colour: "--ink2" });
}

export function drawScene(canvas: HTMLCanvasElement, scene: Scene): Layout | undefined {
  if (canvas.clientWidth === 0) return undefined;
  const layout = layOut(canvas.clientWidth, scene.rail, scene.side);
  canvas.style.height = `${String(Math.round(layout.height))}px`;
  const { context } = fitToScreen(canvas), place = abovePlace(layout);
  drawSection(context, scene, layout);
  drawAbove(context, scene, layout, place);
  drawLens(context, scene, layout, place);
  const at = sectionPlace(layout), { above: head } = layout;
  for (const { place_x, place_y, place_z } of layout.isNarrow ? [] : scene.patches) {
    const [x, y] = at(place_y, place_z), [, low] = place.at(place_x, place_y);
    line(context, [[x, y + 8], [x, Math.min(low - 34, head.top + head.height)]], "--ink3", 1, [4, 4]);
  }
  return layout;
}

/** What the friction and the pressure at a place of the lens are, in words; undefined beside the patches. */
export function valuesAt({ lens }: Layout, { patches }: Scene, point: Point): string | undefined {
  const frame = lensFrame(patches, lens);
  if (!frame || !inBox(lens, point)) return undefined;
  const { pixels } = frame;
  const big = turned([lens.left + lens.width / 2 + frame.y * pixels, lens.top + lens.height / 2 + frame.x * pixels], pixels);
  for (const patch of patches)
    for (const sheet of patch.sheets) {
      const values = sheet.at(...(patchPlace(big, patch).back(point[0], point[1]) as [number, number]));
      if (values) return `here: pressure ${digits(Math.round(values.pressure / 1e6))} MPa, friction ${digits(Math.round(valueOf(values, "friction") / 1e6))} MPa, ${values.mark < 0 ? "sticks" : "slides"}`;
    }
  return undefined;
}

export interface Side { outline: { rail: Outline; wheel: Outline }; patches: Patch[]; words: string[] }
export interface Pair { left: Side | undefined; right: Side | undefined; lateral: number; gauge: number }

/** Both wheels of the set, profiles to scale, the track shortened. */
export function drawPair(canvas: HTMLCanvasElement, { left, right, lateral, gauge }: Pair): void {
  const width = canvas.clientWidth;
  if (width === 0) return;
  const isNarrow = width < 780, scale = isNarrow ? 0.44 * width / 0.14 : Math.min((0.235 * width) / 0.14, 1900), top = 22 + 0.02 * scale;
  const centres = isNarrow ? [0.24 * width, 0.76 * width] : [0.305 * width, 0.695 * width];
  const foot = top + 0.036 * scale, height = isNarrow ? foot + 148 : foot + 34;
  canvas.style.height = `${String(Math.round(height))}px`;
  const { context } = fitToScreen(canvas), axle: Box = { left: centres[0]!, top: 18, width: centres[1]! - centres[0]!, height: 0.014 * scale };
  context.fillStyle = token("--well");
  context.strokeStyle = token("--line2");
  context.fillRect(axle.left, axle.top, axle.width, axle.height);
  context.strokeRect(axle.left, axle.top, axle.width, axle.height);
  const most = Math.max(...[left, right].flatMap((side) => (side?.patches ?? []).map(({ normal_force }) => normal_force)), 1);
  [left, right].forEach((side, k) => {
    if (!side) return;
    const middle = middleOf(side.outline.rail), at = (y: number, z: number): Point => [centres[k]! - (y - middle) * scale, top - z * scale];
    const points = (outline: Outline) => pixelsOf(outline, at);
    context.save();
    context.beginPath();
    context.rect(centres[k]! - 0.08 * scale, 6, 0.16 * scale, foot);
    context.clip();
    drawBody(context, points(side.outline.rail), foot, "--rail", false);
    drawBody(context, points(side.outline.wheel), 14, "--wheel", true);
    context.restore();
    for (const { normal_force, place_y, place_z, angle } of side.patches) {
      const from = at(place_y, place_z), size = (0.016 * scale * normal_force) / most;
      arrows(context, [[from, [from[0] + size * Math.sin(angle), from[1] - size * Math.cos(angle)]]], "--ink", 2.4, 9, true);
      dot(context, from, 3.5, "--ink", 1);
    }
    side.words.forEach((words, i) => {
      const isLeft = k === 0, x = isNarrow ? centres[k]! : isLeft ? 4 : width - 4;
      text(context, words, [x, isNarrow ? foot + 44 + 16 * i : 28 + 17 * i], { align: isNarrow ? "center" : isLeft ? "left" : "right", bold: i === 0, size: isNarrow ? 11.5 : 12 });
    });
  });
  const centre = width / 2, drawn = 4, moved = centre - drawn * lateral * scale;
  line(context, [[centre, axle.top - 6], [centre, foot + 4]], "--ink3", 1, [4, 4]);
  dot(context, [moved, axle.top + axle.height / 2], 5, "--ui", 2);
  if (isNarrow) return;
  const size = Math.abs(1e3 * lateral).toFixed(1);
  text(context, lateral === 0 ? "wheelset in the middle" : `wheelset ${size} mm to the ${lateral > 0 ? "left" : "right"}`, [centre, axle.top + axle.height + 24], { align: "center", halo: true });
  text(context, "(offset drawn × 4)", [centre, axle.top + axle.height + 39], { size: 11, align: "center", colour: "--ink2", halo: true });
  const inner = 0.0367 * scale, y = foot + 18;
  arrows(context, [[[centre, y], [centres[0]! + inner, y]], [[centre, y], [centres[1]! - inner, y]]], "--ink2", 1, 7);
  text(context, `gauge ${label(Math.round(1e4 * gauge) / 10)} mm`, [centre, y + 4], { align: "center", halo: true });
}
