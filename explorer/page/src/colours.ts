// Colours that are told apart by the colour-blind: cividis for sizes, blue to orange for signed numbers, Okabe and Ito's for lines.

type Rgb = readonly [number, number, number];

/** Cividis (Nunez, Anderton & Renslow 2018), eight points of it. */
const sizes: readonly Rgb[] = [
  [0, 34, 78], [33, 60, 110], [75, 84, 108], [109, 107, 113], [143, 131, 120], [181, 158, 115], [219, 188, 96], [254, 232, 56],
];
const signed: readonly Rgb[] = [[0, 90, 160], [120, 170, 210], [240, 240, 240], [245, 180, 110], [200, 90, 0]];

function between(points: readonly Rgb[], t: number): string {
  const at = Math.min(Math.max(t, 0), 1) * (points.length - 1);
  const i = Math.min(Math.floor(at), points.length - 2), share = at - i;
  const [from, to] = [points[i]!, points[i + 1]!];
  return `rgb(${[0, 1, 2].map((k) => Math.round(from[k]! + share * (to[k]! - from[k]!))).join(",")})`;
}

/** t from 0 to 1. */
export const ofSize = (t: number): string => between(sizes, t);
/** t from -1 to 1. */
export const ofSigned = (t: number): string => between(signed, (t + 1) / 2);

export const exact = "#0072b2", fastsim2 = "#d55e00", table = "#009e73", accent = "#cc79a7", bound = "#8a8a8a";

/** Adhesion and slip; they differ in lightness as well. */
export const adhesion = "#9ec5e8", slip = "#e69f00";
