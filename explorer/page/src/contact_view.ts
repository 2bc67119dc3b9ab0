// A contact of two bodies by their radii or by its ellipse: tractions, slip, creep curves, stresses, by three theories side by side.

import { contactCase, moreInWords, toPython } from "./case_text.ts";
import { Chart, type Curve } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core, Reply } from "./core.ts";
import { loadScript } from "./core.ts";
import { help, input, output } from "./description.ts";
import { button, element, fillRemarks, fillTable, save, sentence, statusInWords, type Row } from "./elements.ts";
import { clearMap, drawMap, rowHeight, yAt, type MapContent } from "./field_map.ts";
import { Choice, Form, withoutPlace, type FieldSpec } from "./fields.ts";
import { keysOf, laws, type ContactState, type Values } from "./state.ts";
import { digits, shownUnit, show } from "./units.ts";

interface SurfaceFields {
  x: number[]; y: number[]; width: number[]; pressure?: number[]; bound: number[];
  px: number[]; py: number[]; sx: number[]; sy: number[]; state: number[];
}
interface TheoryResult {
  fx: number; fy: number; mz: number; adhesion_area: number; slip_area: number; frictional_power: number;
  status: string; fields?: SurfaceFields;
}
interface SolveResult {
  hertz: { a: number; b: number; peak_pressure: number; approach: number };
  exact?: TheoryResult; fastsim2?: TheoryResult; table?: TheoryResult; warnings: string[]; reason?: string;
  interior?: Record<string, number[]>;
}
interface CurveResult { value: number[]; fx: number[]; fy: number[]; mz: number[]; status: string[] }
interface Radii { rolling_radius: number; transverse_radius: number }
type Theory = "exact" | "fastsim2" | "table";
declare const microslipTable: string;

const theories: Record<Theory, { name: string; colour: string }> = {
  exact: { name: "exact", colour: colours.exact },
  fastsim2: { name: "FASTSIM2", colour: colours.fastsim2 },
  table: { name: "table", colour: colours.table },
};

const groups: Record<string, FieldSpec[]> = {
  Load: [{ key: "load.normal_force", label: "normal force", from: 5, to: 200, step: 1 }],
  Creepages: [
    { key: "motion.creepage_longitudinal", label: "longitudinal", unit: "%", from: -1, to: 1, step: 0.005 },
    { key: "motion.creepage_lateral", label: "lateral", unit: "%", from: -1, to: 1, step: 0.005 },
    { key: "motion.spin", label: "spin", from: -3, to: 3, step: 0.02 },
    { key: "motion.rolling_speed", label: "rolling speed", from: 1, to: 400, step: 1 },
  ],
  Bodies: [
    { key: "ellipse.a", label: "half length a, in rolling", from: 0.5, to: 15, step: 0.05 },
    { key: "ellipse.b", label: "half width b, across", from: 0.5, to: 15, step: 0.05 },
    { key: "body1.rolling_radius", label: "upper body, in rolling", from: 20, to: 1000, step: 5 },
    { key: "body1.transverse_radius", label: "upper body, across" },
    { key: "body2.rolling_radius", label: "lower body, in rolling" },
    { key: "body2.transverse_radius", label: "lower body, across", from: 20, to: 1000, step: 5 },
  ],
  Material: [
    { key: "body1.young_modulus", label: "Young's modulus", from: 1, to: 400, step: 1 },
    { key: "body1.poisson_ratio", label: "Poisson's ratio", step: 0.01 },
  ],
};
const variables = ["creepage_longitudinal", "creepage_lateral", "spin"] as const;
type Variable = (typeof variables)[number];

/** Of a number of a solution, as printed tables have it. */
function labelOf(name: string): string {
  return output("bodies", name).label!;
}

/** An upper body on a flat one. */
function onFlat({ rolling_radius, transverse_radius }: Radii): Values {
  return {
    "body1.rolling_radius": rolling_radius, "body1.transverse_radius": transverse_radius,
    "body2.rolling_radius": Infinity, "body2.transverse_radius": Infinity,
  };
}
const frictionFields: FieldSpec[] = [
  { key: "friction.coefficient", label: "coefficient", from: 0.05, to: 0.8, step: 0.01 },
  { key: "friction.kinetic_coefficient", label: "at large slip", from: 0.02, to: 0.6, step: 0.01 },
  { key: "friction.drop", label: "drop", to: 0.4, step: 0.01 },
  { key: "friction.half_velocity", label: "half of it at", unit: "m/s", from: 0.05, to: 5, step: 0.05 },
  { key: "friction.second_drop", label: "second drop", to: 0.4, step: 0.01 },
  { key: "friction.second_half_velocity", label: "half of it at", unit: "m/s", from: 0.05, to: 5, step: 0.05 },
  { key: "friction.static_coefficient", label: "at rest", from: 0.05, to: 0.8, step: 0.01 },
  { key: "friction.ratio", label: "share at large slip", step: 0.01 },
  { key: "friction.decay", label: "decay", to: 2, step: 0.01 },
];

