// Small makers of page elements.

export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K, attributes: Record<string, string> = {}, ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

export function button(text: string, pressed: () => void, label = text): HTMLButtonElement {
  const made = element("button", { type: "button", ...(label === text ? {} : { "aria-label": label }) }, text);
  made.addEventListener("click", pressed);
  return made;
}

/** A card: what it shows, a sentence on it, and the thing itself. */
export function card(kind: string, title: string, sub: string | Node, ...content: Node[]): HTMLElement {
  const words = typeof sub === "string" ? (sub === "" ? [] : [element("p", { class: "sub" }, sub)]) : [sub];
  return element("div", { class: `panel ${kind}`.trim() }, ...(title === "" ? [] : [element("h3", {}, title)]), ...words, ...content);
}

/** A title in words, and below it a sentence that is made from the state; at the right a choice of what is shown. */
export function titleOf(title: string, sentence: HTMLElement, ...choices: Node[]): HTMLElement {
  sentence.className = "lead";
  return element("div", { class: "title" }, element("div", {}, element("h2", {}, title), sentence), ...choices);
}

/** Buttons of which one is pressed. */
export class Segments<Word extends string> {
  readonly root: HTMLElement;
  readonly #buttons = new Map<Word, HTMLButtonElement>();

  constructor(label: string, words: Record<Word, string>, chosen: (word: Word) => void) {
    for (const [word, name] of Object.entries(words) as [Word, string][]) this.#buttons.set(word, button(name, () => { chosen(word); }));
    this.root = element("div", { class: "segments", role: "group", "aria-label": label }, ...this.#buttons.values());
  }

  set(pressed: Word): void {
    for (const [word, made] of this.#buttons) made.setAttribute("aria-pressed", String(word === pressed));
  }
}

/** Words that small screens leave out. */
export const long = (words: string): HTMLElement[] => [element("span", { class: "long" }, words)];

/** Names of groups of controls on small screens. */
const shortNames: Record<string, string> = {
  "Start from an example": "Examples", "Where the wheelset stands": "Position", "Load and motion": "Load", "Shapes of wheel and rail": "Shapes", "Track and wheelset": "Track",
  "How the wheel moves on the rail": "Motion", "Load and friction": "Load", "Shapes where they touch": "Shapes",
};

/** The controls of a view in groups: beside the pictures, on smaller screens a drawer, on small ones a sheet of three heights with one group at a time. */
export function controlsOf(groups: HTMLElement[]): HTMLElement {
  const heights = ["half", "full", "low"], fieldsets = groups.filter((group): group is HTMLFieldSetElement => group instanceof HTMLFieldSetElement);
  const drawer = button("Controls", () => {
    const isOpen = root.dataset["drawer"] !== "open";
    root.dataset["drawer"] = isOpen ? "open" : "closed";
    drawer.setAttribute("aria-expanded", String(isOpen));
    window.dispatchEvent(new Event("resize")); // pictures have another width
  }, "show or hide controls");
  drawer.className = "drawer";
  drawer.setAttribute("aria-expanded", "false");
  const grabber = button("", () => { root.dataset["height"] = heights[(heights.indexOf(root.dataset["height"] ?? "half") + 1) % 3]!; }, "larger or smaller controls");
  grabber.className = "grabber";
  const choices = fieldsets.map((fieldset, i) => {
    const name = fieldset.querySelector("legend")?.textContent ?? "";
    return button(shortNames[name] ?? name, () => { show(i); });
  });
  const show = (shown: number) => {
    fieldsets.forEach((fieldset, i) => {
      fieldset.classList.toggle("shown", i === shown);
      choices[i]!.setAttribute("aria-pressed", String(i === shown));
    });
    if (root.dataset["height"] === "low") root.dataset["height"] = "half";
  };
  const root = element("div", { class: "controls", "data-height": "half" }, drawer, grabber, element("div", { class: "groups" }, ...choices), ...groups);
  show(Math.min(1, fieldsets.length - 1));
  return root;
}

/** A row of a table of numbers. */
export interface Row { name: string; unit: string; values: string[]; what?: string }

export function fillTable(table: HTMLTableElement, heads: string[], rows: Row[]): void {
  const head = element("tr", {}, element("td"), ...heads.map((text) => element("th", { scope: "col" }, text)), element("td", { class: "unit" }));
  const body = rows.map((row) =>
    element("tr", row.what ? { title: row.what } : {}, element("th", { scope: "row" }, row.name), ...row.values.map((value) => element("td", {}, value)),
            element("td", { class: "unit" }, row.unit)));
  table.replaceChildren(element("thead", {}, head), element("tbody", {}, ...body));
}

/** One of the few numbers that matter, with its unit and with what it means. */
export interface KeyNumber { name: string; value: string; unit: string; note: string; what?: string; share?: number }

/** A "?" that shows and hides a text, and the text. */
export function helpOf(label: string, ...content: (Node | string)[]): [ask: HTMLButtonElement, help: HTMLElement] {
  const help = element("div", { class: "help", hidden: "" }, ...content);
  const ask = button("?", () => {
    help.hidden = !help.hidden;
    ask.setAttribute("aria-expanded", String(!help.hidden));
  }, `what is ${label}?`);
  ask.className = "ask";
  ask.setAttribute("aria-expanded", "false");
  ask.addEventListener("keydown", (event) => { if (event.key === "Escape" && !help.hidden) ask.click(); });
  return [ask, help];
}

/** The strip of key numbers, whose texts change in place. */
export class Keys {
  readonly root = element("dl", { class: "panel keys" });
  readonly #shown = new Map<string, { value: HTMLElement; note: HTMLElement; before: HTMLElement }>();

  /** `before`: those of the state that is compared. */
  show(numbers: KeyNumber[], before?: KeyNumber[]): void {
    numbers.forEach(({ name, value, unit, note, what, share }, i) => {
      const shown = this.#shown.get(name) ?? this.#add(name, share !== undefined, what), old = before?.[i];
      if (share === undefined) shown.value.replaceChildren(value, " ", element("small", {}, unit));
      else {
        shown.value.querySelector("i")!.style.width = `${String(100 * share)}%`;
        shown.value.style.visibility = Number.isNaN(share) ? "hidden" : "visible";
      }
      shown.note.textContent = note;
      shown.before.hidden = !old;
      shown.before.textContent = old ? `A: ${old.share === undefined ? `${old.value} ${old.unit}` : old.note}` : "";
    });
  }

  #add(name: string, isShare: boolean, what = ""): { value: HTMLElement; note: HTMLElement; before: HTMLElement } {
    const value = isShare ? element("dd", {}, element("div", { class: "parts" }, element("i"))) : element("dd", { class: "value" });
    const made = { value, note: element("dd", { class: "note" }), before: element("dd", { class: "before", hidden: "" }) };
    const [ask, help] = helpOf(name, what);
    this.root.append(element("div", {}, element("dt", {}, name, ...(what ? [" ", ask] : [])), made.value, made.note, made.before, ...(what ? [element("dd", {}, help)] : [])));
    this.#shown.set(name, made);
    return made;
  }
}

const seldom = 150; // [ms]
/** Things that are done one a frame, beginning at the next one, but not again within some time, after which they are made up for. */
export class Seldom {
  readonly #runs: (() => void)[];
  #done = -Infinity;
  #timer = 0;
  #isUnderWay = false;
  #isWanted = false; // once more

