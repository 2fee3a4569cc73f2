// Ways to write a signal: a slider and a number within its limits, a choice of names, a switch.
//
// While a value is under way, only the newest one waits: a slider that is dragged does not leave a queue behind. The
// robot's value is shown again after the user has released the control.
//
// A control of a signal whose value is unknown shows none, and is disabled. If nothing samples the signal, its value is
// unknown until it is written: then a number can be typed and a state chosen, which no single key press does by mistake.

import { make, say } from "./dom.js";
import { limit, stateNumbers, text } from "./values.js";

const WIDEST_SLIDER = 4096; // steps of a signal without limits of its own that still make a slider
const HOLD = 700; // milliseconds that a written value is left alone

export class Control {
  constructor(signal, send) {
    this.signal = signal;
    this.send = send;
    this.underWay = false;
    this.waiting = null;
    this.touched = -Infinity;
    this.allowed = false;
    this.known = false;
    this.answer = make("p", { class: "answer", role: "status" });
    this.element = this.build();
    this.show(null);
    this.update();
  }

  build() {
    const { signal } = this;
    const id = `write-${signal.path}`;
    const label = make("label", { for: id, title: signal.doc }, signal.name);
    if (signal.kind === "bool" && signal.stream !== null) {
      const input = make("input", { id, type: "checkbox", class: "switch", onchange: () => this.want(input.checked) });
      this.reflect = (value) => ([input.checked, input.indeterminate] = [Boolean(value), false]);
      this.clear = () => (input.indeterminate = true);
      return this.compose(label, null, input);
    }
    const states = stateNumbers(signal);
    return states === null ? this.buildNumber(id, label) : this.buildChoice(id, label, states);
  }

  buildChoice(id, label, states) {
    const { signal } = this;
    const options = states.map((state) => make("option", { value: state }, text(signal, state)));
    const none = make("option", { value: "", hidden: true }, "–");
    const input = make("select", { id, onchange: () => this.want(signal.kind === "bool" ? input.value === "1" : Number(input.value)) }, none, ...options);
    this.reflect = (value) => (input.value = String(Number(value)));
    this.clear = () => (input.value = "");
    return this.compose(label, null, input);
  }

  buildNumber(id, label) {
    const { signal } = this;
    const number = make("input", {
      id, type: "number", step: "any", min: signal.low, max: signal.high, inputmode: "decimal", autocomplete: "off", placeholder: "–",
    });
    const { low, high, step } = signal;
    const narrow = low !== null && high !== null && (signal.limited || (high - low) / (step ?? 1) <= WIDEST_SLIDER);
    const slider = narrow ? make("input", { type: "range", min: low, max: high, step: "any", "aria-label": `${signal.path}, slider` }) : null;
    const write = (value) => limit(signal, value);
    number.addEventListener("change", () => {
      if (number.value === "" || !Number.isFinite(number.valueAsNumber)) return this.refuse("a number was expected");
      if (slider) slider.value = number.value;
      const whole = Number.isInteger(step) && /^-?\d+$/.test(number.value);
      this.want(whole ? BigInt(number.value) : number.valueAsNumber);
    });
    slider?.addEventListener("input", () => {
      // Fractions go as they are, for a limit that was rounded may be beyond the limit.
      const value = Number.isInteger(step) ? Math.round(slider.valueAsNumber) : slider.valueAsNumber;
      number.value = write(value);
      this.want(value);
    });
    this.reflect = (value, exact) => {
      const written = exact ?? write(value);
      if (number.value !== written) number.value = written;
    };
    this.clear = () => (number.value = "");
    const ends = slider && make("div", { class: "ends", "aria-hidden": "true" }, make("span", {}, limit(signal, low)), make("span", {}, limit(signal, high)));
    return this.compose(label, slider, number, ends);
  }

  compose(label, slider, input, ends = null) {
    [this.slider, this.input] = [slider, input];
    // A browser steps from 0, from a limit, or to the first state.
    input.addEventListener("keydown", (event) => {
      if (input.value === "" && /^(Arrow|Home|End|Page)/.test(event.key)) event.preventDefault();
    });
    const unit = this.signal.unit ? make("span", { class: "unit" }, this.signal.unit) : null;
    return make("div", { class: "control" }, label, slider, make("span", { class: "enter" }, input, unit), ends, this.answer);
  }

  // Have a value written as soon as the one before is.
  want(value) {
    this.touched = performance.now();
    this.waiting = { value };
    this.next();
  }

  async next() {
    if (this.underWay || this.waiting === null) return;
    const { value } = this.waiting;
    this.waiting = null;
    this.underWay = true;
    const reason = await this.send(this.signal.path, value);
    this.underWay = false;
    this.touched = performance.now();
    this.refuse(reason);
    this.next();
  }

  refuse(reason) {
    say(this.answer, reason ?? "");
  }

  // Show the robot's value, of a wide whole number also exactly, as text; null for a value that is unknown.
  see(value, exact) {
    this.known = value !== null;
    if (!this.underWay && performance.now() - this.touched >= HOLD) this.show(this.known && !Number.isNaN(value) ? value : null, exact);
    this.update();
  }

  show(value, exact) {
    const { slider, input, signal } = this;
    const place = Number.isFinite(value);
    if (slider) {
      // Without a value the thumb is hidden, and the keys begin nearest to 0.
      slider.value = place ? value : Math.min(Math.max(signal.low, 0), signal.high);
      slider.toggleAttribute("data-unknown", !place);
    }
    const typing = input === document.activeElement && input.type === "number" && !input.disabled;
    if (typing) return;
    if (value === null) this.clear();
    else this.reflect(value, exact);
  }

  enable(allowed) {
    this.allowed = allowed;
    this.update();
  }

  update() {
    this.input.disabled = !this.allowed || !(this.known || this.signal.stream === null);
    if (this.slider) this.slider.disabled = !this.allowed || this.slider.hasAttribute("data-unknown");
  }
}
