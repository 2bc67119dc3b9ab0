// The page: four views over one core, their state in the link.

import "./page.css";
import { ContactView } from "./contact_view.ts";
import { startOf, stateOfCase, type Start } from "./case_inputs.ts";
import { Core, hasVectors } from "./core.ts";
import { readDescription } from "./description.ts";
import { button, element } from "./elements.ts";
import { NipView } from "./nip_view.ts";
import { RailView } from "./rail_view.ts";
import { StartView } from "./start_view.ts";
import { decode, encode, initialState, type State, type View } from "./state.ts";

const names: Record<View, string> = { contact: "Contact", rail: "Wheel on rail", start: "Start and stop", nip: "Nip" };

class Page {
  readonly #views;
  readonly #tabs: Record<View, HTMLButtonElement>;
  readonly #message = element("p", { class: "message", role: "alert" });
  readonly #exports = element("div", { class: "exports" });
  #saving = 0;
  #link = "";

  constructor(readonly core: Core, public state: State, root: HTMLElement) {
    const changed = () => { this.#changed(); };
    this.#views = {
      contact: new ContactView(core, state.contact, changed),
      rail: new RailView(core, state.rail, changed),
      start: new StartView(core, state.start, changed),
      nip: new NipView(core, state.nip, changed),
    };
    const tab = (view: View) => {
      const made = button(names[view], () => { this.open(view); changed(); });
      made.setAttribute("role", "tab");
      return made;
    };
    this.#tabs = { contact: tab("contact"), rail: tab("rail"), start: tab("start"), nip: tab("nip") };
    root.replaceChildren(
      element("header", {}, element("h1", {}, "microslip explorer"), element("nav", { role: "tablist", "aria-label": "views" }, ...Object.values(this.#tabs)), this.#exports),
      this.#message,
      ...Object.values(this.#views).map(({ root: view }) => view));
    if (!hasVectors()) this.say("This browser has no vector instructions for WebAssembly: results are the same and take two to three times as long.");
    window.addEventListener("hashchange", () => { if (location.hash.slice(1) !== this.#link) void this.follow(location.hash); });
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => { this.#views[this.state.view].draw(); });
    document.addEventListener("dragover", (event) => { event.preventDefault(); });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.#dropped([...(event.dataTransfer?.files ?? [])]);
    });
    window.addEventListener("resize", () => { this.#views[this.state.view].draw(); });
  }

  say(message: string): void { this.#message.textContent = message; }

  open(view: View): void {
    this.state.view = view;
    this.#views.start.stop();
    for (const [name, { root }] of Object.entries(this.#views)) root.hidden = name !== view;
    for (const [name, made] of Object.entries(this.#tabs)) made.setAttribute("aria-selected", String(name === view));
    const exports = Object.entries(this.#views[view].exports()).map(([text, run]) => button(text, run));
    const copy = button("copy link", () => {
      void navigator.clipboard.writeText(location.href).then(() => { this.say("The link is on the clipboard; it holds all that is set here."); },
                                                             () => { this.say("The address of this page is the link: it holds all that is set here."); });
    });
    this.#exports.replaceChildren(copy, ...exports);
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
    this.state = state;
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

  #changed(): void {
    clearTimeout(this.#saving);
    this.#saving = window.setTimeout(() => {
      void encode(this.state).then((link) => {
        this.#link = link;
        history.replaceState(null, "", `#${link}`);
      });
    }, 250);
  }
}

async function start(): Promise<void> {
  const root = document.getElementById("page")!;
  try {
    const core = await Core.start();
    await readDescription(core);
    const page = new Page(core, initialState(), root);
    if (location.hash.length > 1) await page.follow(location.hash);
    else page.open("contact");
  } catch (error) {
    root.replaceChildren(element("p", { class: "message", role: "alert" }, `The explorer cannot start: ${error instanceof Error ? error.message : String(error)}.`));
  }
}

void start();