export class ContactView {
  readonly root = element("section", { class: "view", "aria-label": "Contact" });
  readonly #form = new Form("contact", this.root);
  readonly map = element("canvas", { class: "map", role: "img", tabindex: "0" });
  readonly #stress = element("canvas", { class: "map small", role: "img" });
  readonly #numbers = element("table", { class: "numbers" });
  readonly #remarks = element("ul", { class: "remarks", role: "status" });
  readonly #more = element("p", { class: "hint" });
  readonly #stressMessage = element("p", { class: "message", role: "status" });
  readonly #spoken = element("p", { class: "spoken", "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #radiiFound = element("p", { class: "hint", role: "status" });
  readonly #cutChart: Chart;
  readonly #curveChart: Chart;
  readonly #choices: { set: (state: ContactState) => void }[] = [];
  #solved: SolveResult | undefined;
  #ofTable: TheoryResult | undefined;
  /** What is not as it should be with the result of each theory, or why there is none. */
  #remarksOf: Partial<Record<Theory, string[]>> = {};
  #interior: Record<string, number[]> | undefined;
  #hasTable = false;
  #drawn: MapContent | undefined;
  #curves: Partial<Record<Theory, CurveResult>> = {};
  #curveRemarks: string[] = [];
  #curveRun = 0; // of runs that overtake each other the last one draws
  #later = 0;

