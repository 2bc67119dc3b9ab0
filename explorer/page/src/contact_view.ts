// A contact of two bodies by their radii or by its ellipse: tractions, slip, creep curves, stresses, by three theories side by side.

import { contactCase, forPeople, moreInWords, toPython } from "./case_text.ts";
import { Chart, type Curve, type Scatter } from "./chart.ts";
import * as colours from "./colours.ts";
import type { Core, Reply } from "./core.ts";
import { loadScript } from "./core.ts";
import { help, input, output } from "./description.ts";
import { clearCanvas } from "./canvas.ts";
import { contactValuesAt, drawContact, drawStress, drawTheories, type ContactLayout, type ContactScene } from "./contact_picture.ts";
import { Keys, Seldom, button, card, controlsOf, element, fillRemarks, fillTable, long, save, sentence, statusInWords, titleOf, type KeyNumber, type Row } from "./elements.ts";
import { rowHeight, type Shown } from "./field_map.ts";
import { Choice, Form, withoutPlace, type FieldSpec } from "./fields.ts";
import { readPoints, type MeasuredPoints } from "./measured_points.ts";
import { presetButtons } from "./presets.ts";
import { sheetsOf, type Sheet } from "./sheet.ts";
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
  "How the wheel moves on the rail": [
    { key: "motion.creepage_longitudinal", label: "Braking", unit: "%", from: -1, to: 1, step: 0.005, ends: ["1 driving", "1 braking"] },
    { key: "motion.creepage_lateral", label: "Drifting sideways", unit: "%", from: -1, to: 1, step: 0.005, ends: ["1 right", "1 left"] },
    { key: "motion.spin", label: "Twisting (spin)", from: -3, to: 3, step: 0.02, ends: ["3 right", "3 left"] },
    { key: "motion.rolling_speed", label: "Speed", from: 1, to: 400, step: 1 },
  ],
  "Load and friction": [{ key: "load.normal_force", label: "Load", from: 5, to: 200, step: 1 }],
  "Shapes where they touch": [
    { key: "ellipse.a", label: "Half length, along", from: 0.5, to: 15, step: 0.05 },
    { key: "ellipse.b", label: "Half width, across", from: 0.5, to: 15, step: 0.05 },
    { key: "body1.rolling_radius", label: "Wheel radius", from: 20, to: 1000, step: 5 },
    { key: "body1.transverse_radius", label: "Wheel, radius across" },
    { key: "body2.rolling_radius", label: "Rail, radius along" },
    { key: "body2.transverse_radius", label: "Rail head radius, across", from: 20, to: 1000, step: 5 },
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
  { key: "friction.coefficient", label: "Friction coefficient", from: 0.05, to: 0.8, step: 0.01 },
  { key: "friction.kinetic_coefficient", label: "At large slip", from: 0.02, to: 0.6, step: 0.01 },
  { key: "friction.drop", label: "Drop", to: 0.4, step: 0.01 },
  { key: "friction.half_velocity", label: "Half of it at", unit: "m/s", from: 0.05, to: 5, step: 0.05 },
  { key: "friction.second_drop", label: "Second drop", to: 0.4, step: 0.01 },
  { key: "friction.second_half_velocity", label: "Half of it at", unit: "m/s", from: 0.05, to: 5, step: 0.05 },
  { key: "friction.static_coefficient", label: "At rest", from: 0.05, to: 0.8, step: 0.01 },
  { key: "friction.ratio", label: "Share at large slip", step: 0.01 },
  { key: "friction.decay", label: "Decay", to: 2, step: 0.01 },
];

