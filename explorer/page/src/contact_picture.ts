// The contact from above with its axes, and on the same axes what friction does along and across two cuts.

import { arrows, dot, fitToScreen, label, line, roundLength, text, ticks, type Box, type Point } from "./canvas.ts";
import { token } from "./colours.ts";
import { drawAxes, drawPatch, drawRolling, drawScale, isByState, scaleOf, strokeBorder, strokeOutline, upright, valueOf, type Place, type Shown } from "./field_map.ts";
import { quantities, type Sheet } from "./sheet.ts";
import { digits } from "./units.ts";

export interface ContactScene {
  sheets: Sheet[]; // of the theory that is shown
  other: Sheet[] | undefined; // of FASTSIM2 beside the exact theory, or the other way round
  isExact: boolean;
  compared: Sheet[] | undefined;
  ellipse: { a: number; b: number };
  shown: Shown;
  cut: { x: number; y: number }; // through which the cuts go [m]
}
export interface ContactLayout { place: Place; map: Box; along: Box; across: Box; height: number }

const spacing = 28;

function layOut(width: number, { a, b }: ContactScene["ellipse"]): ContactLayout {
  const isNarrow = width < 520, left = isNarrow ? 38 : 56, side = isNarrow ? 0 : Math.min(128, 0.2 * width);
  const map: Box = { left, top: isNarrow ? 58 : 62, width: width - left - side - (isNarrow ? 6 : 26), height: 0 };
  const scale = Math.min((0.76 * map.width) / (2 * a), (isNarrow ? 190 : 300) / (2 * b));
  map.height = Math.max(2 * b * scale + 44, isNarrow ? 120 : 190);
  const along: Box = { left, top: map.top + map.height + 68, width: map.width, height: isNarrow ? 80 : 130 };
  return {
    map, along, across: { left: map.left + map.width + 16, top: map.top, width: side, height: map.height },
    place: upright([map.left + map.width / 2, map.top + map.height / 2], [scale, scale]), height: along.top + along.height + 24,
  };
}

interface Sample { at: number; friction: number; bound: number; slides: boolean }

function alongCut(sheets: readonly Sheet[], y: number): Sample[] {
  return sheets.flatMap((sheet) => {
    const chord = sheet.chordAt(y), q = (name: (typeof quantities)[number], i: number) => chord!.values[quantities.indexOf(name)]![i]!;
    return chord ? Array.from({ length: sheet.places + 1 }, (_, i): Sample => ({
      at: chord.left + ((chord.right - chord.left) * i) / sheet.places, friction: Math.hypot(q("px", i), q("py", i)), bound: q("bound", i), slides: q("mark", i) >= 0,
    })) : [];
  });
}

function acrossCut(sheets: readonly Sheet[], x: number): Sample[] {
  return sheets.flatMap((sheet) => Array.from({ length: 121 }, (_, i): Sample[] => {
    const y = sheet.bottom + ((sheet.top - sheet.bottom) * i) / 120, values = sheet.at(x, y);
    return values ? [{ at: y, friction: valueOf(values, "friction"), bound: values.bound, slides: values.mark >= 0 }] : [];
  }).flat());
}

/** Friction over a cut: what sticks and slides behind it, both theories, and what friction can bear. */
function drawCut(context: CanvasRenderingContext2D, { sheets, other, isExact }: ContactScene, cutOf: (sheets: readonly Sheet[]) => Sample[], at: (place: number, friction: number) => Point, isUpright: boolean, box: Box): Sample[] {
  const main = cutOf(sheets);
  for (let i = 0; i + 1 < main.length; ++i) {
    const [from, to] = [at(main[i]!.at, 0), at(main[i + 1]!.at, 0)];
    context.fillStyle = token(main[i]!.slides ? "--slide-soft" : "--stick-soft");
    if (isUpright) context.fillRect(box.left, Math.min(from[1], to[1]) - 0.3, box.width, Math.abs(to[1] - from[1]) + 0.6);
    else context.fillRect(from[0] - 0.3, box.top, to[0] - from[0] + 0.6, box.height);
  }
  const draw = (samples: Sample[], of: (sample: Sample) => number, colour: string, width: number, dash: number[] = []) => { line(context, samples.map((sample) => at(sample.at, of(sample))), colour, width, dash); };
  draw(main, ({ bound }) => bound, "--ink3", 1.3, [2, 3]);
  if (other) draw(cutOf(other), ({ friction }) => friction, isExact ? "--fastsim2" : "--exact", 2, isExact ? [6, 4] : []);
  draw(main, ({ friction }) => friction, isExact ? "--exact" : "--fastsim2", 2.2, isExact ? [] : [6, 4]);
  return main;
}

