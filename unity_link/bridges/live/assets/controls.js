// Ways to write a signal: a slider and a number within its limits, a choice of names, a switch.
//
// While a value is under way, only the newest one waits: a slider that is dragged does not leave a queue behind. What
// the robot says is shown again as soon as nobody is holding the control.

import { make, say } from "./dom.js";
import { decimals, limit } from "./values.js";

const WIDEST_SLIDER = 4096; // steps of a signal without limits of its own that still make a slider
const HOLD = 700; // milliseconds that a written value is left alone

export class Control {
  constructor(signal, send) {
    this.signal = signal;
    this.send = send;
    this.underWay = false;
    this.waiting = null;
    this.touched = -Infinity;
    this.answer = make("p", { class: "answer", role: "status" });
    this.inputs = [];
    this.element = this.build();
  }

  build() {
    const { signal } = this;
    const id = `write-${signal.path}`;
    const label = make("label", { for: id, title: signal.doc }, signal.name);
    if (signal.kind === "bool") {
      const input = make("input", { id, type: "checkbox", class: "switch", onchange: () => this.want(input.checked) });
      this.reflect = (value) => (input.checked = Boolean(value));
      return this.compose(label, null, input);
    }
    if (signal.kind === "enum") {
      const options = signal.names.map(([number, name]) => make("option", { value: number }, name));
      const input = make("select", { id, onchange: () => this.want(Number(input.value)) }, ...options);
      this.reflect = (value) => (input.value = String(value));
      return this.compose(label, null, input);
    }
    return this.buildNumber(id, label);
  }

  buildNumber(id, label) {
    const { signal } = this;
    const number = make("input", {
      id, type: "number", step: "any", min: signal.low, max: signal.high, inputmode: "decimal", autocomplete: "off",
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
      if (slider) slider.value = value;
    };
    const ends = slider && make("div", { class: "ends", "aria-hidden": "true" }, make("span", {}, limit(signal, low)), make("span", {}, limit(signal, high)));
    return this.compose(label, slider, number, ends);
  }

  compose(label, slider, input, ends = null) {
    this.inputs = [slider, input].filter(Boolean);
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

  // Show what the robot says; of a wide whole number also exactly, as text.
  see(value, exact) {
    const held = this.underWay || performance.now() - this.touched < HOLD || this.inputs.includes(document.activeElement) && document.activeElement.type === "number";
    if (!held && value !== null && value !== undefined && !Number.isNaN(value)) this.reflect(value, exact);
  }

  enable(allowed) {
    this.inputs.forEach((input) => (input.disabled = !allowed));
  }
}
