// A roller with an elastic cover on another roller: the nip, what it takes to roll, and how the free roller's speed differs.

import { cover, forPeople, moreInWords, nipCase, relaxationTerms, toPython } from "./case_text.ts";
import { Chart, type Band } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core } from "./core.ts";
import { output } from "./description.ts";
import { Keys, card, controlsOf, element, fillRemarks, fillTable, save, sentence, statusInWords, titleOf, type Row } from "./elements.ts";
import { drawMap, rowHeight } from "./field_map.ts";
import { Choice, Form, withoutPlace, type FieldSpec } from "./fields.ts";
import { presetButtons } from "./presets.ts";
import { contactOfRow } from "./row_edge.ts";
import { sheetsOf } from "./sheet.ts";
import type { Given, NipState, Stiffness, Values } from "./state.ts";
import { digits, show, shownUnit } from "./units.ts";

interface Totals {
  fx: number; my: number; creepage_longitudinal: number; speed_ratio: number; approach: number; peak_pressure: number;
  frictional_power: number; status: string; reason?: string;
}
interface Fields { x: number[]; y: number[]; pressure: number[]; bound: number[]; px: number[]; py: number[]; state: number[] }
interface NipResult { given: Totals; free: Totals; fields: Fields; cover: Partial<Record<Stiffness, number>> }
interface NipCurve { value: number[]; fx: number[]; status: string[] }

const layer = (key: string) => `${cover}.${key}`;
const radius = { from: 20, to: 500, step: 1 } as const, ratio = { step: 0.001 } as const;
const groups: Record<"Load and motion" | "Cover" | "Covered roller" | "Upper roller", FieldSpec[]> = {
  "Load and motion": [
    { key: "load.normal_force", label: "Load", from: 0.2, to: 20, step: 0.05 },
    { key: "friction.coefficient", label: "Friction coefficient", from: 0.05, to: 1.5, step: 0.01 },
    { key: "motion.force_longitudinal", label: "Force on the upper roller", from: -2, to: 2, step: 0.01 },
    { key: "motion.creepage_longitudinal", label: "Longitudinal creepage", unit: "%", from: -20, to: 20, step: 0.05 },
    { key: "motion.rolling_speed", label: "Speed", unit: "m/s", from: 0.1, to: 30, step: 0.1 },
  ],
  Cover: [
    { key: layer("thickness"), label: "Thickness", from: 1, to: 50, step: 0.5 },
    { key: layer("hardness"), label: "Hardness", step: 0.5 },
    { key: layer("young_modulus"), label: "Young's modulus", unit: "MPa", from: 0.5, to: 50, step: 0.1 },
    { key: layer("shear_modulus"), label: "Shear modulus", unit: "MPa", from: 0.2, to: 20, step: 0.1 },
    { key: layer("poisson_ratio"), label: "Poisson's ratio", ...ratio },
    { key: layer("relaxation_shares.1"), label: "Share that relaxes", to: 0.9, from: 0, step: 0.01 },
    { key: layer("relaxation_times.1"), label: "Within", unit: "ms", from: 0.01, to: 50, step: 0.01 },
    { key: layer("relaxation_shares.2"), label: "Second share", to: 0.9, from: 0, step: 0.01 },
    { key: layer("relaxation_times.2"), label: "Within", unit: "ms", from: 0.01, to: 50, step: 0.01 },
  ],
  "Covered roller": [
    { key: "body2.rolling_radius", label: "Radius", ...radius },
    { key: "body2.transverse_radius", label: "Crown, radius across", unit: "m", from: 1, to: 100, step: 0.5 },
    { key: "body2.young_modulus", label: "Core, Young's modulus" },
    { key: "body2.poisson_ratio", label: "Core, Poisson's ratio" },
  ],
  "Upper roller": [
    { key: "body1.rolling_radius", label: "Radius", ...radius },
    { key: "body1.transverse_radius", label: "Radius across", unit: "m" },
    { key: "body1.young_modulus", label: "Young's modulus" },
    { key: "body1.poisson_ratio", label: "Poisson's ratio" },
  ],
};
const names = { hardness: "hardness", young_modulus: "Young's modulus", shear_modulus: "shear modulus" } as const;
const force = "motion.force_longitudinal", creepage = "motion.creepage_longitudinal";

/** Of the approach over the cover's thickness; strains of linear elasticity are small. */
const largestIndentation = 0.15;
const points = 31;

