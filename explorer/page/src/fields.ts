// Input fields: a slider where there is a sensible range, and a text that takes a unit; the core's own words where it refuses.

import { element } from "./elements.ts";
import { parse, show, type Kind } from "./units.ts";

export interface FieldSpec {
  key: string; // section.key of the case file
  label: string;
  kind: Kind;
  unit: string;
  from?: number; // range of the slider, in `unit`
  to?: number;
  step?: number;
}

export class Field {
  readonly root: HTMLElement;
  readonly #text: HTMLInputElement;
  readonly #slider: HTMLInputElement | undefined;
  readonly #error: HTMLElement;
  #value: number;
  #misread = ""; // why the text is no number, until it is one

  constructor(place: string, readonly spec: FieldSpec, value: number, readonly changed: (value: number) => void) {
    const { key, label, unit } = spec;
    const id = `${place}-${key.replaceAll(".", "-")}`;
    this.#value = value;
    this.#error = element("span", { class: "error", id: `${id}-error`, role: "alert" });
    this.#text = element("input", { id, type: "text", "aria-describedby": `${id}-error`, autocomplete: "off", spellcheck: "false" });
    this.#text.addEventListener("change", () => { this.#typed(); });
    const parts: Node[] = [element("label", { for: id }, label), this.#text, element("span", { class: "unit" }, unit)];
    if (spec.from !== undefined && spec.to !== undefined) {
      this.#slider = element("input", {
        type: "range", "aria-label": unit ? `${label}, ${unit}` : label,
        min: String(spec.from), max: String(spec.to), step: String(spec.step ?? (spec.to - spec.from) / 200),
      });
      this.#slider.addEventListener("input", () => { this.#moved(); });
      parts.push(this.#slider);
    }
    this.root = element("div", { class: "field" }, ...parts, this.#error);
    this.set(value);
  }

  get value(): number { return this.#value; }

  set(value: number): void {
    this.#value = value;
    this.#text.value = show(value, this.spec.kind, this.spec.unit);
    if (this.#slider) this.#slider.value = this.#text.value;
    this.#misread = "";
    this.refuse("");
  }

  /** Shows why the core refuses the value, or that it does not; a text that is no number is refused all the same. */
  refuse(why: string): void {
    const shown = this.#misread || why;
    this.#error.textContent = shown;
    this.#text.toggleAttribute("aria-invalid", shown !== "");
  }

  #typed(): void {
    const read = parse(this.#text.value, this.spec.kind, this.spec.unit);
    if (typeof read === "string") {
      this.#misread = read;
      this.refuse("");
      return;
    }
    this.set(read);
    this.changed(read);
  }

  #moved(): void {
    const read = parse(this.#slider!.value, this.spec.kind, this.spec.unit) as number;
    this.#value = read;
    this.#text.value = show(read, this.spec.kind, this.spec.unit);
    this.#misread = "";
    this.refuse("");
    this.changed(read);
  }
}

/** A list of words to choose from. */
export class Choice {
  readonly root: HTMLElement;
  readonly #select: HTMLSelectElement;

  constructor(label: string, words: Record<string, string>, value: string, changed: (value: string) => void) {
    const id = `choice-${label.toLowerCase().replaceAll(/\W+/g, "-")}`;
    this.#select = element("select", { id }, ...Object.entries(words).map(([word, name]) => element("option", { value: word }, name)));
    this.#select.value = value;
    this.#select.addEventListener("change", () => { changed(this.#select.value); });
    this.root = element("div", { class: "field" }, element("label", { for: id }, label), this.#select);
  }

  set(value: string): void { this.#select.value = value; }
}

/** What the core says, without the line of a case file that nobody sees. */
export function withoutPlace(message: string): string {
  return message.replace(/^case\.toml:(\d+: )?/, "").trim();
}

export const showsLast = "Faint pictures and numbers are those of the last case without errors.";

/** Shows "case.toml:15: friction.coefficient = -0.3 [-]: must be in [0, 10]" at the field that it names, and returns whether one is named. */
export function refuseAt(fields: Field[], message: string): boolean {
  for (const field of fields) field.refuse("");
  const named = fields.find((field) => message.includes(field.spec.key));
  named?.refuse(withoutPlace(message));
  return named !== undefined;
}
