// Numbers with units, as people type and read them. The core's numbers are SI.

/** Factor to SI of each unit, by the kind of quantity. */
const units = {
  length: { mm: 1e-3, m: 1, um: 1e-6, cm: 1e-2, in: 0.0254 },
  force: { kN: 1e3, N: 1, MN: 1e6 },
  stress: { GPa: 1e9, MPa: 1e6, Pa: 1 },
  speed: { "km/h": 1 / 3.6, "m/s": 1 },
  spin: { "1/m": 1, "1/mm": 1e3 },
  angle: { mrad: 1e-3, rad: 1, deg: Math.PI / 180 },
  number: { "": 1, "%": 1e-2 },
} satisfies Record<string, Record<string, number>>;

export type Kind = keyof typeof units;

export function factor(kind: Kind, unit: string): number {
  return (units[kind] as Record<string, number>)[unit] ?? NaN;
}

/** SI value of "80 kN", "80" (in `unit`), "inf"; or why it is none. */
export function parse(text: string, kind: Kind, unit: string): number | string {
  const trimmed = text.trim().replace(/^([+-]?[\d.]+),(\d+)/, "$1.$2");
  if (trimmed === "") return "needs a number";
  const match = /^([+-]?(?:inf|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?))\s*(\S*)$/i.exec(trimmed);
  if (!match) return `"${text}" is not a number`;
  const number = match[1]!.toLowerCase().replace("inf", "Infinity");
  const to = factor(kind, match[2] === "" ? unit : match[2]!);
  if (Number.isNaN(to)) return `"${match[2]!}" is not one of its units: ${Object.keys(units[kind]).filter(Boolean).join(", ")}`;
  return Number(number) * to;
}

/** Four digits, no noise. */
export function digits(value: number): string {
  if (value === Infinity) return "inf";
  if (value === -Infinity) return "-inf";
  return Number.isFinite(value) ? String(Number(value.toPrecision(4))) : "–";
}

export function show(si: number, kind: Kind, unit: string): string {
  return digits(si / factor(kind, unit));
}