export class NipView {
  readonly root = element("section", { class: "view", "aria-label": "Nip" });
  readonly #form = new Form("nip", this.root);
  readonly #choices: { set: (state: NipState) => void }[] = [];
  readonly #map = element("canvas", { class: "map small", role: "img" });
  readonly #numbers = element("table", { class: "numbers" });
  readonly #remarks = element("ul", { class: "remarks", role: "status" });
  readonly #more = element("p", { class: "hint" });
  readonly #perMetre = element("p", { class: "hint", hidden: "" }, "Cylinders: load, forces, moments and powers are those of a metre along them.");
  readonly #lead = element("p");
  readonly #keys = new Keys();
  readonly #above: HTMLElement;
  readonly #spoken = element("p", { class: "spoken", "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #along: Chart;
  readonly #curve: Chart;
  #found: NipResult | undefined;
  #later = 0;

  constructor(readonly core: Core, public state: NipState, readonly changed: () => void) {
    const along = element("div", { class: "chart" }), curve = element("div", { class: "chart" });
    this.#along = new Chart(along, 280);
    this.#curve = new Chart(curve, 270);
    this.#above = card("wide", "The nip from above", "x and y have scales of their own; blue sticks, orange slides", element("div", { class: "choices" }, this.#shownChoice()), this.#map);
    this.root.append(
      titleOf("A rubber-covered roller: pressure and friction in the nip", this.#lead),
      controlsOf(this.#controls()),
      element("div", { class: "pictures" },
        this.#keys.root,
        card("wide pinned", "Along the nip, in its middle", "", along, stateLegend(), this.#form.message, this.#remarks, this.#time),
        card("", "The nip as it is set, and with a free roller", "", this.#numbers, this.#spoken, this.#perMetre,
          element("p", { class: "hint" }, "Free: no longitudinal force. The speed ratio is the upper roller's surface speed over the covered one's, both of the undeformed radius: (2 − ξ)/(2 + ξ) with the creepage ξ.")),
        card("", "Force over creepage", "What the upper roller feels as it is driven or braked", curve),
        this.#above));
  }

  /** Takes over another state, as from a link; `solve` is the next step. */
  set(state: NipState): void {
    this.state = state;
    for (const choice of this.#choices) choice.set(state);
    this.#showFields();
    this.#form.set(state.values);
  }

  /** The nip and the free roller first; the curve once nothing has changed for a while. */
  solve(): void {
    const solved = nipCase(this.state);
    this.#tell();
    void this.core.ask<NipResult>("nip both", { call: "nip", case: solved }).then((reply) => {
      if (!reply) return;
      clearTimeout(this.#later);
      this.#form.refuse(named(reply.error?.message ?? "", this.state.values));
      if (!reply.result) return;
      this.#found = reply.result;
      this.#time.textContent = `exact theory, both: ${digits(1e3 * (reply.time ?? 0))} ms on ${this.#ofCylinders ? String(this.state.elements[0]) : this.state.elements.join(" × ")} elements`;
      this.draw();
      this.#later = window.setTimeout(() => { this.#askCurve(solved); }, 150);
    });
  }

  /** What is set in a sentence, and what one sees. */
  #tell(): void {
    const { values } = this.state, load = values["load.normal_force"]!;
    this.#form.fields.find(({ spec }) => spec.key === force)!.hatchBeyond(values["friction.coefficient"]! * load, "more than friction can bear");
    const per = this.#ofCylinders ? " a metre" : "";
    this.#lead.textContent = `A hard roller is pressed with ${digits(load / 1e3)} kN${per} into one with a rubber cover ${digits(1e3 * values[layer("thickness")]!)} mm thick, and both roll at ${digits(values["motion.rolling_speed"]!)} m/s. You look along the nip, from where the material comes in at the right to where it leaves at the left. Behind the curves: blue where both surfaces stick together, orange where they slide.`;
  }

  exports(): Record<string, () => void> {
    return {
      "case as TOML": () => { save("nip.toml", forPeople("nip", nipCase(this.state))); },
      "case as Python": () => { save("nip.py", toPython(forPeople("nip", nipCase(this.state)))); },
      "nip as CSV": () => { save("nip.csv", this.#along.csv(), "text/csv"); },
      "forces as CSV": () => { save("nip_forces.csv", this.#curve.csv(), "text/csv"); },
      "picture as PNG": () => { this.#along.canvas()?.toBlob((blob) => { if (blob) save("nip.png", blob); }); },
    };
  }

  #changed(): void {
    this.solve();
    this.changed();
  }

  #controls(): HTMLElement[] {
    const made = (spec: FieldSpec) => this.#form.add(spec, this.state.values[spec.key]!, (value) => {
      this.state.values[spec.key] = value;
      this.#changed();
    }).root;
    const given = new Choice("rolling: given is", { force: "the force", creepage: "the creepage" }, this.state.given, (value) => { this.#give(value as Given); });
    const stiffness = new Choice("stiffness by", names, this.state.stiffness, (value) => { this.#stiffen(value as Stiffness); });
    this.#choices.push({ set: (state) => { given.set(state.given); stiffness.set(state.stiffness); } });
    const before: Record<string, Choice> = { [force]: given, [layer("hardness")]: stiffness };
    const all = Object.entries(groups).map(([name, specs]) => element("fieldset", {}, element("legend", {}, name),
      ...specs.flatMap((spec) => (before[spec.key] ? [before[spec.key]!.root, made(spec)] : [made(spec)]))));
    this.#showFields();
    const meaning = element("p", { class: "hint" }, "A negative force on the upper roller is one with which the covered roller drives it. Of the cover's shear modulus shares relax; the stiffness is that of short times.");
    return [presetButtons(), ...all, meaning, this.#more];
  }

  /** The other input form of the motion, which stays the same one. */
  #give(given: Given): void {
    const { values } = this.state;
    this.state.given = given;
    if (this.#found) Object.assign(values, { [force]: this.#found.given.fx, [creepage]: this.#found.given.creepage_longitudinal });
    for (const field of this.#form.fields) if (field.spec.key === force || field.spec.key === creepage) field.set(values[field.spec.key]!);
    this.#showFields();
    this.#changed();
  }

  /** Says in other words how stiff the cover is, which stays the same one, if these words are for it. */
  #stiffen(by: Stiffness): void {
    const key = layer(by), same = this.#found?.cover[by];
    this.state.stiffness = by;
    if (same !== undefined) this.state.values[key] = same;
    this.#form.fields.find(({ spec }) => spec.key === key)!.set(this.state.values[key]!);
    this.#showFields();
    this.#changed();
  }

  #showFields(): void {
    const { given, stiffness } = this.state;
    for (const { spec: { key }, root } of this.#form.fields) {
      if (key === force || key === creepage) root.hidden = (key === force) !== (given === "force");
      const kind = key.slice(layer("").length);
      if (key.startsWith(layer("")) && kind in names) root.hidden = kind !== stiffness;
    }
    this.#more.textContent = moreInWords(this.state.more);
    this.#form.show();
  }

  #shownChoice(): HTMLElement {
    const words: Record<NipState["shown"], string> = { friction: "friction force per area [MPa]", "adhesion and slip": "where it sticks and where it slides", pressure: "pressure [MPa]", px: "friction along, px [MPa]", py: "friction across, py [MPa]" };
    const choice = new Choice("Show from above", words, this.state.shown, (value) => {
      this.state.shown = value as NipState["shown"];
      this.draw();
      this.changed();
    });
    this.#choices.push({ set: (state) => { choice.set(state.shown); } });
    return choice.root;
  }

  draw(): void {
    const found = this.#found;
    if (!found) return;
    const { fields: f } = found, middle = f.y.reduce((least, y) => (Math.abs(y) < Math.abs(least) ? y : least), Infinity);
    const places = [...new Set(f.x)].sort((one, other) => one - other), width = places.length > 1 ? places[1]! - places[0]! : 1e-3;
    const rows = { ...f, width: f.x.map(() => width) };
    const [from, to] = contactOfRow(rows, middle) ?? [0, 0];
    const inContact = f.y.filter((_, k) => f.state[k] !== 0), height = rowHeight(f.y);
    const size = { along: to - from, across: Math.max(...inContact) - Math.min(...inContact) + height };
    this.#above.hidden = this.#ofCylinders;
    this.#perMetre.hidden = !this.#ofCylinders;
    if (!this.#ofCylinders) this.#drawMap(rows, height);
    this.#drawAlong(f, middle, width, [from, to]);
    this.#showNumbers(found, size);
    this.#drawCurve(this.#curve.content);
  }

  get #ofCylinders(): boolean {
    const { values } = this.state;
    return [1, 2].every((body) => Math.abs(values[`body${String(body)}.transverse_radius`]!) === Infinity);
  }

  #drawMap(rows: Fields & { width: number[] }, height: number): void {
    const { shown } = this.state;
    drawMap(this.#map, { sheets: sheetsOf(rows, height), shown, isStretched: true, arrows: shown === "friction" || shown === "adhesion and slip", xLabel: "x, along the nip's motion [mm]", yLabel: "y, across [mm]" });
  }

  /** Between the ends of the contact, at which all is zero. */
  #drawAlong(f: Fields, middle: number, width: number, [from, to]: readonly [number, number]): void {
    const at = f.y.flatMap((y, k) => (y === middle && f.state[k] !== 0 ? [k] : [])).sort((one, other) => f.x[one]! - f.x[other]!), last = at.length - 1;
    const mega = (values: number[], sign = 1) => [0, ...at.map((k) => (sign * values[k]!) / 1e6), 0];
    const bands: Band[] = [];
    at.forEach((k, i) => {
      const colour = f.state[k] === 2 ? "--slide-soft" : "--stick-soft", before = bands.at(-1), end = (i === last ? to : f.x[k]! + width / 2) * 1e3;
      if (before?.colour === colour) before.to = end;
      else bands.push({ from: before?.to ?? from * 1e3, to: end, colour });
    });
    this.#along.draw({
      x: [from, ...at.map((k) => f.x[k]!), to].map((place) => place * 1e3), xLabel: "x [mm], rolls this way →", yLabel: "MPa", bands,
      curves: [
        { name: "pressure", colour: colours.exact, values: mega(f.pressure) },
        { name: "most that friction can bear, either way", colour: colours.bound, values: mega(f.bound), dash: [4, 4] },
        { name: "most that friction can bear, against the rolling", colour: colours.bound, values: mega(f.bound, -1), dash: [4, 4], isNamed: false },
        { name: "friction along", colour: "--accent1", values: mega(f.px) },
      ],
    });
  }

  #showNumbers(found: NipResult, size: { along: number; across: number }): void {
    const { given, free } = found, ofFree = (text: string) => (free.status === "ok" ? text : "–");
    const both = (text: (of: Totals) => string) => [text(given), ofFree(text(free))];
    const row = (name: Exclude<keyof Totals, "status" | "reason" | "speed_ratio">, unit?: string): Row => {
      const { unit: si, text, label } = output("bodies", name), shown = unit ?? shownUnit(si);
      return { name: label!, unit: shown, what: text, values: both((of) => show(of[name], si, shown)) };
    };
    const thickness = this.state.values[layer("thickness")]!, indentation = given.approach / thickness;
    fillTable(this.#numbers, ["as set", "free"], [
      { ...row("fx"), values: [row("fx").values[0]!, ofFree("0")] }, row("creepage_longitudinal", "%"),
      { name: "speed ratio", unit: "", values: both((of) => of.speed_ratio.toFixed(4)) },
      { name: "nip width, in its middle", unit: "mm", what: "length of the contact along x", values: [digits(size.along * 1e3), ""] },
      ...(this.#ofCylinders ? [] : [{ name: "contact across", unit: "mm", what: "length of the contact along y", values: [digits(size.across * 1e3), ""] }]),
      row("peak_pressure", "MPa"), row("approach"),
      { name: "approach over thickness", unit: "%", values: both((of) => digits((100 * of.approach) / thickness)) },
      row("frictional_power"), row("my"),
    ]);
    this.#showKeys(found, size);
    const notOk = (name: string, { status, reason }: Totals) => (status === "ok" ? [] : [`${name}: ${sentence(statusInWords(status, reason))}`]);
    const tooDeep = indentation > largestIndentation
      ? [`The cover gives way by ${digits(100 * indentation)} % of its thickness: beyond ${String(100 * largestIndentation)} % strains are too large for linear elasticity, and numbers are rough.`] : [];
    fillRemarks(this.#remarks, [...notOk("as set", given), ...notOk("free", free), ...tooDeep]);
    const text = `nip ${digits(size.along * 1e3)} mm wide, peak pressure ${digits(given.peak_pressure / 1e6)} MPa, force ${digits(given.fx)} N`;
    this.#spoken.textContent = text;
    this.#map.setAttribute("aria-label", `${this.state.shown} in the nip from above: ${text}`);
  }

  #showKeys({ given, free, fields: { state } }: NipResult, size: { along: number; across: number }): void {
    const of = (wanted: number) => state.filter((one) => one === wanted).length, share = of(1) / Math.max(of(1) + of(2), 1), percent = (value: number) => String(Math.round(100 * value)), minus = (value: string) => value.replace("-", "−");
    const { values } = this.state, possible = values["friction.coefficient"]! * values["load.normal_force"]!, per = this.#ofCylinders ? "/m" : "", isFree = free.status === "ok", faster = free.speed_ratio - 1;
    this.#keys.show([
      { name: "Nip width", value: (1e3 * size.along).toFixed(1), unit: "mm", note: this.#ofCylinders ? "along the rolling" : `along the rolling, ${(1e3 * size.across).toFixed(0)} mm across`, what: "How long the contact is in the direction of rolling, in its middle." },
      { name: "Highest pressure", value: digits(given.peak_pressure / 1e6), unit: "MPa", note: `cover pressed in by ${digits(1e3 * given.approach)} mm`, what: `${output("bodies", "peak_pressure").text}. ${output("bodies", "approach").text}.` },
      { name: "Free roller's speed", value: isFree ? free.speed_ratio.toFixed(4) : "–", unit: "", note: isFree ? `${Math.abs(100 * faster).toFixed(2)} % ${faster < 0 ? "slower" : "faster"} than its radius says` : "not solved", what: "Surface speed of the upper roller over that of the covered one, both of the undeformed radius, where no force along passes." },
      { name: "Sticks and slides", value: "", unit: "", note: `${percent(share)} % sticks, ${percent(1 - share)} % slides`, share, what: "Shares of the contact where both surfaces stick together (adhesion) and where they slide (slip)." },
      { name: "Force along", value: minus(digits(Math.round(given.fx))), unit: `N${per}`, note: `${percent(Math.abs(given.fx) / possible)} % of ${digits(possible / 1e3)} kN${per} possible`, what: `${output("bodies", "fx").text}.` },
      { name: "Frictional heat", value: digits(given.frictional_power), unit: `W${per}`, note: `at ${digits(values["motion.rolling_speed"]!)} m/s`, what: `${output("bodies", "frictional_power").text}.` },
    ]);
  }

  /** Of the case whose nip is shown: the state may be another one by now, and one that is refused. */
  #askCurve(solved: string): void {
    void this.core.ask<NipCurve>("nip curve", { call: "nip_curve", case: solved, count: points }).then((reply) => {
      if (!reply) return;
      if (!reply.result) {
        this.#curve.refuse(`No curve: ${sentence(withoutPlace(reply.error!.message))}`);
        return;
      }
      const { value, fx, status } = reply.result, left = status.filter((one) => one !== "ok");
      const remark = left.length ? `${String(left.length)} of ${String(status.length)} points are left out, ${[...new Set(left)].join(", ").replaceAll("_", " ")}.` : "";
      this.#drawCurve({
        x: value.map((at) => 100 * at), xLabel: "longitudinal creepage [%]", yLabel: "Fx [kN]",
        curves: [{ name: "force on the upper roller", colour: colours.exact, values: fx.map((at, k) => (status[k] === "ok" ? at / 1e3 : null)) }],
      }, remark);
    });
  }

  #drawCurve(content: Chart["content"], remark = ""): void {
    if (content && this.#found) this.#curve.draw({ ...content, present: 100 * this.#found.given.creepage_longitudinal }, remark);
  }
}

function stateLegend(): HTMLElement {
  const swatch = (colour: string, name: string) => element("span", {}, element("span", { class: "swatch", style: `background: var(${colour})` }), name);
  return element("p", { class: "hint legend" }, "behind the curves: ", swatch(colours.adhesion, "sticks (adhesion)"), swatch(colours.slip, "slides (slip)"));
}

/** The core's words on a term of the relaxation, which it counts among those that the case has, with the key of its field. */
function named(message: string, values: Values): string {
  const terms = relaxationTerms(values), key = (what: string, index: number) => layer(`relaxation_${what}s.${String(terms[index])}`);
  return message
    .replace(/relaxation_shares\[(\d+)\]\.(share|time)/, (_, index: string, what: string) => key(what, Number(index)))
    .replace("sum of relaxation_shares.share", `${key("share", 0)}: sum of shares`);
}