export class ContactView {
  readonly root = element("section", { class: "view", "aria-label": "Contact" });
  readonly #form = new Form("contact", this.root);
  readonly map = element("canvas", { class: "map", role: "img", tabindex: "0" });
  readonly #stress = element("canvas", { class: "map deep", role: "img" });
  readonly #theories = element("canvas", { class: "map small", role: "img", "aria-label": "Adhesion, slip and friction by the exact theory and by FASTSIM2, side by side" });
  readonly #lead = element("p");
  readonly #keys = new Keys();
  readonly #hover = element("p", { class: "time" });
  readonly #numbers = element("table", { class: "numbers" });
  readonly #remarks = element("ul", { class: "remarks", role: "status" });
  readonly #more = element("p", { class: "hint" });
  readonly #stressMessage = element("p", { class: "message", role: "status" });
  readonly #spoken = element("p", { class: "spoken", "aria-live": "polite" });
  readonly #time = element("p", { class: "time" });
  readonly #radiiFound = element("p", { class: "hint", role: "status" });
  readonly #pointsMessage = element("p", { class: "hint", role: "status" });
  #points: MeasuredPoints | undefined;
  readonly #curveChart: Chart;
  readonly #choices: { set: (state: ContactState) => void }[] = [];
  #solved: SolveResult | undefined;
  #ofTable: TheoryResult | undefined;
  /** What is not as it should be with the result of each theory, or why there is none. */
  #remarksOf: Partial<Record<Theory, string[]>> = {};
  #interior: Record<string, number[]> | undefined;
  #hasTable = false;
  #frame = 0;
  /** What does not have to follow the hand at every frame. */
  readonly #rest = new Seldom(() => { this.#tell(); this.#showNumbers(); }, () => { this.#drawTheories(); }, () => { this.#drawStress(); });
  readonly #sheetsOf = new WeakMap<SurfaceFields, Sheet[]>();
  #layout: ContactLayout | undefined;
  #scene: ContactScene | undefined;
  #grabbed: "along" | "across" | undefined;
  #keyNumbers: KeyNumber[] = [];
  #frozen: { keys: KeyNumber[]; sheets: Sheet[] } | undefined;
  #curves: Partial<Record<Theory, CurveResult>> = {};
  #curveRemarks: string[] = [];
  #curveRun = 0; // of runs that overtake each other the last one draws
  #later = 0;