function handle(context: CanvasRenderingContext2D, [x, y]: Point, words: string): void {
  context.beginPath();
  context.roundRect(x - 26, y - 11, 52, 22, 11);
  context.fillStyle = token("--panel");
  context.fill();
  context.strokeStyle = token("--ui");
  context.lineWidth = 1.4;
  context.stroke();
  text(context, words, [x, y + 4], { align: "center", size: 11.5 });
}

/** Words on the areas, where they are large enough. */
function nameAreas(context: CanvasRenderingContext2D, sheets: readonly Sheet[], { at, scale }: Place): void {
  for (const [word, isWanted] of [["slides", (mark: number) => mark >= 0], ["sticks", (mark: number) => mark < 0]] as const) {
    let best: { from: number; to: number; y: number; rating: number } | undefined;
    const whole = sheets.reduce((most, sheet) => Math.max(most, ...sheet.chords.map(({ left, right }) => right - left)), 0);
    for (const sheet of sheets)
      for (const { y, left, right, values } of sheet.chords) {
        const marks = values[quantities.indexOf("mark")]!, x = (i: number) => left + ((right - left) * i) / sheet.places;
        for (let i = 0, from = 0; i <= marks.length; ++i) {
          if (i < marks.length && isWanted(marks[i]!)) continue;
          const rating = i > from ? x(i - 1) - x(from) - 0.25 * Math.abs(y) : 0;
          if (rating > (best?.rating ?? 0.18 * whole)) best = { from: x(from), to: x(i - 1), y, rating };
          from = i + 1;
        }
      }
    if (best && (best.to - best.from) * scale[0] > 46) text(context, word, at((best.from + best.to) / 2, best.y) as [number, number], { bold: true, size: 13, align: "center", halo: true });
  }
}

function drawFrame(context: CanvasRenderingContext2D, scene: ContactScene, { map, place }: ContactLayout, isNarrow: boolean): void {
  const scale = scaleOf(scene.sheets, scene.shown), friction = scaleOf(scene.sheets, "friction").largest, round = roundLength(friction);
  drawScale(context, { left: isNarrow ? 4 : map.left, top: 4, width: isNarrow ? 150 : 220 }, scale);
  const from = isNarrow ? 200 : map.left + 268;
  drawRolling(context, [from, 12], isNarrow ? 44 : 54);
  if (isNarrow) return;
  if (isByState(scene.shown)) arrows(context, [[[from + 116, 12], [from + 116 + (0.92 * spacing * round) / friction, 12]]], "--arrow", 1.35, 5.5);
  if (isByState(scene.shown)) {
    text(context, `${digits(round / 1e6)} MPa on the wheel`, [from + 148, 16]);
    line(context, [[from + 116, 32], [from + 138, 32]], "--ink", 2.4);
    text(context, "border between both", [from + 148, 36]);
  }
  const middle = place.at(0, 0)[1], [trailing] = place.at(-scene.ellipse.a, 0), [leading] = place.at(scene.ellipse.a, 0);
  if (trailing - map.left < 58) return;
  ["trailing", "edge: steel", "leaves"].forEach((words, i) => { text(context, words, [trailing - 8, middle - 34 + 14 * i], { size: 11, align: "right", colour: "--ink2", halo: true }); });
  ["leading", "edge: steel", "comes in"].forEach((words, i) => { text(context, words, [leading + 8, middle - 34 + 14 * i], { size: 11, colour: "--ink2", halo: true }); });
}

