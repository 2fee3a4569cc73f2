// The leases of the robot: the state of each, and a button that disarms it, which needs no token.

import { make, say } from "./dom.js";
import { text } from "./values.js";

export class Lease {
  constructor(path, about, stop) {
    const find = (name) => about.signals.find((signal) => signal.path === `${path}.${name}`);
    [this.state, this.reason] = [find("state"), find("reason")];
    this.output = make("output", {}, "–");
    this.answer = make("span", { class: "answer", role: "status" });
    const button = make("button", { type: "button", class: "stop", "aria-label": `Stop ${path}` }, "Stop");
    button.addEventListener("click", async () => say(this.answer, (await stop(path)) ?? ""));
    this.element = make("div", { class: "lease", "data-lease": path }, make("span", { class: "name" }, path), this.output, button, this.answer);
  }

  // Show the state, and for a fault its reason.
  say(streams) {
    // If no group of the lease is sampled, no state can be shown.
    const value = (signal) => (signal ? streams[signal.stream].shown[signal.column] : null);
    const state = text(this.state, value(this.state));
    this.element.dataset.state = state;
    say(this.output, state === "fault" ? `${state}: ${text(this.reason, value(this.reason))}` : state);
  }
}

export function makeLeases(place, about, stop) {
  const leases = about.leases.map((path) => new Lease(path, about, stop));
  place.replaceChildren(...leases.map((lease) => lease.element));
  place.hidden = !leases.length;
  return leases;
}
