// The page: its connection to unity-link live, and the plots, which are drawn for each frame of the screen.

import { makeCards } from "./cards.js";
import { make, say } from "./dom.js";
import { makeLeases } from "./leases.js";
import { makeHistogram, refreshColors } from "./plots.js";
import { Clock, Stream, batches, head } from "./streams.js";
import { count, duration, roundDuration } from "./values.js";

const DELAY = 0.08; // seconds by which plots are delayed, so that samples arrive before their place is shown
const FIRST_PAUSE = 300; // milliseconds before the first attempt to connect again
const LONGEST_PAUSE = 2000;
const TEXTS_EVERY = 100; // milliseconds between updates of numbers: faster changes cannot be read
const BINS_PER_DECADE = 10;
const SHORTEST = -6; // decimal logarithm of the first bin of the histogram, in seconds

const at = (id) => document.getElementById(id);
const token = new URLSearchParams(location.hash.slice(1)).get("token") ?? "";
const clock = new Clock();

let socket = null;
let about = null;
let aboutText = "";
let streams = [];
let cards = [];
let leases = [];
let status = null;
let dropped = 0;
let window_ = 10;
let paused = false;
let pause = FIRST_PAUSE;
let questions = 0;
const answers = new Map();

// Counts of frames, plots and samples, for measurements of how smoothly the page runs.
const seen = (window.unityLink = { frames: 0, plots: 0, samples: 0, window: window_ });

// The connection

function open() {
  socket = new WebSocket(`ws://${location.host}/samples`);
  socket.binaryType = "arraybuffer";
  socket.onopen = () => {
    pause = FIRST_PAUSE;
    socket.send(JSON.stringify({ type: "hello", token }));
  };
  socket.onmessage = ({ data }) => (typeof data === "string" ? hear(data) : take(data));
  socket.onclose = ({ reason }) => {
    status = null;
    showState(reason);
    for (const answer of answers.values()) answer("the program has ended: it is not known whether this was written");
    answers.clear();
    setTimeout(open, pause);
    pause = Math.min(2 * pause, LONGEST_PAUSE);
  };
}

function hear(data) {
  const message = JSON.parse(data);
  if (message.type === "about") begin(message, data);
  else if (message.type === "status") note(message);
  else if (message.type === "welcome") welcome(message.may_write);
  else answer(message);
}

function take(buffer) {
  const { now, dropped: sofar } = head(buffer);
  clock.hear(now);
  if (sofar > dropped) for (const card of cards) card.history?.gap(card.history.newest);
  dropped = sofar;
  for (const [stream, batch] of batches(buffer, streams)) {
    stream.take(batch, window_);
    seen.samples += batch.count;
  }
}

function begin(message, data) {
  dropped = 0;
  if (data === aboutText) {
    // The same robot as before: keep the plots, with a gap.
    for (const card of cards) card.history?.gap(card.history.newest);
    for (const stream of streams) stream.forget();
    return;
  }
  [about, aboutText] = [message, data];
  document.title = `${about.robot} – Unity-Link`;
  say(at("robot"), about.robot);
  at("robot").title = about.doc;
  say(at("gateway"), about.gateway);
  streams = about.streams.map((stream, number) => new Stream(stream, about.signals.filter((signal) => signal.stream === number).length));
  cards = makeCards(at("cards"), about, streams, write);
  leases = makeLeases(at("leases"), about, stop);
}

function welcome(mayWrite) {
  for (const card of cards) card.controls.forEach((control) => control.enable(mayWrite));
  at("notice").hidden = mayWrite || !about.writes;
  if (!at("notice").hidden) {
    say(at("notice"), "This page may only look: the token in its address is missing or old. Open the link that unity-link live printed.");
  }
}

// Write a value; return the reason for a failure, or null.
function write(signal, value) {
  // JSON has whole numbers of any size, but JSON.stringify does not accept BigInt.
  const written = typeof value === "bigint" ? String(value) : JSON.stringify(value);
  return ask((number) => `{"type":"write","number":${number},"signal":${JSON.stringify(signal)},"value":${written}}`);
}

// Disarm a lease; return the reason for a failure, or null.
function stop(lease) {
  return ask((number) => JSON.stringify({ type: "stop", number, lease }));
}

function ask(question) {
  if (socket.readyState !== WebSocket.OPEN) return Promise.resolve("the program has ended: nothing was written");
  const number = questions++;
  socket.send(question(number));
  return new Promise((resolve) => answers.set(number, resolve));
}

function answer({ number, reason }) {
  answers.get(number)?.(reason ?? null);
  answers.delete(number);
}

// The link

