// A short tour of five steps: each sets a state, lights one place up and waits for the hand. Esc ends it.

import { button, element } from "./elements.ts";
import { initialState, type State } from "./state.ts";

interface Step { words: string; lights: string; set: (state: State) => void }

const rail = "section[aria-label='Wheel on rail'] ";
const steps: readonly Step[] = [
  { words: "This is a wheel on its rail, cut open. They touch in a patch as large as a fingernail; it carries 8 tonnes.", lights: `${rail}.pinned`, set: (state) => { state.view = "rail"; } },
  { words: "Drag the wheel to the left. The contact wanders to the gauge side, and the rolling radius grows.", lights: `${rail}.pinned`, set: (state) => { state.view = "rail"; } },
  { words: "Two wheels on one axle turn equally fast. The one on the larger radius runs ahead and steers the wheelset back.", lights: `${rail}.panel:has(.pair)`, set: (state) => { state.view = "rail"; } },
  { words: "In the patch a part sticks (blue), a part slides (orange). Turn the wheelset a little by the handle at the rail head: more slides.", lights: `${rail}.pinned`, set: (state) => { state.view = "rail"; state.rail.values["wheel.yaw"] = 0.002; } },
  { words: "Now inside the contact. Brake harder: the orange grows until all slides, and the force stays at friction times load.", lights: "section[aria-label='Contact'] .main", set: (state) => { state.view = "contact"; } },
];

export class Tour {
  readonly #words = element("p", { "aria-live": "polite" });
  readonly #head = element("b");
  readonly #back = button("Back", () => { this.#go(this.#at - 1); });
  readonly #next = button("Next", () => { if (this.#at + 1 < steps.length) this.#go(this.#at + 1); else this.end(); });
  readonly root = element("div", { class: "tour", role: "dialog", "aria-label": "tour", hidden: "" }, this.#head, this.#words,
    element("div", { class: "steps" }, button("End the tour", () => { this.end(); }), this.#back, this.#next));
  #at = 0;

  constructor(readonly show: (state: State) => void) {
    this.#next.className = "primary";
    document.addEventListener("keydown", (event) => { if (event.key === "Escape") this.end(); });
  }

  start(): void { this.#go(0); }

  end(): void {
    this.root.hidden = true;
    document.querySelector(".lit")?.classList.remove("lit");
  }

  #go(at: number): void {
    const step = steps[at]!, state = initialState();
    this.#at = at;
    step.set(state);
    this.show(state);
    document.querySelector(".lit")?.classList.remove("lit");
    const lit = document.querySelector(step.lights);
    lit?.classList.add("lit");
    lit?.scrollIntoView({ block: "nearest", behavior: matchMedia("(prefers-reduced-motion: reduce)").matches ? "auto" : "smooth" });
    this.root.hidden = false;
    this.#head.textContent = `Tour, ${String(at + 1)} of ${String(steps.length)}`;
    this.#words.textContent = step.words;
    this.#back.disabled = at === 0;
    this.#next.textContent = at + 1 < steps.length ? "Next" : "Done";
    this.#next.focus({ preventScroll: true });
  }
}
