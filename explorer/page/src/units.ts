// Numbers with units, as people type and read them. The core's numbers are SI, "-" without a unit.

import { unitsFor, type Scale } from "./description.ts";

/** In which unit fields show numbers, unless they name another one. */
const shown: Record<string, string> = { m: "mm", N: "kN", Pa: "GPa", "m/s": "km/h", rad: "mrad", "-": "" };

export function shownUnit(si: string): string {
  return shown[si] ?? si;
}

function scale(si: string, unit: string): Scale | undefined {
  return unit === (si === "-" ? "" : si) ? [1, 1] : unitsFor(si)[unit];
}

/** A number in `unit` as one in SI. */
export function toSi(value: number, si: string, unit: string): number {
  const [times, over] = scale(si, unit) ?? [NaN, NaN];
  return (value * times) / over;
}
export function fromSi(value: number, si: string, unit: string): number {
  const [times, over] = scale(si, unit) ?? [NaN, NaN];
  return (value * over) / times;
}

/** Per mille, which people write for creepages and slopes, in parts of one. */
const perMille = /^(permille|\u2030)$/i;
/** Units that may be typed behind a number, in words. */
export function typedUnits(si: string): string {
  const own = Object.keys(unitsFor(si));
  if (si === "rad") own.push("slopes as 1:40");
  if (si === "1/m") own.push("radii as R 300 m");
  if (si === "-") own.push("permille");
  return own.join(", ");
}

/** A slope "1:40" of an angle, a radius "R 300 m" of a curvature; undefined for other texts. */
function parseRatio(text: string, si: string): number | undefined {
  const slope = si === "rad" ? /^([+-]?)1\s*:\s*(\d+\.?\d*)$/.exec(text) : null;
  if (slope && Number(slope[2]) > 0) return (slope[1] === "-" ? -1 : 1) * Math.atan(1 / Number(slope[2]));
  const radius = si === "1/m" ? /^R\s*=?\s*([+-]?\d+\.?\d*)\s*(\S*)$/i.exec(text) : null;
  return radius ? 1 / toSi(Number(radius[1]), "m", radius[2] || "m") : undefined;
}

/** SI value of "80 kN", "80" (in `unit`), "inf", "1:40", "R 300 m", "2 permille"; or why it is none. */
export function parse(text: string, si: string, unit: string): number | string {
  const trimmed = text.trim().replace(/^([+-]?[\d.]+),(\d+)/, "$1.$2").replace("\u2212", "-");
  if (trimmed === "") return "needs a number";
  const ratio = parseRatio(trimmed, si);
  if (ratio !== undefined && Number.isFinite(ratio)) return ratio;
  const match = /^([+-]?(?:inf|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?))\s*(\S*)$/i.exec(trimmed);
  if (!match) return `"${text}" is not a number`;
  const number = Number(match[1]!.toLowerCase().replace("inf", "Infinity"));
  if (si === "-" && perMille.test(match[2]!)) return number / 1000;
  const value = toSi(number, si, match[2] === "" ? unit : match[2]!);
  return Number.isNaN(value) ? `"${match[2]!}" is not one of its units: ${typedUnits(si)}` : value;
}

/** Four digits, no noise. */
export function digits(value: number): string {
  if (value === Infinity) return "inf";
  if (value === -Infinity) return "-inf";
  return Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "–";
}

export function show(value: number, si: string, unit: string): string {
  return digits(fromSi(value, si, unit));
}
