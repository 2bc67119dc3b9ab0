// Fields on rows of elements as continuous ones up to the edge of their contact, so that pictures have no steps: of
// neighbouring rows chords with values at even places between their ends, linear between chords. Where contact ends:
// row_edge.ts, or the ellipse that it has.

import { chordsBeyond, runsOf, type RowFields, type Run } from "./row_edge.ts";

/** What of the elements is drawn. */
export interface ElementFields extends RowFields { px: number[]; py: number[]; bound?: number[]; sx?: number[]; sy?: number[] }
/** Of each chord: pressure, the most that friction can bear, px, py, the size of slip, and a mark that is below zero where it sticks, above where it slides. */
export const quantities = ["pressure", "bound", "px", "py", "slip", "mark", "used"] as const;
export type Quantity = (typeof quantities)[number];
export type Values = Record<Quantity, number>;
interface Chord { y: number; left: number; right: number; values: Float64Array[] }
export interface Ellipse { a: number; b: number }

/** Of a field that is zero at the edge, as its square is linear there. */
const falls: Record<Quantity, boolean> = { pressure: true, bound: true, px: true, py: true, slip: false, mark: false, used: false };

/** How far from the border of adhesion and slip an element is: by the friction that is left, or by how fast it slides. */
function marks(f: ElementFields): number[] {
  const slips = f.x.map((_, k) => Math.hypot(f.sx?.[k] ?? 0, f.sy?.[k] ?? 0)), sliding = slips.filter((_, k) => f.state[k] === 2);
  const typical = sliding.reduce((sum, slip) => sum + slip, 0) / Math.max(sliding.length, 1);
  return f.x.map((_, k) => {
    const bound = f.bound?.[k] ?? 0;
    if (f.state[k] === 2) return typical > 0 ? Math.min(slips[k]! / typical, 1) + 0.01 : 0.5;
    return -Math.min(bound > 0 ? 1 - Math.hypot(f.px[k]!, f.py[k]!) / bound : 1, 1) - 0.01;
  });
}

function elementValues(f: ElementFields): Record<Quantity, number[]> {
  const size = (x: number[] | undefined, y: number[] | undefined) => f.x.map((_, k) => Math.hypot(x?.[k] ?? 0, y?.[k] ?? 0));
  const friction = size(f.px, f.py);
  return {
    pressure: f.pressure, bound: f.bound ?? f.pressure.map(() => 0), px: f.px, py: f.py, slip: size(f.sx, f.sy), mark: marks(f),
    used: friction.map((p, k) => ((f.bound?.[k] ?? 0) > 0 ? Math.min(p / f.bound![k]!, 1) : 0)),
  };
}

const all = quantities.map((_, q) => q);

type Piece = [[x: number, y: number], [x: number, y: number]];

export class Sheet {
  #border: Piece[] | undefined; // once it was asked for
  readonly left: number;
  readonly right: number;

  constructor(readonly chords: Chord[], readonly places: number, readonly ellipse?: Ellipse) {
    this.left = Math.min(...chords.map(({ left }) => left));
    this.right = Math.max(...chords.map(({ right }) => right));
  }

  get bottom(): number { return this.chords[0]!.y; }
  get top(): number { return this.chords.at(-1)!.y; }

  /** The chord at a height, of which values stand at even places, those of some rows only if so; undefined outside. */
  chordAt(y: number, rows: readonly number[] = all): Chord | undefined {
    const found = this.#around(y);
    if (!found) return undefined;
    const [one, other, t] = found, mix = (a: number, b: number) => a + t * (b - a), values: Float64Array[] = [];
    for (const q of rows) {
      const [from, to] = [one.values[q]!, other.values[q]!], mixed = values[q] = new Float64Array(from.length);
      for (let i = 0; i < mixed.length; ++i) mixed[i] = mix(from[i]!, to[i]!);
    }
    return { y, left: mix(one.left, other.left), right: mix(one.right, other.right), values };
  }

