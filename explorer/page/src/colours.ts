// Colours by their meaning: blue sticks, orange slides, lightness is the size of friction. Those of bodies, lines and texts
// are variables of the style sheet, light and dark; maps of sizes have nine points whose lightness in OKLab is straight.

export type Rgb = readonly [red: number, green: number, blue: number];

const rgb = (hex: string): Rgb => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)) as unknown as Rgb;

/** Whether the dark theme is shown. */
export const isDark = (): boolean => document.documentElement.dataset["theme"] === "dark";

const tokens = new Map<string, string>(); // of both themes
/** A variable of the style sheet, as "--ink". */
export function token(name: string): string {
  const key = `${isDark() ? "dark" : "light"}${name}`, known = tokens.get(key);
  if (known !== undefined) return known;
  const found = getComputedStyle(document.documentElement).getPropertyValue(name).trim() || "#888888";
  tokens.set(key, found);
  return found;
}

function toOklab(of: Rgb): Rgb {
  const [r, g, b] = of.map((byte) => (byte <= 10 ? byte / 255 / 12.92 : ((byte / 255 + 0.055) / 1.055) ** 2.4)) as unknown as Rgb;
  const [l, m, s] = [0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b, 0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b,
    0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b].map(Math.cbrt) as unknown as Rgb;
  return [0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s, 1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
    0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s];
}

function fromOklab([light, a, b]: Rgb): Rgb {
  const [l, m, s] = [light + 0.3963377774 * a + 0.2158037573 * b, light - 0.1055613458 * a - 0.0638541728 * b, light - 0.0894841775 * a - 1.291485548 * b]
    .map((root) => root ** 3) as unknown as Rgb;
  const linear = [4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s];
  return linear.map((value) => Math.round(255 * Math.min(Math.max(value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055, 0), 1))) as unknown as Rgb;
}

const steps = 256;
/** Evenly spaced colours, mixed in OKLab. */
function ramp(...points: string[]): Rgb[] {
  const marks = points.map((point) => toOklab(rgb(point)));
  return Array.from({ length: steps }, (_, i) => {
    const at = (i / (steps - 1)) * (marks.length - 1), k = Math.min(Math.floor(at), marks.length - 2), share = at - k;
    return fromOklab(marks[k]!.map((value, c) => value + share * (marks[k + 1]![c]! - value)) as unknown as Rgb);
  });
}

export interface Ramps { sizes: Rgb[]; sticks: Rgb[]; slides: Rgb[]; signed: Rgb[] }
const ofLight: Ramps = {
  sizes: ramp("#faf9de", "#cfe6be", "#93d6b2", "#5dc0b4", "#2ca6b8", "#1589b0", "#1e6ca4", "#22518f", "#243779"),
  sticks: ramp("#edf5fb", "#3e84c8"), slides: ramp("#faf3e5", "#c3610d"),
  signed: ramp("#542788", "#998ec3", "#d8daeb", "#f7f7f7", "#fee0b6", "#f1a340", "#b35806"),
};
const ofDark: Ramps = {
  sizes: ramp("#1f1b41", "#44275b", "#6e326a", "#994368", "#be595c", "#d8795d", "#ec9c63", "#f5c27c", "#fae8a2"),
  sticks: ramp("#222f3f", "#5aaeea"), slides: ramp("#3c291e", "#e2963f"),
  signed: ramp("#b9a6ee", "#7a68b8", "#453c66", "#262b30", "#66441c", "#b4721f", "#f3ac55"),
};
export const ramps = (): Ramps => (isDark() ? ofDark : ofLight);

/** Of a ramp at t from 0 to 1. */
export function of(colours: Rgb[], t: number): Rgb {
  return colours[Math.round(Math.min(Math.max(t || 0, 0), 1) * (steps - 1))]!;
}
export const css = ([red, green, blue]: Rgb): string => `rgb(${String(red)},${String(green)},${String(blue)})`;

/** Lines of theories, none of them blue or orange, and what friction can bear. */
export const exact = "--exact", fastsim2 = "--fastsim2", table = "--table", bound = "--ink3", accent = "--ui";
export const adhesion = "--stick", slip = "--slide";