  constructor(...runs: (() => void)[]) { this.#runs = runs; }

  soon(): void {
    clearTimeout(this.#timer);
    this.#isWanted = this.#isUnderWay;
    if (!this.#isUnderWay) this.#timer = window.setTimeout(() => { this.#isUnderWay = true; this.#step(0); }, Math.max(0, this.#done + seldom - performance.now()));
  }

  #step(place: number): void {
    const run = this.#runs[place];
    if (run) { requestAnimationFrame(() => { run(); this.#step(place + 1); }); return; }
    this.#done = performance.now();
    this.#isUnderWay = false;
    if (this.#isWanted) this.soon();
  }
}

/** With a full stop. */
export function sentence(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

/** A status that is not ok with its reason, whose words may begin with it. */
export function statusInWords(status: string, reason = ""): string {
  const words = status.replaceAll("_", " ");
  return reason === "" || reason.startsWith(words) ? reason || words : `${words}: ${reason}`;
}

/** What can be done about a remark, on this page. */
export interface Remedy { when: RegExp; name: string; run: (remark: string) => void }

/** Shows sentences below each other, each with what can be done about it; none: nothing. What stays is not made anew: a button may just be pressed. */
export function fillRemarks(list: HTMLElement, sentences: string[], remedies: Remedy[] = []): void {
  const made = [...new Set(sentences)].map((sentence) => {
    const found = remedies.filter(({ when }) => when.test(sentence));
    return element("li", {}, element("span", {}, sentence), ...found.map(({ name, run }) => button(name, () => { run(sentence); })));
  });
  const texts = (all: Iterable<Element>) => [...all].map(({ textContent }) => textContent).join("\n");
  if (texts(made) !== texts(list.children)) list.replaceChildren(...made);
}

/** Gives the browser a file to save. */
export function save(name: string, content: Blob | string, type = "text/plain"): void {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => { URL.revokeObjectURL(url); }, 1000);
}
