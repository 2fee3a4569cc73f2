// Scrolling plots by uPlot. The axis of time does not move; the curves move below it.

/* global uPlot */

const AXIS = 54; // pixels for the axis of values
const STATES = 90; // pixels for the names of states beside a plot
const POINT = 5; // diameter in pixels of a value without neighbours
const WIDTH = 1; // pixels of a curve; without a graphics card, wider curves take twice the time to draw

export function color(name) {
  // A canvas cannot evaluate light-dark(), so let an element compute the colour.
  probe.style.color = `var(--${name})`;
  return getComputedStyle(probe).color;
}

const probe = document.createElement("i");
probe.hidden = true;
document.documentElement.append(probe);

let colors = {};

// Read the colours of the page again, after a change between light and dark.
export function refreshColors() {
  colors = {};
}

function known(name) {
  return (colors[name] ??= color(name));
}

const font = "11px system-ui, 'DejaVu Sans', sans-serif";

function axis(more) {
  return {
    stroke: () => known("quiet"),
    font,
    grid: { stroke: () => known("grid"), width: 1 },
    ticks: { show: false },
    ...more,
  };
}

function range(plot, low, high) {
  if (low === null || high === null) return [0, 1];
  if (high - low > 1e-9 * Math.max(Math.abs(low), Math.abs(high))) return uPlot.rangeNum(low, high, 0.12, true);
  const room = Math.abs(high) * 0.1 || 1;
  return [low - room, high + room];
}

// Join lines without uPlot's round corners, which take time and are not visible with so many points.
function plainJoins(plot) {
  plot.ctx.lineJoin = "bevel";
}

// Return the axis and the range of states: all states are shown in the plot by their names, at fixed places.
function stateAxis(states, name) {
  const [low, high] = [Math.min(...states), Math.max(...states)];
  const room = 0.15 * (high - low) || 1;
  return {
    range: () => [low - room, high + room],
    axis: axis({ splits: () => states, values: (plot, at) => at.map(name), size: STATES }),
  };
}

// Make a plot of curves { label, stepped } in an element; the caller sets its data and window of time. For curves of
// states, `states` has the numbers of the states, and `name` returns the name of one.
export function makePlot(element, curves, states, name) {
  const y = states === null ? { range, axis: axis({ size: AXIS, gap: 4 }) } : stateAxis(states, name);
  const splits = (plot, _, from, to) => {
    const seconds = to - from;
    const step = seconds > 40 ? 10 : seconds > 15 ? 5 : seconds > 6 ? 2 : seconds > 3 ? 1 : 0.5;
    const places = [];
    for (let back = 0; back <= seconds + 1e-9; back += step) places.unshift(to - back);
    return places;
  };
  const plot = new uPlot(
    {
      width: Math.max(element.clientWidth, 50),
      height: element.clientHeight,
      padding: [8, 16, 0, 0],
      legend: { show: false },
      hooks: { drawClear: [plainJoins] },
      cursor: { drag: { x: false, y: false }, points: { show: false }, y: false },
      scales: { x: { time: false, auto: false }, y: { range: y.range } },
      axes: [
        axis({ splits, values: (plot, at) => at.map((one) => (at.at(-1) - one < 1e-6 ? "now" : `−${+(at.at(-1) - one).toFixed(1)} s`)), size: 26 }),
        y.axis,
      ],
      series: [
        {},
        ...curves.map(({ label, stepped }, number) => ({
          label,
          stroke: () => known(`curve-${number % 6}`),
          width: WIDTH,
          points: { show: false, filter: alone, size: POINT, fill: () => known(`curve-${number % 6}`) },
          paths: stepped ? uPlot.paths.stepped({ align: 1 }) : undefined,
        })),
      ],
    },
    [[], ...curves.map(() => [])],
    element,
  );
  new ResizeObserver(() => plot.setSize({ width: Math.max(element.clientWidth, 50), height: element.clientHeight })).observe(element);
  return plot;
}

// Return the places of values without neighbours, to which no line leads; null if there are none.
function alone(plot, curve) {
  const values = plot.data[curve];
  const [first, last] = plot.series[0].idxs;
  const places = [];
  for (let i = first; i <= last; i++) {
    if (isThere(values[i]) && !isThere(values[i - 1]) && !isThere(values[i + 1])) places.push(i);
  }
  return places.length ? places : null;
}

const isThere = (value) => value !== null && value !== undefined;

// Show the rows from `until - window` to `until`.
export function show(plot, rows, until, window) {
  plot.batch(() => {
    plot.setData(rows, false);
    plot.setScale("x", { min: until - window, max: until });
  });
}

// Make a histogram with bins of equal ratio; the numbers of bins are logarithms.
export function makeHistogram(element, label) {
  const plot = new uPlot(
    {
      width: Math.max(element.clientWidth, 50),
      height: element.clientHeight,
      padding: [8, 16, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: (plot, low, high) => [low, high] }, y: { range: (plot, low, high) => [0, Math.max(high, 1) * 1.08] } },
      axes: [
        axis({ splits: (plot, _, from, to) => ticks(from, to), values: (plot, at) => at.map((one) => label(10 ** one)), size: 26, grid: { show: false } }),
        axis({ size: AXIS, gap: 4 }),
      ],
      series: [
        {},
        {
          stroke: () => known("accent"),
          fill: () => known("accent"),
          width: 0,
          points: { show: false },
          paths: uPlot.paths.bars({ size: [0.86, 60], radius: 0.15 }),
        },
      ],
    },
    [[], []],
    element,
  );
  new ResizeObserver(() => plot.setSize({ width: Math.max(element.clientWidth, 50), height: element.clientHeight })).observe(element);
  return plot;
}

function ticks(from, to) {
  const all = [];
  const parts = to - from > 2 ? [1] : [1, 2, 5];
  for (let decade = Math.floor(from); decade <= to; decade++) {
    for (const part of parts) {
      const at = decade + Math.log10(part);
      if (at >= from && at <= to) all.push(at);
    }
  }
  return all;
}