export function drawContact(canvas: HTMLCanvasElement, scene: ContactScene): ContactLayout | undefined {
  if (canvas.clientWidth === 0) return undefined;
  const width = canvas.clientWidth, layout = layOut(width, scene.ellipse), isNarrow = width < 520, { place, map, along, across } = layout;
  canvas.style.height = `${String(Math.round(layout.height))}px`;
  const { context } = fitToScreen(canvas);
  drawAxes(context, map, place, { xLabel: isNarrow ? "" : "x, along the rail [mm]", yLabel: isNarrow ? "" : "y, across [mm]" });
  drawPatch(context, scene.sheets, place, { scale: scaleOf(scene.sheets, scene.shown), ...(["slip", "pressure", "px", "py"].includes(scene.shown) ? {} : { spacing: isNarrow ? 22 : spacing }) });
  if (isByState(scene.shown)) nameAreas(context, scene.sheets, place);
  if (scene.compared) {
    strokeOutline(context, scene.compared, place, "--ink3", 1.6, [5, 4]);
    strokeBorder(context, scene.compared, place, "--ink3");
  }
  drawFrame(context, scene, layout, isNarrow);
  const [cutX, cutY] = place.at(scene.cut.x, scene.cut.y), right = map.left + map.width;
  line(context, [[map.left, cutY], [right, cutY]], "--ui", 1.4, [5, 4]);
  if (!isNarrow) line(context, [[cutX, map.top], [cutX, map.top + map.height]], "--ui", 1.4, [5, 4]);
  handle(context, [right - 28, cutY], "↕ cut");
  if (!isNarrow) handle(context, [cutX, map.top + 12], "↔ cut");
  const most = 1.08 * Math.max(...[...alongCut(scene.sheets, scene.cut.y), ...acrossCut(scene.sheets, scene.cut.x), ...alongCut(scene.other ?? [], scene.cut.y)].map(({ friction, bound }) => Math.max(friction, bound)), 1);
  const low = along.top + along.height, alongAt = (x: number, friction: number): Point => [place.at(x, 0)[0], low - (along.height * friction) / most];
  text(context, `Along the cut at y = ${label(Number((1e3 * scene.cut.y).toFixed(1)))} mm`, [along.left, along.top - 12], { bold: true, size: 12.5 });
  if (!isNarrow) text(context, "friction force per area [MPa]", [along.left + along.width, along.top - 12], { colour: "--ink2", align: "right" });
  drawCut(context, scene, (sheets) => alongCut(sheets, scene.cut.y), alongAt, false, along);
  for (const value of ticks(0, most / 1e6, along.height / 34)) {
    const [, y] = alongAt(0, value * 1e6);
    line(context, [[along.left, y], [along.left + along.width, y]], "--line");
    text(context, label(value), [along.left - 6, y + 4], { size: 11, align: "right", colour: "--ink2" });
  }
  if (!isNarrow) {
    const beside = across.left, names = [[scene.isExact ? "exact" : "FASTSIM2", scene.isExact ? "--exact" : "--fastsim2"], ...(scene.other ? [[scene.isExact ? "FASTSIM2" : "exact", scene.isExact ? "--fastsim2" : "--exact"]] : []), ["most that", "--ink3"], ["friction bears", "--ink3"]] as [string, string][];
    names.forEach(([name, colour], i) => { text(context, `${i < (scene.other ? 2 : 1) ? "━ " : i === (scene.other ? 2 : 1) ? "┈ " : "   "}${name}`, [beside, along.top + 14 + 16 * i], { colour, size: 11.5, halo: true }); });
    const acrossAt = (y: number, friction: number): Point => [across.left + (across.width * friction) / most, place.at(0, y)[1]];
    drawCut(context, scene, (sheets) => acrossCut(sheets, scene.cut.x), acrossAt, true, across);
    line(context, [[across.left, across.top], [across.left, across.top + across.height]], "--line2");
    for (const value of ticks(0, most / 1e6, across.width / 60)) text(context, label(value), [acrossAt(0, value * 1e6)[0], across.top + across.height + 14], { size: 11, align: "center", colour: "--ink2" });
    text(context, `across, at x = ${label(Number((1e3 * scene.cut.x).toFixed(1)))}`, [across.left + across.width / 2, across.top - 8], { size: 11.5, align: "center", bold: true });
    text(context, "MPa", [across.left + across.width / 2, across.top + across.height + 30], { size: 11, align: "center", colour: "--ink2" });
  }
  return layout;
}

