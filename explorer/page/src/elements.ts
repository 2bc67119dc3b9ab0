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

/** Words that small screens leave out. */
export const long = (words: string): HTMLElement[] => [element("span", { class: "long" }, words)];

/** Names of groups of controls on small screens. */
const shortNames: Record<string, string> = {
  "Start from an example": "Examples", "Where the wheelset stands": "Position", "Load and motion": "Load", "Shapes of wheel and rail": "Shapes", "Track and wheelset": "Track",
  "How the wheel moves on the rail": "Motion", "Load and friction": "Load", "Shapes where they touch": "Shapes",
};

/** The controls of a view in groups, one of which at a time is shown on small screens: a sheet of three heights. */
export function controlsOf(groups: HTMLElement[]): HTMLElement {
  const heights = ["half", "full", "low"], fieldsets = groups.filter((group): group is HTMLFieldSetElement => group instanceof HTMLFieldSetElement);
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
  const root = element("div", { class: "controls", "data-height": "half" }, grabber, element("div", { class: "groups" }, ...choices), ...groups);
  show(Math.min(1, fieldsets.length - 1));
  return root;
}

/** A row of a table of numbers. */
export interface Row { name: string; unit: string; values: string[]; what?: string }

export function fillTable(table: HTMLTableElement, heads: string[], rows: Row[]): void {
  const head = element("tr", {}, element("th", {}), ...heads.map((text) => element("th", { scope: "col" }, text)), element("th", {}, ""));
  const body = rows.map((row) =>
    element("tr", row.what ? { title: row.what } : {}, element("th", { scope: "row" }, row.name), ...row.values.map((value) => element("td", {}, value)),
            element("td", { class: "unit" }, row.unit)));
  table.replaceChildren(element("thead", {}, head), element("tbody", {}, ...body));
}

/** One of the few numbers that matter, with its unit and with what it means. */
export interface KeyNumber { name: string; value: string; unit: string; note: string; what?: string; share?: number }

/** `before`: those of the state that is compared. */
export function fillKeys(list: HTMLElement, numbers: KeyNumber[], before?: KeyNumber[]): void {
  list.replaceChildren(...numbers.map(({ name, value, unit, note, what, share }, i) => {
    const shown = share === undefined
      ? element("dd", { class: "value" }, value, " ", element("small", {}, unit))
      : element("dd", {}, element("div", { class: "parts" }, element("i", { style: `width: ${String(100 * share)}%` })));
    const old = before?.[i], compared = old ? [element("dd", { class: "before" }, `A: ${old.share === undefined ? `${old.value} ${old.unit}` : old.note}`)] : [];
    return element("div", what ? { title: what } : {}, element("dt", {}, name), shown, element("dd", { class: "note" }, note), ...compared);
  }));
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

/** Shows sentences below each other, each with what can be done about it; none: nothing. */
export function fillRemarks(list: HTMLElement, sentences: string[], remedies: Remedy[] = []): void {
  list.replaceChildren(...[...new Set(sentences)].map((sentence) => {
    const found = remedies.filter(({ when }) => when.test(sentence));
    return element("li", {}, element("span", {}, sentence), ...found.map(({ name, run }) => button(name, () => { run(sentence); })));
  }));
}

/** Gives the browser a file to save. */
export function save(name: string, content: Blob | string, type = "text/plain"): void {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => { URL.revokeObjectURL(url); }, 1000);
}
