// The page: four views over one core, their state in the link.

import "./page.css";
import { ContactView } from "./contact_view.ts";
import { startOf, stateOfCase, type Start } from "./case_inputs.ts";
import { Core, hasVectors } from "./core.ts";
import { describe } from "./description.ts";
import { button, element, long } from "./elements.ts";
import { NipView } from "./nip_view.ts";
import { presets } from "./presets.ts";
import { RailView } from "./rail_view.ts";
import { StartView } from "./start_view.ts";
import type { FirstAnswers } from "./first_answers.ts";
import { decode, encode, initialState, type State, type View } from "./state.ts";
import { Tour } from "./tour.ts";

declare const FIRST_ANSWERS: FirstAnswers;

const names: Record<View, string> = { rail: "Wheel on rail", contact: "Contact", start: "Start and stop", nip: "Nip" };
const mostSteps = 200; // that can be undone

class Page {
  readonly #views;
  readonly #tabs: Record<View, HTMLButtonElement>;
  readonly #message = element("p", { class: "message", role: "alert" });
  readonly #exports = element("div");
  readonly #undo = button("↶", () => { void this.#step(this.#past, this.#future); }, "undo");
  readonly #redo = button("↷", () => { void this.#step(this.#future, this.#past); }, "redo");
  readonly #compare = button("A | B", () => { this.#freeze(this.#comparedLink === "" ? this.#link : ""); }, "compare A | B");
  readonly #comparing = element("div", { class: "comparing", role: "status", hidden: "" });
  readonly #tour = new Tour((state) => { this.#show(state, ""); this.#changed(); });
  #past: string[] = [];
  #future: string[] = [];
  #comparedLink = ""; // of state A
  #saving = 0;
  #link = "";