/** The same case by both theories, in the same colours and with the same arrows. */
export function drawTheories(canvas: HTMLCanvasElement, exact: Sheet[] | undefined, quick: Sheet[] | undefined, { a, b }: ContactScene["ellipse"]): void {
  const width = canvas.clientWidth;
  if (width === 0) return;
  const half = width / 2, scale = Math.min((0.86 * half) / (2 * a), 150 / (2 * b)), height = 2 * b * scale;
  canvas.style.height = `${String(Math.round(height + 64))}px`;
  const { context } = fitToScreen(canvas), both = [...(exact ?? []), ...(quick ?? [])], common = scaleOf(both, "friction");
  ([["exact theory", "--exact", exact], ["quick: FASTSIM2", "--fastsim2", quick]] as const).forEach(([name, colour, sheets], k) => {
    const middle = half * (k + 0.5), most = sheets && scaleOf(sheets, "friction").largest;
    text(context, name, [middle, 14], { bold: true, size: 12.5, align: "center", colour });
    if (sheets) drawPatch(context, sheets, upright([middle, 32 + height / 2], [scale, scale]), { scale: common, spacing: 20, largestArrow: common.largest });
    text(context, most === undefined ? "computing …" : `up to ${digits(Math.round(most / 1e6))} MPa`, [middle, height + 54], { align: "center", colour: "--ink2" });
  });
}

/** What is at a place of the picture, in words. */
export function contactValuesAt({ place }: ContactLayout, { sheets }: ContactScene, [px, py]: Point): string {
  const [x, y] = place.back(px, py);
  for (const sheet of sheets) {
    const values = sheet.at(x, y);
    if (values) return `at x = ${label(Number((1e3 * x).toFixed(2)))}, y = ${label(Number((1e3 * y).toFixed(2)))} mm: pressure ${digits(Math.round(values.pressure / 1e6))} MPa, friction ${digits(Math.round(valueOf(values, "friction") / 1e6))} MPa, ${values.mark < 0 ? "sticks" : "slides"}`;
  }
  return "";
}

