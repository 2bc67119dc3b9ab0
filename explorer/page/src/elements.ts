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
  const made = element("button", { type: "button", "aria-label": label }, text);
  made.addEventListener("click", pressed);
  return made;
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

/** With a full stop. */
export function sentence(text: string): string {
  return /[.!?]$/.test(text) ? text : `${text}.`;
}

/** A status that is not ok with its reason, whose words may begin with it. */
export function statusInWords(status: string, reason = ""): string {
  const words = status.replaceAll("_", " ");
  return reason === "" || reason.startsWith(words) ? reason || words : `${words}: ${reason}`;
}

/** Shows sentences below each other; none: nothing. */
export function fillRemarks(list: HTMLElement, sentences: string[]): void {
  list.replaceChildren(...[...new Set(sentences)].map((sentence) => element("li", {}, sentence)));
}

/** Gives the browser a file to save. */
export function save(name: string, content: Blob | string, type = "text/plain"): void {
  const url = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type }));
  element("a", { href: url, download: name }).click();
  setTimeout(() => { URL.revokeObjectURL(url); }, 1000);
}