  /** The chords below and above a height, and how far it is from the one to the other. */
  #around(y: number): [Chord, Chord, number] | undefined {
    const { chords } = this;
    if (y < this.bottom || y > this.top) return undefined;
    let low = 0, high = chords.length - 1;
    while (high - low > 1) { const middle = (low + high) >> 1; if (chords[middle]!.y <= y) low = middle; else high = middle; }
    const [one, other] = [chords[low]!, chords[high]!];
    return [one, other, other.y > one.y ? (y - one.y) / (other.y - one.y) : 0];
  }

  /** Where a place of the contact is: between which chords, and how far along them; undefined outside. */
  #place(x: number, y: number): { one: Chord; other: Chord; t: number; s: number } | undefined {
    const found = this.#around(y);
    if (!found) return undefined;
    const [one, other, t] = found, left = one.left + t * (other.left - one.left), right = one.right + t * (other.right - one.right);
    return x < left || x > right ? undefined : { one, other, t, s: right > left ? ((x - left) / (right - left)) * this.places : 0 };
  }

  contains(x: number, y: number): boolean { return this.#place(x, y) !== undefined; }

  /** The values at a place of the contact; undefined outside. */
  at(x: number, y: number): Values | undefined {
    const found = this.#place(x, y);
    if (!found) return undefined;
    const { one, other, t, s } = found, mixed = (q: number) => between(one.values[q]!, s) + t * (between(other.values[q]!, s) - between(one.values[q]!, s));
    return Object.fromEntries(quantities.map((name, q) => [name, mixed(q)])) as Values;
  }

  /** All around, from the lowest chord; of an ellipse finer than its rows. */
  outline(): [x: number, y: number][] {
    if (this.ellipse) {
      const { a, b } = this.ellipse;
      return Array.from({ length: 120 }, (_, i): [number, number] => [-a * Math.sin((i * Math.PI) / 60), -b * Math.cos((i * Math.PI) / 60)]);
    }
    return [...this.chords.map(({ left, y }): [number, number] => [left, y]), ...[...this.chords].reverse().map(({ right, y }): [number, number] => [right, y])];
  }

  area(): number {
    return this.chords.slice(1).reduce((sum, { y, left, right }, j) => sum + ((right - left + this.chords[j]!.right - this.chords[j]!.left) / 2) * (y - this.chords[j]!.y), 0);
  }

  /** Pieces of the line between adhesion and slip. */
  border(): Piece[] { return (this.#border ??= this.#findBorder()); }

  #findBorder(): Piece[] {
    const { places, chords } = this, q = quantities.indexOf("mark"), pieces: Piece[] = [];
    const sticks = (j: number, i: number) => chords[j]!.values[q]![i]! < 0;
    const corner = (j: number, i: number) => {
      const { left, right, y, values } = chords[j]!;
      return { x: left + ((right - left) * i) / places, y, mark: values[q]![i]! };
    };
    for (let j = 0; j + 1 < chords.length; ++j)
      for (let i = 0; i < places; ++i) {
        const isStuck = sticks(j, i);
        if (isStuck === sticks(j, i + 1) && isStuck === sticks(j + 1, i + 1) && isStuck === sticks(j + 1, i)) continue;
        const around = [corner(j, i), corner(j, i + 1), corner(j + 1, i + 1), corner(j + 1, i)];
        const crossings = around.flatMap((from, k): [number, number][] => {
          const to = around[(k + 1) % 4]!;
          if (from.mark < 0 === to.mark < 0) return [];
          const t = from.mark / (from.mark - to.mark);
          return [[from.x + t * (to.x - from.x), from.y + t * (to.y - from.y)]];
        });
        for (let k = 0; k + 1 < crossings.length; k += 2) pieces.push([crossings[k]!, crossings[k + 1]!]);
      }
    return pieces;
  }
}

/** Values of a run of elements at even places between the ends of its chord. */
function valuesOf(f: ElementFields, of: Record<Quantity, number[]>, { cells, left, right }: Run, places: number): Float64Array[] {
  return quantities.map((name) => {
    const values = of[name], sampled = new Float64Array(places + 1);
    let k = 0;
    for (let i = 0; i <= places; ++i) {
      const x = left + ((right - left) * i) / places;
      while (k + 1 < cells.length && f.x[cells[k + 1]!]! <= x) ++k;
      const here = cells[k]!, next = cells[k + 1], from = f.x[here]!;
      const near = (edge: number) => values[here]! * (falls[name] ? Math.sqrt(Math.max(0, Math.min(1, (x - edge) / (from - edge || 1)))) : 1);
      if (x <= from) sampled[i] = near(left);
      else if (next === undefined) sampled[i] = near(right);
      else sampled[i] = values[here]! + ((x - from) / (f.x[next]! - from)) * (values[next]! - values[here]!);
    }
    return sampled;
  });
}

/** Marks of neighbouring chords at the same x evened out, so that the border has no steps of elements. */
function evened(chords: Chord[]): Chord[] {
  const q = quantities.indexOf("mark"), at = ({ left, right, values }: Chord, x: number) => (x < left || x > right ? undefined : between(values[q]!, ((x - left) / (right - left || 1)) * (values[q]!.length - 1)));
  return chords.map((chord, j) => {
    const before = chords[j - 1] ?? chord, after = chords[j + 1] ?? chord, { left, right } = chord;
    const marks = chord.values[q]!.map((value, i, { length }) => {
      const x = left + ((right - left) * i) / (length - 1);
      return ((at(before, x) ?? value) + 2 * value + (at(after, x) ?? value)) / 4;
    });
    return { ...chord, values: chord.values.map((values, k) => (k === q ? marks : values)) };
  });
}

/** Values of a chord at a place between its ends. */
function between(values: Float64Array, s: number): number {
  const i = Math.min(Math.max(Math.floor(s), 0), values.length - 2), t = Math.min(Math.max(s - i, 0), 1);
  return values[i]! + t * (values[i + 1]! - values[i]!);
}

/** Chords beyond the last row: what is zero at the edge falls with their length, all else stays what it is at the same x. */
function withTip(chords: Chord[], beyond: readonly (readonly [y: number, left: number, right: number])[]): Chord[] {
  const last = chords.at(-1)!, length = last.right - last.left;
  return beyond.map(([y, left, right]) => {
    const share = length > 0 ? (right - left) / length : 0;
    const values = last.values.map((of, q) => of.map((value, i) => {
      if (falls[quantities[q]!]) return share * value;
      return length > 0 ? between(of, (left - last.left + ((right - left) * i) / (of.length - 1)) * ((of.length - 1) / length)) : value;
    }));
    return { y, left, right, values };
  });
}

const tipParts = 6;
function ofEllipse({ a, b }: Ellipse, y: number, to: number): (readonly [number, number, number])[] {
  return Array.from({ length: tipParts }, (_, i) => {
    const share = 1 - (1 - (i + 1) / tipParts) ** 2, at = y + (to - y) * share, half = a * Math.sqrt(Math.max(0, 1 - (at / b) ** 2));
    return [at, -half, half] as const;
  });
}

/** The connected parts of a contact. `height` of a row; `ellipse`: its outline, where it is known. */
export function sheetsOf(f: ElementFields, height: number, ellipse?: Ellipse): Sheet[] {
  const rows = runsOf(f), of = elementValues(f), longest = Math.max(1, ...rows.flat().map(({ cells }) => cells.length)), places = Math.min(Math.max(2 * longest, 16), 96);
  const chains: Run[][] = [];
  for (const row of rows)
    for (const found of row) {
      const chain = chains.find((one) => {
        const last = one.at(-1)!;
        return last.y < found.y && found.y - last.y < 1.5 * height && last.left < found.right && last.right > found.left;
      });
      if (chain) chain.push(found); else chains.push([found]);
    }
  return chains.map((chain) => {
    const inside = ellipse ? chain.filter(({ y }) => Math.abs(y) < ellipse.b).map((run) => {
      const half = ellipse.a * Math.sqrt(1 - (run.y / ellipse.b) ** 2);
      return { ...run, left: -half, right: half };
    }) : chain;
    const chords = evened(evened(inside.map((run) => ({ y: run.y, left: run.left, right: run.right, values: valuesOf(f, of, run, places) }))));
    const first = inside[0]!, last = inside.at(-1)!;
    const upper = ellipse ? ofEllipse(ellipse, last.y, ellipse.b) : chordsBeyond(last, inside.at(-2), height);
    const lower = ellipse ? ofEllipse(ellipse, first.y, -ellipse.b) : chordsBeyond(first, inside[1], -height);
    return new Sheet([...withTip([...chords].reverse(), lower).reverse(), ...chords, ...withTip(chords, upper)], places, ellipse);
  }).filter(({ chords }) => chords.length > 1);
}
