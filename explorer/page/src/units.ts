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

/** SI value of "80 kN", "80" (in `unit`), "inf"; or why it is none. */
export function parse(text: string, si: string, unit: string): number | string {
  const trimmed = text.trim().replace(/^([+-]?[\d.]+),(\d+)/, "$1.$2");
  if (trimmed === "") return "needs a number";
  const match = /^([+-]?(?:inf|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?))\s*(\S*)$/i.exec(trimmed);
  if (!match) return `"${text}" is not a number`;
  const number = Number(match[1]!.toLowerCase().replace("inf", "Infinity")), value = toSi(number, si, match[2] === "" ? unit : match[2]!);
  return Number.isNaN(value) ? `"${match[2]!}" is not one of its units: ${Object.keys(unitsFor(si)).join(", ")}` : value;
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
