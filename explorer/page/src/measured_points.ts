// Measured creep curves: the CSV of `microslip fit`, of which the page takes creepages and forces or adhesion coefficients.

import { toSi } from "./units.ts";

export interface MeasuredPoints { variable: "creepage_longitudinal" | "creepage_lateral"; creepages: number[]; forces: number[]; runs: string[] }

/** The unit in the heading of a column, as "force [kN]"; SI where there is none. */
function columnOf(heads: string[], name: string): { index: number; unit: string | undefined } | undefined {
  const index = heads.findIndex((head) => head.replace(/\s*\[.*\]$/, "") === name);
  return index < 0 ? undefined : { index, unit: /\[(.*)\]$/.exec(heads[index]!)?.[1] };
}

/** Coefficients become forces by the load [N] of the case where the file has none. Throws an Error that says why it is no such file. */
export function readPoints(text: string, load: number): MeasuredPoints {
  const lines = text.split(/\r?\n/).map((line, i) => ({ line: line.trim(), number: i + 1 })).filter(({ line }) => line !== "" && !line.startsWith("#"));
  const heads = (lines[0]?.line ?? "").split(/[,;\t]/).map((head) => head.trim());
  const variable = (["creepage_longitudinal", "creepage_lateral"] as const).find((name) => columnOf(heads, name));
  const size = columnOf(heads, "force") ?? columnOf(heads, "adhesion_coefficient"), isForce = columnOf(heads, "force") !== undefined;
  if (!variable || !size) throw new Error("has no columns creepage_longitudinal or creepage_lateral, and force or adhesion_coefficient");
  const creepage = columnOf(heads, variable)!, loads = columnOf(heads, "normal_force"), runs = columnOf(heads, "run");
  const found: MeasuredPoints = { variable, creepages: [], forces: [], runs: [] };
  for (const { line, number } of lines.slice(1)) {
    const cells = line.split(/[,;\t]/).map((cell) => cell.trim());
    const si = ({ index, unit }: { index: number; unit: string | undefined }, of: string) => toSi(cells[index] ? Number(cells[index]) : NaN, of, unit ?? (of === "-" ? "" : of));
    const value = si(creepage, "-"), pressed = loads ? si(loads, "N") : load, force = isForce ? si(size, "N") : si(size, "-") * pressed;
    if (!Number.isFinite(value) || !Number.isFinite(force)) throw new Error(`line ${String(number)}: "${line}" has no creepage and force`);
    found.creepages.push(value);
    found.forces.push(force);
    found.runs.push(runs ? cells[runs.index] ?? "" : "");
  }
  if (found.creepages.length === 0) throw new Error("has no points");
  const resists = found.forces.filter((force, k) => force * found.creepages[k]! < 0).length >= found.forces.length / 2;
  if (!resists) found.forces = found.forces.map((force) => -force); // in the sign of the page, which resists the slip
  return found;
}