  constructor(readonly core: Core, public state: State, root: HTMLElement) {
    const changed = () => { this.#changed(); };
    this.#views = {
      rail: new RailView(core, state.rail, changed),
      contact: new ContactView(core, state.contact, changed),
      start: new StartView(core, state.start, changed),
      nip: new NipView(core, state.nip, changed),
    };
    const tab = (view: View) => {
      const made = button(names[view], () => { this.open(view); changed(); });
      made.setAttribute("role", "tab");
      return made;
    };
    this.#tabs = { rail: tab("rail"), contact: tab("contact"), start: tab("start"), nip: tab("nip") };
    const tabs = element("nav", { role: "tablist", "aria-label": "views" }, ...Object.values(this.#tabs));
    tabs.addEventListener("keydown", (event) => { this.#stepTabs(event); });
    root.replaceChildren(element("header", {}, element("h1", {}, "microslip", element("span", {}, " explorer")), tabs, this.#bar()),
      this.#message, this.#comparing, ...Object.values(this.#views).map(({ root: view }) => view), footOf(FIRST_ANSWERS.version), this.#tour.root);
    if (!hasVectors()) this.say("This browser has no vector instructions for WebAssembly: results are the same and take two to three times as long.");
    this.#listen(root);
  }

  #bar(): HTMLElement {
    const menu = element("details", { class: "menu" }, element("summary", { class: "button" }, "Export ▾"), this.#exports);
    this.#exports.addEventListener("click", () => { menu.open = false; });
    document.addEventListener("click", (event) => { if (!menu.contains(event.target as Node)) menu.open = false; });
    const share = button("Share", () => {
      void navigator.clipboard.writeText(location.href).then(() => { this.say("The link is on the clipboard; it holds all that is set here."); },
                                                             () => { this.say("The address of this page is the link: it holds all that is set here."); });
    }, "Share: copy the link");
    const theme = button("☾", () => { document.documentElement.dataset["theme"] = document.documentElement.dataset["theme"] === "dark" ? "light" : "dark"; this.#redraw(); }, "light or dark");
    const reset = button("Reset all", () => { this.#show({ ...initialState(), view: this.state.view }, ""); this.#changed(); });
    const tour = button("?", () => { this.#tour.start(); }, "take the tour");
    this.#undo.append(...long(" Undo"));
    this.#compare.prepend(...long("Compare "));
    tour.append(...long(" Take the tour"));
    for (const flat of [this.#undo, this.#redo, reset, theme]) flat.className = "flat";
    for (const left of [this.#redo, reset, theme]) left.classList.add("long");
    tour.className = "primary";
    return element("div", { class: "bar" }, this.#undo, this.#redo, reset, this.#compare, share, menu, theme, tour);
  }

  #listen(root: HTMLElement): void {
    window.addEventListener("hashchange", () => { if (location.hash.slice(1) !== this.#link) void this.follow(location.hash); });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { setTheme(); this.#redraw(); });
    document.addEventListener("dragover", (event) => { event.preventDefault(); });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.#dropped([...(event.dataTransfer?.files ?? [])]);
    });
    window.addEventListener("resize", () => { this.#redraw(); });
    root.addEventListener("preset", (event) => {
      const { make, told } = presets[(event as CustomEvent<number>).detail]!;
      this.#show(make(), "");
      this.say(told, false);
      this.#changed();
    });
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.target instanceof HTMLInputElement && event.target.type === "text") return;
      if (event.key === "z" && !event.shiftKey) this.#undo.click();
      else if (event.key === "y" || (event.key === "Z" && event.shiftKey)) this.#redo.click();
      else return;
      event.preventDefault();
    });
  }

  #stepTabs(event: KeyboardEvent): void {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key], all = Object.values(this.#tabs);
    if (by === undefined) return;
    event.preventDefault();
    const next = all[(all.findIndex((tab) => tab === document.activeElement) + by + all.length) % all.length]!;
    next.focus();
    next.click();
  }

  #redraw(): void { this.#views[this.state.view].draw(); }

  say(message: string, isAlert = true): void {
    this.#message.textContent = message;
    this.#message.className = isAlert ? "message" : "hint";
  }

  open(view: View): void {
    if (view !== this.state.view && this.#comparedLink !== "") this.#freeze("");
    this.state.view = this.core.shown = view;
    this.#views.rail.stop();
    this.#views.start.stop();
    for (const [name, { root }] of Object.entries(this.#views)) root.hidden = name !== view;
    for (const [name, made] of Object.entries(this.#tabs)) {
      made.setAttribute("aria-selected", String(name === view));
      made.tabIndex = name === view ? 0 : -1;
    }
    this.#compare.hidden = !("freeze" in this.#views[view]);
    const exports = Object.entries(this.#views[view].exports()).map(([text, run]) => button(text, run));
    this.#exports.replaceChildren(...exports);
    this.#views[view].solve();
  }

  /** A link of this page, or what the program hands over. */
  async follow(link: string): Promise<void> {
    try {
      const start = startOf(link);
      if (start) await this.take(start);
      else this.#show(await decode(link), "");
    } catch (error) {
      this.say(`${error instanceof Error ? error.message : String(error)}. The page shows its own example instead.`);
      this.open(this.state.view);
    }
  }

  async take(start: Start): Promise<void> {
    if (start.case !== undefined) {
      this.#show(await stateOfCase(this.core, start), "");
      this.#changed();
      return;
    }
    this.open("rail");
    for (const [name, text] of Object.entries(start.files ?? {})) await this.#views.rail.take(new File([text], name));
  }

  #show(state: State, message: string): void {
    const { view } = this.state;
    this.state = { ...state, view }; // which open changes
    this.say(message);
    this.#views.contact.set(state.contact);
    this.#views.rail.set(state.rail);
    this.#views.start.set(state.start);
    this.#views.nip.set(state.nip);
    this.open(state.view);
  }

  /** Case files may be dropped anywhere; a wheel on a rail needs its profiles along with it. */
  async #dropped(files: readonly File[]): Promise<void> {
    const isCase = (file: File) => file.name.endsWith(".toml"), given = files.find(isCase);
    if (!given) return;
    const others = await Promise.all(files.filter((file) => !isCase(file)).map(async (file) => [file.name, await file.text()] as const));
    try {
      await this.take({ case: await given.text(), files: Object.fromEntries(others) });
    } catch (error) {
      this.say(`${given.name} is not taken: ${error instanceof Error ? error.message : String(error)}`);
    }
  }

  /** One step back or forth; where there was a step the present state goes to the other end. */
  async #step(from: string[], to: string[]): Promise<void> {
    await this.#save();
    const link = from.pop();
    if (link === undefined) return;
    to.push(this.#link);
    this.#link = link;
    this.#show(await decode(link), "");
    history.replaceState(null, "", `#${link}`);
    this.#showSteps();
  }

  #showSteps(): void {
    this.#undo.disabled = this.#past.length === 0;
    this.#redo.disabled = this.#future.length === 0;
  }

  /** Keeps the present state of the view as A, or ends the comparison. */
  #freeze(link: string): void {
    this.#comparedLink = link;
    const isKept = link !== "";
    for (const view of Object.values(this.#views)) if ("freeze" in view) view.freeze(isKept && view === this.#views[this.state.view]);
    this.#comparing.hidden = !isKept;
    this.#compare.setAttribute("aria-pressed", String(isKept));
    this.#comparing.replaceChildren(element("span", {}, "State A is kept, dashed in the pictures and below the key numbers. What you change now is B."),
      button("Swap A and B", () => {
        const other = this.#comparedLink;
        void this.#save().then(async () => {
          this.#freeze(this.#link);
          this.#show(await decode(other), "");
          this.#changed();
        });
      }), button("End", () => { this.#freeze(""); }));
  }

  async #save(): Promise<void> {
    clearTimeout(this.#saving);
    const link = await encode(this.state);
    if (link === this.#link) return;
    if (this.#link !== "") this.#past = [...this.#past.slice(-mostSteps), this.#link];
    this.#future = [];
    this.#link = link;
    history.replaceState(null, "", `#${link}`);
    this.#showSteps();
  }

  /** The state as it is at first, from which changes can be undone. */
  async begin(): Promise<void> {
    this.#link = await encode(this.state);
    this.#showSteps();
  }

  #changed(): void {
    clearTimeout(this.#saving);
    this.#saving = window.setTimeout(() => { void this.#save(); }, 250);
  }
}

function footOf(version: string): HTMLElement {
  return element("footer", {}, `microslip ${version}. All is computed in this browser, nothing leaves this machine. `, element("a", { href: "licences.txt" }, "Licences"));
}

function setTheme(): void {
  document.documentElement.dataset["theme"] = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
}

async function start(): Promise<void> {
  const root = document.getElementById("page")!;
  setTheme();
  try {
    describe(FIRST_ANSWERS.description, FIRST_ANSWERS.version);
    const core = new Core(), page = new Page(core, initialState(), root);
    const loaded = drawn().then(() => core.start());
    loaded.catch((error: unknown) => { page.say(`The explorer cannot compute: ${error instanceof Error ? error.message : String(error)}.`); });
    if (location.hash.length > 1) await page.follow(location.hash);
    else page.open("rail");
    await page.begin();
  } catch (error) {
    root.replaceChildren(element("p", { class: "message", role: "alert" }, `The explorer cannot start: ${error instanceof Error ? error.message : String(error)}.`));
  }
}

/** Once the browser has shown what there is to show: a script that is read meanwhile would hold it up. */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    requestAnimationFrame(() => { setTimeout(resolve); });
    setTimeout(resolve, 200); // a hidden page has no frames
  });
}

void start();
