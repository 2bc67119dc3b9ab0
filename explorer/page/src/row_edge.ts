// Where rows of elements end, so that pictures of a contact have none of the rows' steps. Between elements p^2 is linear in
// the distance to the edge to first order, as under Hertz's half-ellipsoid: two elements of a row tell where it ends.
// Beyond the last row the square of the contact's length is linear in y, as in an ellipse.

export interface RowFields { x: number[]; y: number[]; width: number[]; pressure: number[]; state: number[] }

/** Neighbouring elements in contact of a row, by rising x, and where contact ends on either side. */
export interface Run { cells: number[]; y: number; left: number; right: number }
/** Where contact begins and ends at a y. */
type Chord = readonly [y: number, left: number, right: number];

const leastReach = 0.02, mostReach = 1.1; // of an element or of a row, beyond the last centre
const tipParts = 6;

/** How many steps `apart` of a quantity that falls from `inner` to `outer` it takes to fall to zero. */
function steps(outer: number, inner: number): number {
  return Math.min(Math.max(outer / (inner - outer), leastReach), mostReach);
}

function run({ x, y, width, pressure }: RowFields, cells: number[]): Run {
  const reach = (outer: number, inner: number | undefined) => {
    const [p, q] = [pressure[outer]!, inner === undefined ? 0 : pressure[inner]!];
    return inner === undefined || q <= p ? width[outer]! / 2 : steps(p * p, q * q) * Math.abs(x[inner]! - x[outer]!);
  };
  const first = cells[0]!, last = cells.at(-1)!;
  return { cells, y: y[first]!, left: x[first]! - reach(first, cells[1]), right: x[last]! + reach(last, cells.at(-2)) };
}

/** Runs of all rows in contact, by rising y. */
export function runsOf(f: RowFields): Run[][] {
  const rows = new Map<number, number[]>();
  f.y.forEach((y, k) => {
    if (!rows.has(y)) rows.set(y, []);
    if (f.state[k] !== 0) rows.get(y)!.push(k);
  });
  return [...rows].sort(([one], [other]) => one - other).map(([, cells]) => {
    const runs: number[][] = [];
    for (const k of cells.sort((one, other) => f.x[one]! - f.x[other]!)) {
      const before = runs.at(-1)?.at(-1);
      const isNext = before !== undefined && f.x[k]! - f.x[before]! < 0.75 * (f.width[k]! + f.width[before]!);
      if (isNext) runs.at(-1)!.push(k); else runs.push([k]);
    }
    return runs.map((found) => run(f, found));
  });
}

/** Chords beyond the last row up to where contact ends; `height` is negative downwards. */
export function chordsBeyond(here: Run, before: Run | undefined, height: number): Chord[] {
  const length = (of: Run) => of.right - of.left;
  const rows = before && length(before) > length(here) ? steps(length(here) ** 2, length(before) ** 2) : 0.5;
  const middle = (here.left + here.right) / 2, half = length(here) / 2;
  return Array.from({ length: tipParts }, (_, i) => {
    const share = 1 - (i + 1) / tipParts; // of the chord; where its square is linear
    return [here.y + height * rows * (1 - share ** 2), middle - half * share, middle + half * share] as const;
  });
}

/** From where to where the row at y is in contact [m]; nothing where it is not. */
export function contactOfRow(f: RowFields, y: number): readonly [from: number, to: number] | undefined {
  const row = runsOf(f).find(([first]) => first?.y === y);
  return row && [row[0]!.left, row.at(-1)!.right];
}
