// Controls that write a signal: a slider and a number within its limits, a choice of names, or a switch.
//
// While a write is in flight, only the newest value waits, so dragging a slider does not fill a queue. After the user
// has released the control, it shows the robot's value again.
//
// The control of a signal with an unknown value shows no value and is disabled. If no group samples the signal, its
// value is unknown until it is written: then a number can be typed or a state chosen, but a single key press writes
// nothing.

import { make, say } from "./dom.js";
import { limit, stateNumbers, text } from "./values.js";

const WIDEST_SLIDER = 4096; // most steps for which a signal without limits of its own has a slider
const HOLD = 700; // milliseconds after a write for which the control keeps showing the written value

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
      // Do not round fractions: a rounded limit may be outside of the limit.
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
    // If there is no value, ignore these keys: the browser would step from 0, from a limit, or to the first state.
    input.addEventListener("keydown", (event) => {
      if (input.value === "" && /^(Arrow|Home|End|Page)/.test(event.key)) event.preventDefault();
    });
    const unit = this.signal.unit ? make("span", { class: "unit" }, this.signal.unit) : null;
    return make("div", { class: "control" }, label, slider, make("span", { class: "enter" }, input, unit), ends, this.answer);
  }

  // Write a value, as soon as the write before it has ended.
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

  // Show the robot's value; null if it is unknown. `exact` is the text of a whole number that a double cannot hold.
  see(value, exact) {
    this.known = value !== null;
    if (!this.underWay && performance.now() - this.touched >= HOLD) this.show(this.known && !Number.isNaN(value) ? value : null, exact);
    this.update();
  }

  show(value, exact) {
    const { slider, input, signal } = this;
    const place = Number.isFinite(value);
    if (slider) {
      // Without a value, hide the thumb, and let keys begin at the value nearest to 0.
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