  constructor(readonly core: Core, public state: ContactState, readonly changed: () => void) {
    const curve = element("div", { class: "chart" });
    this.#curveChart = new Chart(curve, 240);
    this.root.append(
      titleOf("Inside the contact: where the wheel sticks and where it slides", this.#lead),
      controlsOf(this.#controls()),
      element("div", { class: "pictures contact" },
        this.#keys.root,
        element("div", { class: "column" },
          element("div", { class: "panel main pinned" }, ...this.#mapChoices(), this.map, this.#hover, this.#form.message, this.#remarks, this.#time),
          card("", "Stresses in the lower body, below y = 0", "How hard the rail is strained inside", this.#stressChoice(), this.#stress, this.#stressMessage)),
        element("div", { class: "column" },
          card("", "Forces on the upper body, the wheel", "Negative: against the rolling direction, or to the right.", this.#numbers, this.#tableButton(), this.#spoken),
          card("", "Creep curves", "Force over one part of the motion, all else as now", this.#variableChoice(), curve, this.#pointsChoice(), this.#pointsMessage),
          card("", "Both theories, same case", "Friction force per area, in the same colours; arrows of the same scale", this.#theories))));
    this.#listen();
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
      "case as TOML": () => { save("contact.toml", forPeople("contact", contactCase(this.state, this.state.theory))); },
      "case as Python": () => { save("contact.py", toPython(forPeople("contact", contactCase(this.state, this.state.theory)))); },
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
    const law = new Choice("Friction law", laws(), this.state.law, (value) => {
      this.state.law = value;
      this.#showFields();
      this.solve();
      this.changed();
    }, help(input("contact", "friction.law")));
    this.#choices.push({ set: (state) => { law.set(state.law); } });
    const given = new Choice("given by", { radii: "radii", ellipse: "its ellipse" }, this.state.given, (way) => { this.#give(way as ContactState["given"]); });
    this.#choices.push({ set: (state) => { given.set(state.given); } });
    const more: Record<string, Node[]> = { "Load and friction": [law.root, ...frictionFields.map(made)] }, first: Record<string, Node[]> = { "Shapes where they touch": [given.root] };
    const last: Record<string, Node[]> = { "Shapes where they touch": [this.#radiiFound] };
    const all = Object.entries(groups).map(([name, specs]) => group(name, ...(first[name] ?? []), ...specs.map(made), ...(more[name] ?? []), ...(last[name] ?? [])));
    this.#showFields();
    return [presetButtons(), ...all, this.#more];
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
    const shown: Record<ContactState["shown"], string> = {
      friction: "friction force per area [MPa]", used: "how much of the friction is used [%]", "adhesion and slip": "where it sticks and where it slides",
      pressure: "pressure [MPa]", slip: "sliding per distance rolled [%]", px: "friction along, px [MPa]", py: "friction across, py [MPa]",
    };
    return [element("div", { class: "choices" }, this.#choice("Show", "shown", shown, redraw),
                    this.#choice("Theory", "theory", { exact: "exact", fastsim2: "quick: FASTSIM2" }, redraw))];
  }

  #variableChoice(): HTMLElement {
    const words = Object.fromEntries(variables.map((name) => [name, labelOf(name)])) as Record<Variable, string>;
    return this.#choice("over", "variable", words, () => { this.#solveRest(); });
  }

  /** Measured points, which are drawn with the curves and stay on this machine. */
  #pointsChoice(): HTMLElement {
    const file = element("input", { type: "file", id: "file-points" });
    file.addEventListener("change", () => {
      const [given] = file.files ?? [];
      if (given) void given.text().then((text) => { this.#takePoints(given.name, text); });
    });
    return element("span", { class: "file" }, file, element("label", { for: "file-points" }, "Add measured points (CSV) …"));
  }

  #takePoints(name: string, text: string): void {
    try {
      const { creepages, forces, variable } = this.#points = readPoints(text, this.state.values["load.normal_force"]!);
      const largest = Math.max(...creepages.map(Math.abs)), most = Math.max(...forces.map(Math.abs));
      this.#pointsMessage.textContent = `${name}: ${String(creepages.length)} points up to ${digits(100 * largest)} % and ${digits(most / 1e3)} kN. Fit them with microslip fit.`;
      this.state.variable = variable;
      for (const choice of this.#choices) choice.set(this.state);
      this.#solveRest();
      this.changed();
    } catch (error) {
      this.#pointsMessage.textContent = `${name} ${error instanceof Error ? error.message : String(error)}.`;
    }
  }

  /** Measured points of the variable that is shown, a set for each run. */
  #scatter(scale: number, size: number): Scatter[] {
    const points = this.#points, tokens = ["--accent1", "--accent2", "--accent3"];
    if (!points || points.variable !== this.state.variable) return [];
    return [...new Set(points.runs)].map((run, i) => {
      const of = points.runs.flatMap((other, k) => (other === run ? [k] : []));
      return { name: run ? `measured, ${run}` : "measured", colour: tokens[i % tokens.length]!, x: of.map((k) => points.creepages[k]! * scale), y: of.map((k) => points.forces[k]! / size) };
    });
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
    const reply = await this.core.ask<Radii>("contact radii", {
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
    const measured = this.#points?.variable === variable ? Math.max(...this.#points.creepages.map(Math.abs)) : 0;
    const reach = variable === "spin" ? Math.max(1, 1.2 * Math.abs(present)) : Math.max(0.005, 1.2 * Math.abs(present), 1.05 * measured);
    const wanted: Theory[] = ["fastsim2", ...(this.#hasTable ? (["table"] as const) : []), "exact"], run = ++this.#curveRun;
    const found: Partial<Record<Theory, CurveResult>> = {}, remarks: string[] = [];
    for (const theory of wanted) {
      const reply = await this.core.ask<CurveResult>("contact curve", {
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
    const { name: forceName, size } = this.#forceUnit;
    const { variable } = this.state, scale = variable === "spin" ? 1 : 100;
    const force = { creepage_longitudinal: "fx", creepage_lateral: "fy", spin: "fy" }[variable] as "fx" | "fy";
    const curves: Curve[] = [];
    for (const theory of ["exact", "fastsim2", "table"] as const) {
      const found = this.#curves[theory], { name, colour } = theories[theory];
      if (found) curves.push({ name, colour, values: found[force].map((value, i) => (found.status[i] === "ok" ? value / size : null)), ...(theory === "exact" ? {} : { dash: [7, 4] }) });
    }
    const first = Object.values(this.#curves)[0];
    if (!first) { this.#curveChart.refuse(this.#curveRemarks.join(" ")); return; }
    const unit = variable === "spin" ? "1/m" : "%";
    this.#curveChart.draw({
      x: first.value.map((value) => value * scale), xLabel: `${labelOf(variable)} [${unit}]`, yLabel: `${force === "fx" ? "Fx" : "Fy"} [${forceName}]`,
      curves, present: present * scale, drag: (value) => { this.#setMotion(variable, Number((value / scale).toPrecision(3))); }, ...(this.#points ? { scatter: this.#scatter(scale, size) } : {}),
    }, this.#curveRemarks.join(" "));
  }

  /** The present point of the creep curve was dragged. */
  #setMotion(variable: Variable, value: number): void {
    const key = `motion.${variable}`;
    this.state.values[key] = value;
    this.#form.fields.find(({ spec }) => spec.key === key)?.set(value);
    this.solve();
    this.changed();
  }

  async #askStress(): Promise<void> {
    if (!this.#solved) return;
    const { a } = this.#solved.hertz;
    const x = Array.from({ length: 41 }, (_, i) => (i - 20) * 0.09 * a), z = Array.from({ length: 28 }, (_, i) => -(i + 0.5) * 0.09 * a);
    const reply = await this.core.ask<SolveResult>("contact stress", {
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
    if (!interior || !this.#solved) { clearCanvas(this.#stress, "no stresses"); return; }
    const { x, z } = interior as { x: number[]; z: number[] }, { stress } = this.state, isSigned = stress !== "von_mises";
    const { sizes, signed } = colours.ramps(), values = interior[stress]!;
    drawStress(this.#stress, { x, z, values, isSigned, a: this.#solved.hertz.a }, (t) => colours.of(isSigned ? signed : sizes, t));
    this.#stress.setAttribute("aria-label", `stress ${stress} below the contact, up to ${digits(Math.max(...values.map(Math.abs)) * 1e-6)} MPa`);
  }

  /** Keeps what is shown as state A, or no longer. */
  freeze(isKept: boolean): void {
    this.#frozen = isKept && this.#scene ? { keys: this.#keyNumbers, sheets: this.#scene.sheets } : undefined;
    this.draw();
  }

  #sheets(theory: Theory): Sheet[] | undefined {
    const solved = this.#solved, f = solved?.[theory]?.fields;
    if (!f) return undefined;
    const known = this.#sheetsOf.get(f) ?? sheetsOf({ ...f, pressure: f.pressure ?? f.bound }, rowHeight(f.y), solved.hertz);
    this.#sheetsOf.set(f, known);
    return known;
  }

  /** Once a frame, whatever has changed since the last one. */
  draw(): void {
    cancelAnimationFrame(this.#frame);
    this.#frame = requestAnimationFrame(() => { this.#drawNow(); });
  }

  #drawNow(): void {
    const solved = this.#solved, { state } = this;
    if (!solved) return;
    const isExact = state.theory === "exact" && solved.exact !== undefined, sheets = this.#sheets(isExact ? "exact" : "fastsim2");
    if (!sheets) return;
    const { a, b } = solved.hertz;
    this.#scene = {
      sheets, other: this.#sheets(isExact ? "fastsim2" : "exact"), isExact, compared: this.#frozen?.sheets, ellipse: { a, b }, shown: state.shown as Shown,
      cut: { x: state.across * a, y: state.cut * b },
    };
    this.#drawScene();
    this.#showKeys(solved, solved[isExact ? "exact" : "fastsim2"]!);
    this.#rest.soon();
  }

  #drawTheories(): void {
    if (this.#solved) drawTheories(this.#theories, this.#sheets("exact"), this.#sheets("fastsim2"), this.#solved.hertz);
  }

  #drawScene(): void {
    if (this.#scene) this.#layout = drawContact(this.map, this.#scene);
  }

  /** In which forces are shown, by the load. */
  get #forceUnit(): { name: string; size: number } {
    return this.state.values["load.normal_force"]! < 2000 ? { name: "N", size: 1 } : { name: "kN", size: 1000 };
  }

  #showKeys({ hertz: { a, b, peak_pressure } }: SolveResult, found: TheoryResult): void {
    const { values, law } = this.state, load = values["load.normal_force"]!, area = found.adhesion_area + found.slip_area, share = area > 0 ? found.adhesion_area / area : 1;
    const { name: forceName, size } = this.#forceUnit, friction = Math.hypot(found.fx, found.fy), coefficient = law === "coulomb" ? values["friction.coefficient"] : undefined;
    const possible = coefficient === undefined ? "" : `${String(Math.round((100 * friction) / Math.max(coefficient * load, 1e-30)))} % of ${digits((coefficient * load) / size)} ${forceName} possible`;
    const length = (half: number) => (2e3 * half).toPrecision(3);
    this.#keyNumbers = [
      { name: "Load", value: digits(load / size), unit: forceName, note: "pressed together", what: input("contact", "load.normal_force").text },
      { name: "Contact patch", value: digits(Number((1e6 * Math.PI * a * b).toPrecision(3))), unit: "mm²", note: `${length(a)} mm × ${length(b)} mm`, what: "Along and across; an ellipse after Hertz" },
      { name: "Highest pressure", value: Math.round(peak_pressure / 1e6).toLocaleString("en"), unit: "MPa", note: "at the middle", what: "The largest pressure within the contact. Steel yields below the surface from some 1500 MPa on; microslip computes elastic bodies." },
      { name: "Sticks and slides", value: "", unit: "", note: `${String(Math.round(100 * share))} % sticks, ${String(Math.round(100 * (1 - share)))} % slides`, share, what: "Shares of the contact where the surfaces stick together and where they slide" },
      { name: "Friction force", value: digits(Number((friction / size).toPrecision(3))), unit: forceName, note: possible, what: "Along the surface; possible is friction times the load" },
      { name: "Heat made", value: digits(Number(found.frictional_power.toPrecision(3))), unit: "W", note: `at ${show(values["motion.rolling_speed"]!, "m/s", "km/h")} km/h`, what: output("bodies", "frictional_power").text },
    ];
    this.#keys.show(this.#keyNumbers, this.#frozen?.keys);
  }

  /** The state in a sentence. */
  #tell(): void {
    const does = this.state.values["motion.creepage_longitudinal"]!, way = Math.abs(does) < 1e-12 ? "rolls freely along" : does > 0 ? "brakes" : "drives";
    this.#lead.replaceChildren(...long("The patch on which two bodies touch, as a wheel on its rail. "), "Seen ", element("b", {}, "from above"), `; it rolls to the right and ${way}. In the blue part both surfaces stick together, in the orange part they slide. `,
      ...long("Arrows: friction on the wheel. Drag the dashed cuts; arrow keys move them."));
  }

  #showNumbers(): void {
    const solved = this.#solved;
    if (!solved) return;
    const columns = [solved.exact, solved.fastsim2, this.#hasTable ? this.#ofTable : undefined];
    const heads = ["exact", "FASTSIM2", ...(this.#hasTable ? ["table"] : [])];
    const column = (shown: (of: TheoryResult) => string) =>
      columns.slice(0, heads.length).map((of, i) => (of ? shown(of) : i === 2 && this.#remarksOf.table ? "–" : "…"));
    const row = (name: "fx" | "fy" | "mz" | "frictional_power"): Row => {
      const { unit, text } = output("bodies", name), shown = unit === "N" ? this.#forceUnit.name : shownUnit(unit);
      return { name: labelOf(name), unit: shown, what: text, values: column((of) => show(withoutNoise(of, name), unit, shown)) };
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

  #listen(): void {
    const { map } = this, at = (event: PointerEvent) => {
      const box = map.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top] as const;
    };
    const moveCut = ([x, y]: readonly [number, number]) => {
      const layout = this.#layout, solved = this.#solved;
      if (!layout || !solved) return;
      const [px, py] = layout.place.back(x, y), { a, b } = solved.hertz;
      if (this.#grabbed === "along") this.#setCut("cut", py / b);
      else this.#setCut("across", px / a);
    };
    map.addEventListener("pointerdown", (event) => {
      const layout = this.#layout, scene = this.#scene, place = at(event);
      if (!layout || !scene) return;
      const [cutX, cutY] = layout.place.at(scene.cut.x, scene.cut.y), { map: box } = layout;
      if (place[0] < box.left || place[0] > box.left + box.width || place[1] > box.top + box.height) return;
      this.#grabbed = Math.abs(place[0] - cutX) < Math.min(16, Math.abs(place[1] - cutY)) ? "across" : "along";
      map.setPointerCapture(event.pointerId);
      moveCut(place);
    });
    map.addEventListener("pointermove", (event) => {
      if (this.#grabbed) moveCut(at(event));
      else if (this.#layout && this.#scene) this.#hover.textContent = contactValuesAt(this.#layout, this.#scene, at(event));
    });
    for (const end of ["pointerup", "pointercancel"]) map.addEventListener(end, () => { this.#grabbed = undefined; });
    map.addEventListener("keydown", (event) => {
      const by = { ArrowUp: ["cut", 0.05], ArrowDown: ["cut", -0.05], ArrowRight: ["across", 0.05], ArrowLeft: ["across", -0.05] }[event.key] as ["cut" | "across", number] | undefined;
      if (!by) return;
      event.preventDefault();
      this.#setCut(by[0], this.state[by[0]] + by[1]);
    });
  }

  #setCut(which: "cut" | "across", place: number): void {
    this.state[which] = Math.min(Math.max(place, -0.98), 0.98);
    this.draw();
    this.changed();
  }
}

/** A force or moment that is nothing but rounding beside the others is zero. */
function withoutNoise(of: TheoryResult, name: "fx" | "fy" | "mz" | "frictional_power"): number {
  const size = Math.abs(of.fx) + Math.abs(of.fy), isNoise = name !== "frictional_power" && Math.abs(of[name]) < 1e-9 * size;
  return isNoise ? 0 : of[name];
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