function note(message) {
  const before = status;
  status = message;
  if (before?.connected !== status.connected || before.refusal !== status.refusal) showState();
  say(at("lost"), count(status.lost));
  at("lost").classList.toggle("bad", status.lost > 0);
  say(at("round-trip"), duration(status.round_trips.median));
}

function showState(reason) {
  const fault = status === null ? reason || "unity-link live has ended" : status.connected ? status.refusal : "gateway away";
  at("state").dataset.state = fault ? "bad" : "good";
  say(at("state"), fault || "connected");
}

function facts(rate, pictures) {
  const { link, round_trips: trips } = status;
  return [
    ["samples", count(status.samples)],
    ["samples/s", count(Math.round(rate))],
    ["lost on the way here", count(status.lost)],
    ["not shown: this page was too slow", count(dropped)],
    ["pictures/s", paused ? "paused" : String(Math.round(pictures))],
    ["round trip, median", duration(trips.median)],
    ["round trip, 99 % within", duration(trips.within)],
    ["requests", count(link.requests)],
    ["sent again", count(link.repetitions)],
    ["frames damaged", count(link.damaged_frames)],
    ["reconnections", count(link.reconnections)],
  ];
}

function listFacts(list) {
  const place = at("facts");
  if (place.childElementCount !== 2 * list.length) place.replaceChildren(...list.flatMap(([name]) => [make("dt", {}, name), make("dd", {})]));
  list.forEach(([, value], number) => say(place.children[2 * number + 1], value));
}

// The plots

let histogram = null;
let lastTexts = 0;
let lastSecond = performance.now();
let framesThen = 0;
let samplesPerSecond = 0;
let picturesPerSecond = 0;

function draw(now) {
  requestAnimationFrame(draw);
  seen.frames++;
  if (now - lastSecond >= 1000) {
    picturesPerSecond = (1000 * (seen.frames - framesThen)) / (now - lastSecond);
    samplesPerSecond = streams.reduce((sum, stream) => sum + stream.measure((now - lastSecond) / 1000), 0);
    [lastSecond, framesThen] = [now, seen.frames];
    if (status) drawHistogram(status.round_trips.counts);
  }
  if (!paused) for (const card of cards) seen.plots += card.draw(clock.now() - DELAY, window_);
  if (now - lastTexts >= TEXTS_EVERY) {
    lastTexts = now;
    showTexts();
  }
}

function showTexts() {
  if (!paused) cards.forEach((card) => card.say(streams, status?.exact ?? {}, status?.written ?? {}));
  leases.forEach((lease) => lease.say(streams));
  if (status) {
    say(at("rate"), count(Math.round(samplesPerSecond)));
    listFacts(facts(samplesPerSecond, picturesPerSecond));
  }
}

function drawHistogram(counts) {
  const first = Math.max(0, counts.findIndex(Boolean) - 3);
  const last = counts.findLastIndex(Boolean) + 4;
  if (last < 4) return;
  const shown = counts.slice(first, last);
  const places = shown.map((_, number) => SHORTEST + (first + number + 0.5) / BINS_PER_DECADE);
  histogram ??= makeHistogram(at("histogram"), roundDuration);
  histogram.setData([places, shown]);
}

// The tools

const readWindow = () => (seen.window = window_ = Number(at("window").value));
at("window").addEventListener("change", readWindow);
addEventListener("pageshow", readWindow); // a browser that returns to the page restores the chosen option

// After a restart of the program only the token in the address differs. Browsers do not reload the page for that.
addEventListener("hashchange", () => location.reload());

at("pause").addEventListener("click", () => {
  paused = !paused;
  at("pause").setAttribute("aria-pressed", String(paused));
  say(at("pause"), paused ? "Go on" : "Pause");
  if (paused) cards.forEach((card) => card.freeze(clock.now() - DELAY, window_));
});

const THEMES = [["", "Auto", "as the system says"], ["light", "Light", "light"], ["dark", "Dark", "dark"]];

function choose(theme) {
  const [name, label, spoken] = THEMES.find(([known]) => known === theme) ?? THEMES[0];
  document.documentElement.dataset.theme = name;
  say(at("theme"), label);
  at("theme").setAttribute("aria-label", `Colours: ${spoken}`);
  recolor();
}

function recolor() {
  refreshColors();
  cards.forEach((card) => card.plot?.redraw(false));
  histogram?.redraw(false);
}

at("theme").addEventListener("click", () => {
  const next = (THEMES.findIndex(([name]) => name === (document.documentElement.dataset.theme ?? "")) + 1) % THEMES.length;
  localStorage.setItem("theme", THEMES[next][0]);
  choose(THEMES[next][0]);
});
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolor);

choose(localStorage.getItem("theme") ?? "");
open();
requestAnimationFrame(draw);
