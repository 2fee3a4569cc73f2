// Cards: each has one plot of signals that belong together, with their values and controls to write them.
//
// Signals of one component with the same unit share a plot; other signals have a plot each. A plot moves at the pace of
// the fastest of its streams; signals of the other streams keep their latest value in it.

import { Control } from "./controls.js";
import { make, say } from "./dom.js";
import { History } from "./history.js";
import { makePlot, show } from "./plots.js";
import { stateNumbers, text } from "./values.js";

const MOST_CURVES = 6;

// Return the signals of each card.
function sorted(signals) {
  const cards = new Map();
  for (const signal of signals) {
    const alone = signal.unit === "" || signal.stream === null;
    let key = JSON.stringify([signal.part, alone ? signal.name : signal.unit, alone]);
    while ((cards.get(key)?.length ?? 0) >= MOST_CURVES) key += "+";
    cards.set(key, [...(cards.get(key) ?? []), signal]);
  }
  return [...cards.values()];
}

export class Card {
  constructor(signals, about, streams, send) {
    this.signals = signals;
    this.values = new Map();
    this.visible = false;
    const [first] = signals;
    const alone = signals.length === 1;
    const heading = alone ? (first.part ? `${first.part}.${first.name}` : first.id) : first.part || about.robot;
    const doc = alone ? first.doc : about.parts[first.part];
    this.element = make(
      "article", { class: "card", "aria-label": `${heading} ${first.unit}` },
      // Cards of one component differ in the unit.
      make("h2", {}, heading, alone ? null : make("small", {}, first.unit), doc ? make("small", {}, doc) : null),
      make("ul", { class: "signals" }, ...signals.map((signal, number) => this.row(signal, number))),
    );
    this.curves = signals.filter((signal) => signal.stream !== null);
    if (this.curves.length) this.addPlot(streams);
    this.controls = about.writes ? signals.filter((signal) => signal.writable).map((signal) => new Control(signal, send)) : [];
    this.element.append(...this.controls.map((control) => control.element));
  }

  row(signal, number) {
    const value = make("output", {}, "–");
    this.values.set(signal.path, value);
    const swatch = make("span", { class: "swatch", "aria-hidden": "true" });
    swatch.style.background = signal.stream === null ? "transparent" : `var(--curve-${number % MOST_CURVES})`;
    const unit = signal.unit ? make("span", { class: "unit" }, signal.unit) : null;
    return make("li", { title: signal.doc, "data-signal": signal.path }, swatch, make("span", { class: "name" }, signal.name), value, unit);
  }

  addPlot(streams) {
    const places = this.curves.map(({ stream, column }) => ({ stream: streams[stream], column }));
    this.leader = places.map(({ stream }) => stream).reduce((fastest, stream) => ((stream.periodic ?? 0) > (fastest.periodic ?? 0) ? stream : fastest));
    this.history = new History(places);
    this.leader.cards.push(this);
    const names = this.curves.map(({ name }) => name).join(", ");
    this.place = make("div", { class: "plot", role: "img", "aria-label": `Curves of ${names} over time` });
    this.element.append(this.place);
  }

  // Make the plot, after the element was added to the page.
  start() {
    if (!this.place) return;
    const curves = this.curves.map((signal) => ({ label: signal.name, stepped: stateNumbers(signal) !== null }));
    // Signals with states have no unit, and so a plot each.
    const [first] = this.curves;
    this.plot = makePlot(this.place, curves, stateNumbers(first), (state) => text(first, state));
  }

  // Draw the plot if it is visible; return the number of plots drawn.
  draw(until, window) {
    if (!this.plot || !this.visible) return 0;
    show(this.plot, this.history.rows, until, window);
    return 1;
  }

  // Keep showing the present samples, whatever arrives later.
  freeze(until, window) {
    if (this.plot) show(this.plot, this.history.rows.map((row) => row.slice()), until, window);
  }

  // Show the values if the card is visible; changes of hidden text would cost a layout of the whole page.
  say(streams, exact, written) {
    if (!this.visible) return;
    for (const signal of this.signals) {
      if (signal.stream === null) continue;
      const value = streams[signal.stream].shown[signal.column];
      say(this.values.get(signal.path), exact[signal.path] ?? text(signal, value));
    }
    for (const control of this.controls) {
      const { stream, column, path } = control.signal;
      control.see(stream === null ? written[path] ?? null : streams[stream].shown[column], exact[path]);
    }
  }
}

export function makeCards(place, about, streams, send) {
  // Registers that arm, kick and disarm a lease are for programs; the page has a button to stop.
  const shown = about.signals.filter((signal) => signal.stream !== null || !about.leases.includes(signal.part));
  const cards = sorted(shown).map((signals) => new Card(signals, about, streams, send));
  place.replaceChildren(...cards.map((card) => card.element));
  const byElement = new Map(cards.map((card) => [card.element, card]));
  const watcher = new IntersectionObserver((seen) => seen.forEach((one) => (byElement.get(one.target).visible = one.isIntersecting)));
  cards.forEach((card) => {
    card.start();
    watcher.observe(card.element);
  });
  return cards;
}
