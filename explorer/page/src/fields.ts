// Input fields: a slider where there is a sensible range, and a text that takes a unit; the core's message where it refuses.

import { help, input, unitsFor } from "./description.ts";
import { element, helpOf, sentence } from "./elements.ts";
import { limits, type Values, type View } from "./state.ts";
import { fromSi, parse, show, shownUnit, typedUnits } from "./units.ts";
import { inWords } from "./words.ts";

export interface FieldSpec {
  key: string; // section.key of the case file
  label: string;
  unit?: string; // in which it is shown
  step?: number; // of a slider, which there is with it, in this unit
  from?: number; // where it ends before the range of the input does
  to?: number;
  ends?: [low: string, high: string]; // words at the ends of the slider
}

/** A part of a slider by shares of its length. */
function mark(kind: "zero" | "hatched", from: number, to: number): HTMLElement {
  return element("i", { class: kind, style: `--from: ${String(from)}; --to: ${String(to)}` });
}

export class Field {
  readonly root: HTMLElement;
  readonly #text: HTMLInputElement;
  readonly #slider: HTMLInputElement | undefined;
  readonly #error: HTMLElement;
  readonly #si: string;
  readonly #sliderUnit: string;
  #hatched: HTMLElement[] = []; // ends of the slider
  #hatchedFor = "";
  readonly #ends = element("div", { class: "ends", "aria-hidden": "true" });
  #unit: string;
  #value: number;
  readonly #first: number;
  #misread = ""; // why the text is no number to take, until it is one