  constructor(readonly core: Core, public state: ContactState, readonly changed: () => void) {
    const cut = element("div", { class: "chart" }), curve = element("div", { class: "chart" });
    this.#cutChart = new Chart(cut);
    this.#curveChart = new Chart(curve);
    this.root.append(
      element("div", { class: "controls" }, ...this.#controls()),
      element("div", { class: "pictures" },
        element("div", { class: "panel wide" }, ...this.#mapChoices(), this.map, this.#form.message, this.#remarks, this.#time),
        element("div", { class: "panel" }, element("h3", {}, "Forces on the upper body"), this.#numbers, this.#tableButton(), this.#spoken),
        element("div", { class: "panel" }, element("h3", {}, "Along the dashed cut"), cut),
        element("div", { class: "panel" }, element("h3", {}, "Creep curves"), this.#variableChoice(), curve),
        element("div", { class: "panel" }, element("h3", {}, "Stresses in the lower body, below y = 0"), this.#stressChoice(), this.#stress, this.#stressMessage)));
    this.map.addEventListener("pointerdown", (event) => { this.#moveCut(event); });
    this.map.addEventListener("pointermove", (event) => { if (event.buttons) this.#moveCut(event); });
    this.map.addEventListener("keydown", (event) => {
      const by = { ArrowUp: 0.05, ArrowDown: -0.05 }[event.key];
      if (by === undefined) return;
      event.preventDefault();
      this.#setCut(this.state.cut + by);
    });
  }

  /** Takes over another state, as from a link; `solve` is the next step. */
  set(state: ContactState): void {
    this.state = state;
    for (const choice of this.#choices) choice.set(state);
    this.#showFields();
    this.#form.set(state.values);
  }

  /** The fast theory first, then the exact one; curves and stresses once nothing has changed for a while. */
  solve(): void {
    void this.#settleRadii().then((settled) => { if (settled) this.#solveSettled(); });
  }

  #solveSettled(): void {
    void this.#ask("fastsim2").then((drawn) => (drawn ? this.#ask("exact") : false)).then((drawn) => { if (drawn) this.#restLater(); });
    if (this.#hasTable) void this.#askTable();
  }

  #restLater(): void {
    clearTimeout(this.#later);
    this.#later = window.setTimeout(() => { this.#solveRest(); }, 150);
  }

  exports(): Record<string, () => void> {
    return {
      "case as TOML": () => { save("contact.toml", contactCase(this.state, this.state.theory)); },
      "case as Python": () => { save("contact.py", toPython(contactCase(this.state, this.state.theory))); },
      "tractions as CSV": () => { save("tractions.csv", this.#fieldsCsv(), "text/csv"); },
      "creep curves as CSV": () => { save("creep_curves.csv", this.#curveChart.csv(), "text/csv"); },
      "picture as PNG": () => { this.map.toBlob((blob) => { if (blob) save("contact.png", blob); }); },
    };
  }

  #controls(): HTMLElement[] {
    const made = (spec: FieldSpec) => this.#form.add(spec, this.state.values[spec.key]!, (value) => {
      this.state.values[spec.key] = value;
      this.solve();
      this.changed();
    }).root;
    const group = (name: string, ...content: Node[]) => element("fieldset", {}, element("legend", {}, name), ...content);
    const law = new Choice("law", laws(), this.state.law, (value) => {
      this.state.law = value;
      this.#showFields();
      this.solve();
      this.changed();
    }, help(input("contact", "friction.law")));
    this.#choices.push({ set: (state) => { law.set(state.law); } });
    const given = new Choice("given by", { radii: "radii", ellipse: "its ellipse" }, this.state.given, (way) => { this.#give(way as ContactState["given"]); });
    this.#choices.push({ set: (state) => { given.set(state.given); } });
    const all = Object.entries(groups).map(([name, specs]) =>
      name === "Bodies" ? group(name, given.root, ...specs.map(made), this.#radiiFound) : group(name, ...specs.map(made)));
    all.splice(2, 0, group("Friction", law.root, ...frictionFields.map(made)));
    this.#showFields();
    return [...all, this.#more];
  }

  #showFields(): void {
    for (const field of this.#form.fields.filter(({ spec }) => spec.key.startsWith("friction.")))
      field.root.hidden = !keysOf(this.state.law).includes(field.spec.key);
    const ofEllipse = this.state.given === "ellipse";
    for (const field of this.#form.fields.filter(({ spec }) => /^ellipse|_radius$/.test(spec.key)))
      field.root.hidden = field.spec.key.startsWith("ellipse.") !== ofEllipse;
    this.#radiiFound.hidden = !ofEllipse;
    this.#more.textContent = moreInWords(this.state.more);
    this.#form.show();
  }

  #choice<Key extends "shown" | "theory" | "variable" | "stress">(label: string, key: Key, words: Record<ContactState[Key], string>, then: () => void): HTMLElement {
    const choice = new Choice(label, words, this.state[key], (value) => {
      this.state[key] = value as ContactState[Key];
      then();
      this.changed();
    });
    this.#choices.push({ set: (state) => { choice.set(state[key]); } });
    return choice.root;
  }

  #mapChoices(): HTMLElement[] {
    const redraw = () => { this.draw(); };
    const shown = {
      tractions: "tractions over the bound", "adhesion and slip": "adhesion and slip", slip: "slip", pressure: "pressure",
      px: "traction px", py: "traction py",
    };
    return [element("div", { class: "choices" }, this.#choice("shown", "shown", shown, redraw),
                    this.#choice("theory", "theory", { exact: "exact", fastsim2: "FASTSIM2" }, redraw))];
  }

  #variableChoice(): HTMLElement {
    const words = Object.fromEntries(variables.map((name) => [name, labelOf(name)])) as Record<Variable, string>;
    return this.#choice("over", "variable", words, () => { this.#solveRest(); });
  }

  #stressChoice(): HTMLElement {
    const words = { von_mises: "von Mises", sigma_xx: "σxx", sigma_zz: "σzz", sigma_xz: "σxz" };
    return this.#choice("stress", "stress", words, () => { this.#drawStress(); });
  }

  #tableButton(): HTMLElement {
    const load = button("add the creep-force table (11 MB)", () => {
      load.disabled = true;
      void loadScript("hertz_table.js").then(async () => {
        await this.core.put("hertz.creep", Uint8Array.from(atob(microslipTable), (letter) => letter.charCodeAt(0)));
        this.#hasTable = true;
        load.hidden = true;
        this.solve();
      }).catch((error: unknown) => { this.#form.message.textContent = String(error); });
    });
    return load;
  }

  /** Of an ellipse the core finds the radii, under the load and of the material that are set; whether there are radii. */
  async #settleRadii(): Promise<boolean> {
    const { state } = this, { values } = state;
    if (state.given !== "ellipse") return true;
    const anyBodies = { ...state, values: { ...values, ...onFlat({ rolling_radius: 1, transverse_radius: 1 }) } };
    const reply = await this.core.ask<Radii>("radii", {
      call: "radii", case: contactCase(anyBodies, "fastsim2"), a: values["ellipse.a"], b: values["ellipse.b"],
    });
    if (!reply || state !== this.state) return false;
    if (reply.error) reply.error.message = reply.error.message.replace(/^(request\.)?([ab])(?=[ :])/, "ellipse.$2");
    if (this.#refused(reply)) return false;
    Object.assign(values, onFlat(reply.result!));
    const { rolling_radius, transverse_radius } = reply.result!;
    this.#radiiFound.textContent =
      `That is, under this load, an upper body of radii ${digits(rolling_radius * 1e3)} mm in rolling and ${digits(transverse_radius * 1e3)} mm across, on a flat one.`;
    return true;
  }

  /** The other input form of the contact, which stays the same one. */
  #give(way: ContactState["given"]): void {
    const { values } = this.state;
    this.state.given = way;
    if (way === "ellipse" && this.#solved) Object.assign(values, { "ellipse.a": this.#solved.hertz.a, "ellipse.b": this.#solved.hertz.b });
    for (const field of this.#form.fields) if (/^ellipse|_radius$/.test(field.spec.key)) field.set(values[field.spec.key]!);
    this.#showFields();
    this.solve();
    this.changed();
  }

  /** Whether no newer request has replaced this one. */
  async #ask(theory: "fastsim2" | "exact"): Promise<boolean> {
    const reply = await this.core.ask<SolveResult>(`contact ${theory}`, {
      call: "solve", case: contactCase(this.state, theory), fields: true, extent: "solution",
    });
    if (!reply || this.#refused(reply)) return false;
    const found = reply.result!;
    this.#remarksOf[theory] = remarksOn(found, theory);
    const exact = theory === "fastsim2" ? this.#solved?.exact : found.exact;
    this.#solved = { ...found, ...(exact ? { exact } : {}) };
    if (theory === this.state.theory || theory === "exact" || !exact) this.draw();
    this.#time.textContent = `${theories[theory].name}: ${digits(1e3 * (reply.time ?? 0))} ms on ${this.state.elements.join(" × ")} elements`;
    return true;
  }

  async #askTable(): Promise<void> {
    const reply = await this.core.ask<SolveResult>("contact table", { call: "solve", case: contactCase(this.state, "table") });
    if (!reply) return;
    this.#ofTable = reply.result?.table;
    this.#remarksOf.table = reply.result ? remarksOn(reply.result, "table") : [`table: ${sentence(withoutPlace(reply.error!.message))}`];
    this.#showNumbers();
  }

  #refused(reply: Reply<unknown>): boolean {
    return this.#form.refuse(reply.error?.message ?? "");
  }

  #solveRest(): void {
    void this.#askCurves();
    void this.#askStress();
  }

  async #askCurves(): Promise<void> {
    const { variable } = this.state, present = this.state.values[`motion.${variable}`]!;
    const reach = variable === "spin" ? Math.max(1, 1.2 * Math.abs(present)) : Math.max(0.005, 1.2 * Math.abs(present));
    const wanted: Theory[] = ["fastsim2", ...(this.#hasTable ? (["table"] as const) : []), "exact"], run = ++this.#curveRun;
    const found: Partial<Record<Theory, CurveResult>> = {}, remarks: string[] = [];
    for (const theory of wanted) {
      const reply = await this.core.ask<CurveResult>("curve", {
        call: "creep_curve", case: contactCase(this.state, theory), variable, from: -reach, to: reach, count: 41,
      });
      if (!reply || run !== this.#curveRun) return;
      if (reply.result) found[theory] = reply.result;
      remarks.push(...(reply.result ? remarksOnCurve(reply.result, theory) : [`${theories[theory].name}: ${sentence(withoutPlace(reply.error!.message))}`]));
      [this.#curves, this.#curveRemarks] = [found, remarks];
      this.#drawCurves(present);
    }
  }

  #drawCurves(present: number): void {
    const { variable } = this.state, scale = variable === "spin" ? 1 : 100;
    const force = { creepage_longitudinal: "fx", creepage_lateral: "fy", spin: "fy" }[variable] as "fx" | "fy";
    const curves: Curve[] = [];
    for (const theory of ["exact", "fastsim2", "table"] as const) {
      const found = this.#curves[theory], { name, colour } = theories[theory];
      if (found) curves.push({ name, colour, values: found[force].map((value, i) => (found.status[i] === "ok" ? value / 1e3 : null)), ...(theory === "exact" ? {} : { dash: [7, 4] }) });
    }
    const first = Object.values(this.#curves)[0];
    if (!first) { this.#curveChart.refuse(this.#curveRemarks.join(" ")); return; }
    const unit = variable === "spin" ? "1/m" : "%";
    this.#curveChart.draw({
      x: first.value.map((value) => value * scale), xLabel: `${labelOf(variable)} [${unit}]`, yLabel: `${force === "fx" ? "Fx" : "Fy"} [kN]`,
      curves, present: present * scale,
    }, this.#curveRemarks.join(" "));
  }

  async #askStress(): Promise<void> {
    if (!this.#solved) return;
    const { a } = this.#solved.hertz;
    const x = Array.from({ length: 41 }, (_, i) => (i - 20) * 0.09 * a), z = Array.from({ length: 28 }, (_, i) => -(i + 0.5) * 0.09 * a);
    const reply = await this.core.ask<SolveResult>("stress", {
      call: "solve", fields: true, extent: "solution",
      case: contactCase({ ...this.state, elements: [20, 20] }, "exact", { "interior.x": x, "interior.y": [0], "interior.z": z }),
    });
    if (!reply) return;
    this.#interior = reply.result?.interior;
    this.#stressMessage.textContent = reply.result ? whyNot(reply.result, "exact").join(" ") : `No stresses: ${sentence(withoutPlace(reply.error!.message))}`;
    this.#drawStress();
  }

  #drawStress(): void {
    const interior = this.#interior;
    if (!interior) { clearMap(this.#stress, "no stresses"); return; }
    const { x, z } = interior as { x: number[]; z: number[] }, { stress } = this.state;
    const cells = {
      x: z.flatMap(() => x), y: z.flatMap((depth) => x.map(() => depth)), width: z.flatMap(() => x.map(() => x[1]! - x[0]!)),
      height: Math.abs(z[1]! - z[0]!), state: z.flatMap(() => x.map(() => 1)),
    };
    drawMap(this.#stress, { cells, colour: { values: interior[stress]!, unit: "MPa", scale: 1e-6, signed: stress !== "von_mises" } });
    const largest = Math.max(...interior[stress]!.map(Math.abs));
    this.#stress.setAttribute("aria-label", `stress ${stress} below the contact, up to ${digits(largest * 1e-6)} MPa`);
  }

  draw(): void {
    const solved = this.#solved;
    const theory = solved?.[this.state.theory] ?? solved?.fastsim2, f = theory?.fields;
    if (!solved || !theory || !f) return;
    const pressure = f.pressure ?? f.bound;
    const size = (x: number[], y: number[]) => x.map((value, k) => Math.hypot(value, y[k]!));
    const colour: Record<ContactState["shown"], MapContent["colour"]> = {
      tractions: { values: f.bound, unit: "MPa bound", scale: 1e-6, signed: false },
      "adhesion and slip": "state",
      slip: { values: size(f.sx, f.sy), unit: "% slip", scale: 100, signed: false },
      pressure: { values: pressure, unit: f.pressure ? "MPa" : "MPa bound", scale: 1e-6, signed: false },
      px: { values: f.px, unit: "MPa", scale: 1e-6, signed: true },
      py: { values: f.py, unit: "MPa", scale: 1e-6, signed: true },
    };
    const { a, b } = solved.hertz;
    const arrows = this.state.shown === "slip" ? { x: f.sx, y: f.sy } : { x: f.px, y: f.py };
    this.#drawn = {
      cells: { ...f, height: rowHeight(f.y) }, colour: colour[this.state.shown], outline: { a, b }, cutAt: this.state.cut * b,
      ...(["pressure", "px", "py"].includes(this.state.shown) ? {} : { arrows: { ...arrows, longest: Math.max(...size(arrows.x, arrows.y), 1e-30) } }),
    };
    drawMap(this.map, this.#drawn);
    this.#drawCut(f, b);
    this.#drawStress();
    this.#showNumbers();
  }

  #drawCut(f: SurfaceFields, b: number): void {
    const wanted = this.state.cut * b;
    let row = Infinity;
    for (const y of f.y) if (Math.abs(y - wanted) < Math.abs(row - wanted)) row = y;
    const at = f.y.flatMap((y, k) => (y === row && f.state[k] !== 0 ? [k] : [])).sort((one, other) => f.x[one]! - f.x[other]!);
    const mega = (values: number[]) => at.map((k) => values[k]! / 1e6);
    this.#cutChart.draw({
      x: at.map((k) => f.x[k]! * 1e3), xLabel: "x [mm]", yLabel: "MPa",
      curves: [
        { name: "bound", colour: colours.bound, values: mega(f.bound), dash: [4, 4] },
        { name: "|p|", colour: colours.exact, values: at.map((k) => Math.hypot(f.px[k]!, f.py[k]!) / 1e6) },
        { name: "px", colour: colours.fastsim2, values: mega(f.px) },
        { name: "py", colour: colours.accent, values: mega(f.py) },
      ],
    });
  }

  #showNumbers(): void {
    const solved = this.#solved;
    if (!solved) return;
    const columns = [solved.exact, solved.fastsim2, this.#hasTable ? this.#ofTable : undefined];
    const heads = ["exact", "FASTSIM2", ...(this.#hasTable ? ["table"] : [])];
    const column = (shown: (of: TheoryResult) => string) =>
      columns.slice(0, heads.length).map((of, i) => (of ? shown(of) : i === 2 && this.#remarksOf.table ? "–" : "…"));
    const row = (name: "fx" | "fy" | "mz" | "frictional_power"): Row => {
      const { unit, text } = output("bodies", name), shown = shownUnit(unit);
      return { name: labelOf(name), unit: shown, what: text, values: column((of) => show(of[name], unit, shown)) };
    };
    fillRemarks(this.#remarks, Object.values(this.#remarksOf).flat());
    const { a, b, peak_pressure } = solved.hertz;
    const all = (value: number) => heads.map((_, i) => (i === 0 ? digits(value) : ""));
    fillTable(this.#numbers, heads, [
      row("fx"), row("fy"), row("mz"),
      { name: "share in adhesion", unit: "%", values: column((of) => digits((100 * of.adhesion_area) / (of.adhesion_area + of.slip_area))) },
      row("frictional_power"),
      { name: "ellipse, half length a", unit: "mm", values: all(a * 1e3) },
      { name: "ellipse, half width b", unit: "mm", values: all(b * 1e3) },
      { name: labelOf("peak_pressure"), unit: "MPa", values: all(peak_pressure / 1e6) },
    ]);
    const spoken = solved.exact ?? solved.fastsim2;
    if (spoken) {
      const text = `Fx ${digits(spoken.fx / 1e3)} kN, Fy ${digits(spoken.fy / 1e3)} kN`;
      this.#spoken.textContent = text;
      this.map.setAttribute("aria-label", `${this.state.shown} in the contact, ${digits(2e3 * a)} by ${digits(2e3 * b)} mm: ${text}`);
    }
  }

  #fieldsCsv(): string {
    const f = this.#solved?.[this.state.theory]?.fields;
    if (!f) return "";
    const lines = f.x.flatMap((x, k) => (f.state[k] === 0 ? [] : [[x, f.y[k], f.bound[k], f.px[k], f.py[k], f.sx[k], f.sy[k], f.state[k]].join(",")]));
    const heads = ["x", "y", "bound", "px", "py", "sx", "sy"].map((name) => `${name} [${output("fields", name).unit}]`);
    return [[...heads, "state"].join(","), ...lines].join("\n") + "\n";
  }

  #moveCut(event: PointerEvent): void {
    if (this.#drawn && this.#solved) this.#setCut(yAt(this.map, this.#drawn, event.clientY) / this.#solved.hertz.b);
  }

  #setCut(cut: number): void {
    this.state.cut = Math.min(Math.max(cut, -0.98), 0.98);
    this.draw();
    this.changed();
  }
}

/** Why a theory did not come to its end, if so. */
function whyNot(found: SolveResult, theory: Theory): string[] {
  const status = found[theory]?.status ?? "ok";
  return status === "ok" ? [] : [sentence(`${theories[theory].name}: ${statusInWords(status, found.reason)}`)];
}

function remarksOn(found: SolveResult, theory: Theory): string[] {
  return [...found.warnings.map(sentence), ...whyNot(found, theory)];
}

/** Points of a curve that are left out. */
function remarksOnCurve({ status }: CurveResult, theory: Theory): string[] {
  const others = status.filter((one) => one !== "ok"), why = [...new Set(others)].join(", ").replaceAll("_", " ");
  return others.length ? [`${theories[theory].name}: ${String(others.length)} of ${String(status.length)} points are left out, ${why}.`] : [];
}