/** Stresses below the contact on its x axis, with lines of equal stress and the highest one. */
export function drawStress(canvas: HTMLCanvasElement, { x, z, values, isSigned, a }: { x: number[]; z: number[]; values: number[]; isSigned: boolean; a: number }, colourOf: (t: number) => readonly [number, number, number]): void {
  const { context, width, height } = fitToScreen(canvas);
  if (width === 0) return;
  const box: Box = { left: 46, top: 30, width: width - 60, height: height - 66 }, nx = x.length, largest = Math.max(...values.map(Math.abs), 1);
  const raster = document.createElement("canvas");
  Object.assign(raster, { width: nx, height: z.length });
  const pixels = raster.getContext("2d")!, image = pixels.createImageData(nx, z.length);
  values.forEach((value, k) => { image.data.set([...colourOf(isSigned ? (1 + value / largest) / 2 : value / largest), 255], 4 * k); });
  pixels.putImageData(image, 0, 0);
  const step = x[1]! - x[0]!, scale = Math.min(box.width / (x.at(-1)! - x[0]! + step), box.height / (Math.abs(z.at(-1)!) + step / 2));
  const wide = scale * (x.at(-1)! - x[0]! + step), deep = scale * (Math.abs(z.at(-1)!) + step / 2), ofScale = 130, hasRoom = box.width - wide > ofScale + 40;
  const left = box.left + (box.width - wide - (hasRoom ? ofScale + 40 : 0)) / 2, middle = left + wide / 2;
  if (hasRoom) drawScale(context, { left: left + wide + 30, top: box.top + 4, width: ofScale - 24 }, { shown: isSigned ? "px" : "pressure", largest, unit: "MPa", factor: 1e-6 });
  context.save();
  context.imageSmoothingEnabled = true;
  context.imageSmoothingQuality = "high";
  context.drawImage(raster, left, box.top, wide, deep);
  context.restore();
  const at = (px: number, depth: number): Point => [left + (px - x[0]! + step / 2) * scale, box.top - depth * scale];
  line(context, [at(-a, 0), at(a, 0)], "--ink", 4);
  const inMpa = ticks(0, largest / 1e6, 6).filter((level) => level > 0 && 1e6 * level < 0.97 * largest);
  context.strokeStyle = token("--halo");
  context.globalAlpha = 0.75;
  for (const level of isSigned ? inMpa.flatMap((value) => [-value, value]) : inMpa) contour(context, { x, z, values }, 1e6 * level, at);
  context.globalAlpha = 1;
  const top = values.reduce((best, value, k) => (Math.abs(value) > Math.abs(values[best]!) ? k : best), 0), [mx, mz] = [x[top % nx]!, z[Math.floor(top / nx)]!], mark = at(mx, mz);
  dot(context, mark, 4, "--ink", 1);
  text(context, `${isSigned ? "largest" : "highest"}: ${digits(Math.round(values[top]! / 1e6))} MPa, ${(Math.abs(1e3 * mz)).toFixed(1)} mm deep`, [middle, 18], { bold: true, align: "center" });
  line(context, [[mark[0], mark[1] - 5], [middle, 22]], "--ink3");
  for (const px of ticks(1e3 * x[0]!, 1e3 * x.at(-1)!, wide / 60)) text(context, label(px), [at(px / 1e3, 0)[0], box.top + deep + 14], { size: 11, align: "center", colour: "--ink2" });
  for (const depth of ticks(0, -1e3 * z.at(-1)!, deep / 45)) text(context, label(depth), [left - 6, at(0, -depth / 1e3)[1] + 4], { size: 11, align: "right", colour: "--ink2" });
  text(context, `x [mm], rolls this way →; lines every ${label(inMpa.length > 1 ? inMpa[1]! - inMpa[0]! : largest / 1e6)} MPa`, [middle, box.top + deep + 30], { size: 11, align: "center", colour: "--ink2" });
  text(context, "depth [mm]", [left - 34, box.top + deep / 2], { size: 11, align: "center", colour: "--ink2", turned: true });
}

function contour(context: CanvasRenderingContext2D, { x, z, values }: { x: number[]; z: number[]; values: number[] }, level: number, at: (x: number, z: number) => Point): void {
  const nx = x.length, corner = (i: number, j: number) => ({ x: x[i]!, z: z[j]!, value: values[j * nx + i]! - level });
  context.beginPath();
  for (let j = 0; j + 1 < z.length; ++j)
    for (let i = 0; i + 1 < nx; ++i) {
      const around = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      const crossings = around.flatMap((from, k): Point[] => {
        const to = around[(k + 1) % 4]!;
        if (from.value < 0 === to.value < 0) return [];
        const t = from.value / (from.value - to.value);
        return [at(from.x + t * (to.x - from.x), from.z + t * (to.z - from.z))];
      });
      for (let k = 0; k + 1 < crossings.length; k += 2) {
        context.moveTo(...(crossings[k] as [number, number]));
        context.lineTo(...(crossings[k + 1] as [number, number]));
      }
    }
  context.lineWidth = 1;
  context.stroke();
}