  constructor(place: View, readonly spec: FieldSpec, value: number, readonly changed: (value: number) => void, readonly reread: () => void) {
    const { key, label } = spec, described = input(place, key), what = help(described);
    const id = `${place}-${key.replaceAll(".", "-")}`;
    this.#si = described.unit ?? "-";
    this.#unit = this.#sliderUnit = spec.unit ?? shownUnit(this.#si);
    this.#value = this.#first = value;
    this.#error = element("span", { class: "error", id: `${id}-error`, role: "alert" });
    this.#text = element("input", { id, type: "text", "aria-describedby": `${id}-help ${id}-error`, autocomplete: "off", spellcheck: "false" });
    this.#text.addEventListener("change", () => { this.#typed(); });
    const told = element("span", { id: `${id}-help` }, what), units = typedUnits(this.#si);
    const [ask, more] = helpOf(label, ...(inWords[key] ? [element("p", {}, inWords[key]!)] : []), told, element("p", { class: "hint" }, units ? `Also takes ${units}.` : "Without a unit."));
    const parts: Node[] = [element("label", { for: id }, label), ask, this.#text, this.#unitMenu(label)];
    if (spec.step !== undefined) {
      const { least = -Infinity, largest = Infinity } = described, end = (bound: number) => fromSi(bound, this.#si, this.#unit);
      this.#slider = element("input", {
        type: "range", tabindex: "-1", "aria-label": this.#unit ? `${label}, ${this.#unit}` : label, step: String(spec.step),
        min: String(Math.max(spec.from ?? -Infinity, end(least))), max: String(Math.min(spec.to ?? Infinity, end(largest))),
      });
      this.#slider.addEventListener("input", () => { this.#moved(); });
      this.#slider.addEventListener("dblclick", () => { this.set(this.#first); this.changed(this.#first); });
      const { min, max } = this.#slider, share = Number(min) / (Number(min) - Number(max));
      parts.push(element("div", { class: "slide" }, ...(share > 0 && share < 1 ? [mark("zero", share, share)] : []), this.#slider));
      if (spec.ends) parts.push(this.#ends);
      this.#ends.append(...(spec.ends ?? []).map((end) => element("span", {}, end)));
      this.#text.addEventListener("keydown", (event) => { this.#stepped(event); });
    }
    this.root = element("div", { class: "field", title: what }, ...parts, this.#error, more);
    this.set(value);
  }

  get value(): number { return this.#value; }

  /** Numbers in any of its units; keys go past it, as units may be typed behind the number. */
  #unitMenu(label: string): HTMLElement {
    const units = Object.keys(unitsFor(this.#si)), made = element("span", { class: "unit" });
    if (this.#unit === "" || units.length < 2) { made.textContent = this.#unit; return made; }
    const menu = element("select", { tabindex: "-1", "aria-label": `unit of ${label}` }, ...units.map((unit) => element("option", { value: unit }, unit)));
    menu.value = this.#unit;
    menu.addEventListener("change", () => {
      this.#unit = menu.value;
      this.#ends.hidden = this.#unit !== this.#sliderUnit; // whose words have numbers
      this.set(this.#value);
      this.reread();
    });
    made.append(menu);
    return made;
  }

  /** Hatches the slider where a value in SI is beyond a size, and says why. */
  hatchBeyond(size: number, why: string): void {
    const slider = this.#slider, key = String(size);
    if (!slider || key === this.#hatchedFor) return;
    this.#hatchedFor = key;
    const [min, max] = [Number(slider.min), Number(slider.max)], share = (value: number) => Math.min(Math.max((fromSi(value, this.#si, this.#sliderUnit) - min) / (max - min), 0), 1);
    for (const old of this.#hatched) old.remove();
    this.#hatched = ([[0, share(-size)], [share(size), 1]] as const).filter(([from, to]) => to > from).map(([from, to]) => mark("hatched", from, to));
    slider.before(...this.#hatched);
    slider.title = this.#hatched.length ? `hatched: ${why}` : "";
  }

  /** Why what is typed is not taken, with the names that people see; "" if it is, or if the field is not there. */
  get refusal(): string {
    if (this.#misread === "" || this.root.hidden) return "";
    const group = this.root.closest("fieldset")?.querySelector("legend")?.textContent;
    return `${group ? `${group}, ` : ""}${this.spec.label}: ${this.#misread}`;
  }

  set(value: number): void {
    this.#value = value;
    this.#text.value = show(value, this.#si, this.#unit);
    if (this.#slider) this.#slider.value = show(value, this.#si, this.#sliderUnit);
    this.#misread = "";
    this.root.classList.toggle("changed", value !== this.#first);
    this.refuse("");
  }

  /** Arrow keys move the number by a step of the slider, with Shift by ten: one stop of the keyboard for both. */
  #stepped(event: KeyboardEvent): void {
    const by = { ArrowUp: 1, ArrowDown: -1 }[event.key], slider = this.#slider;
    if (by === undefined || !slider) return;
    event.preventDefault();
    const next = Number(slider.value) + by * Number(slider.step) * (event.shiftKey ? 10 : 1);
    slider.value = String(Math.min(Math.max(next, Number(slider.min)), Number(slider.max)));
    this.#moved();
  }

  /** Shows why the core refuses the value, or that it does not; a text that is no number is refused all the same. */
  refuse(why: string): void {
    const shown = this.#misread || why;
    this.#error.textContent = shown;
    this.#text.toggleAttribute("aria-invalid", shown !== "");
  }

  #typed(): void {
    const read = this.#read();
    if (typeof read === "string") {
      this.#misread = read;
      this.refuse("");
      this.reread();
      return;
    }
    this.set(read);
    this.reread();
    this.changed(read);
  }

  /** The number in the text, or why it is none to take. */
  #read(): number | string {
    const text = this.#text.value, read = parse(text, this.#si, this.#unit), limit = limits[this.spec.key];
    if (typeof read === "string" || limit === undefined || Math.abs(read) <= limit) return read;
    const shown = (value: number) => show(value, this.#si, this.#unit);
    return `"${text}" is not between ${shown(-limit)} and ${shown(limit)} ${this.#unit}`;
  }

  #moved(): void {
    const read = parse(this.#slider!.value, this.#si, this.#sliderUnit) as number;
    this.#value = read;
    this.#text.value = show(read, this.#si, this.#unit);
    this.#misread = "";
    this.root.classList.toggle("changed", read !== this.#first);
    this.refuse("");
    this.reread();
    this.changed(read);
  }
}

/** A list of words to choose from. */
export class Choice {
  readonly root: HTMLElement;
  readonly #select: HTMLSelectElement;

  constructor(label: string, words: Record<string, string>, value: string, changed: (value: string) => void, what = "") {
    const id = `choice-${label.toLowerCase().replaceAll(/\W+/g, "-")}`;
    this.#select = element("select", { id }, ...Object.entries(words).map(([word, name]) => element("option", { value: word }, name)));
    this.#select.value = value;
    this.#select.addEventListener("change", () => { changed(this.#select.value); });
    const [ask, help] = helpOf(label, element("span", {}, what));
    this.root = element("div", { class: "field", ...(what && { title: what }) }, element("label", { for: id }, label), ...(what ? [ask] : []), this.#select, ...(what ? [help] : []));
  }

  set(value: string): void { this.#select.value = value; }
}

/** What the core says, without the line of a case file that nobody sees. */
export function withoutPlace(message: string): string {
  return message.replace(/^case\.toml:(\d+: )?/, "").trim();
}

const showsLast = "Faint pictures and numbers are those of the last case without errors.";

/** The fields of a view. As long as a text is misread or the core refuses the case the view is faint, and words say why. */
export class Form {
  readonly fields: Field[] = [];
  readonly message = element("p", { class: "message", role: "alert" });
  #refusal = ""; // the core's, of the whole case
  #isRefused = false;

  /** `root`: of the view, which is marked as `old`. */
  constructor(readonly place: View, readonly root: HTMLElement) {}

  add(spec: FieldSpec, value: number, changed: (value: number) => void): Field {
    const field = new Field(this.place, spec, value, changed, () => { this.show(); });
    this.fields.push(field);
    return field;
  }

  set(values: Values): void {
    for (const field of this.fields) field.set(values[field.spec.key]!);
    this.show();
  }

  /**
   * Takes "case.toml:15: friction.coefficient = -0.3 [-]: must be in [0, 10]" to the field that it names, "" as no error.
   * Whether there is one.
   */
  refuse(message: string): boolean {
    for (const field of this.fields) field.refuse("");
    const named = this.fields.find((field) => message.includes(field.spec.key));
    named?.refuse(withoutPlace(message));
    this.#refusal = named || message === "" ? "" : sentence(withoutPlace(message));
    this.#isRefused = message !== "";
    this.show();
    return this.#isRefused;
  }

  show(): void {
    const misread = this.fields.map(({ refusal }) => refusal).filter(Boolean).map(sentence), isOld = this.#isRefused || misread.length > 0;
    this.root.classList.toggle("old", isOld);
    this.message.textContent = [this.#refusal, ...misread, isOld ? showsLast : ""].filter(Boolean).join(" ");
  }
}
