// What an axis of a chart covers.

import uPlot from "uplot";

/** The range of an axis. Numbers that differ by rounding alone are drawn as equal ones: an axis has no steps that small. */
export function axisRange(low: number | null, high: number | null): uPlot.Range.MinMax {
  if (low === null || high === null) return [null, null];
  const middle = (low + high) / 2, rounding = 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  return high - low > rounding ? uPlot.rangeNum(low, high, 0.1, true) : uPlot.rangeNum(middle, middle, 0.1, true);
}
