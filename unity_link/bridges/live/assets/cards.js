// Cards: what belongs together in one plot, with values and ways to write.
//
// Signals of one component with the same unit share a plot; others have one of their own. A plot moves with the fastest
// of its streams, and signals of the others hold their latest value in it.

import { Control } from "./controls.js";
import { make, say } from "./dom.js";
import { History } from "./history.js";
import { makePlot, show } from "./plots.js";
import { stateNumbers, text } from "./values.js";

const MOST_CURVES = 6;

// Give the signals by cards.
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
      // Cards of one component differ by the unit.
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

  // Draw, once the element stands in the page.
  start() {
    if (!this.place) return;
    const curves = this.curves.map((signal) => ({ label: signal.name, stepped: stateNumbers(signal) !== null }));
    // What has states has no unit, and so a plot of its own.
    const [first] = this.curves;
    this.plot = makePlot(this.place, curves, stateNumbers(first), (state) => text(first, state));
  }

  // Draw if it can be seen; give how many plots were drawn.
  draw(until, window) {
    if (!this.plot || !this.visible) return 0;
    show(this.plot, this.history.rows, until, window);
    return 1;
  }

  // Keep what is shown, whatever comes.
  freeze(until, window) {
    if (this.plot) show(this.plot, this.history.rows.map((row) => row.slice()), until, window);
  }

  // Tell the values, if they can be seen: text that changes has the whole page laid out anew.
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
  // What arms, kicks and disarms is for programs; the page has a button.
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
