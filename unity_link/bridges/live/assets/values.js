// Numbers as texts for people.

const MOST_DECIMALS = 4;

export function decimals(signal) {
  if (signal.step === null || signal.step >= 1 && Number.isInteger(signal.step)) return signal.step === null ? null : 0;
  return Math.min(MOST_DECIMALS, Math.max(1, Math.ceil(-Math.log10(signal.step))));
}

// Return the numbers of the states that a signal can be in; null for a signal without states.
export function stateNumbers({ kind, names }) {
  if (kind === "bool") return [0, 1];
  return kind === "enum" ? names.map(([number]) => number) : null;
}

// Return the text of a signal's value; a dash for an unknown value.
export function text(signal, value) {
  if (value === null || value === undefined) return "–";
  if (Number.isNaN(value)) return "not a number";
  if (signal.kind === "bool") return value ? "on" : "off";
  if (signal.kind === "enum") return signal.names.find(([number]) => number === value)?.[1] ?? String(value);
  const behind = decimals(signal);
  if (behind === null) return Number.isFinite(value) ? Number(value.toPrecision(6)).toString() : String(value);
  const written = value.toFixed(behind);
  return Number(written) === 0 ? (0).toFixed(behind) : written;
}

export function duration(seconds) {
  if (seconds === null) return "–";
  const [factor, unit] = seconds < 0.9995e-3 ? [1e6, "µs"] : seconds < 0.9995 ? [1e3, "ms"] : [1, "s"];
  return `${(seconds * factor).toPrecision(3)} ${unit}`;
}

// Return the text of a round duration, without trailing zeros.
export function roundDuration(seconds) {
  const [number, unit] = duration(seconds).split(" ");
  return `${Number(number)} ${unit}`;
}

// Return the shortest text of a limit.
export function limit(signal, value) {
  const behind = decimals(signal);
  return String(Number(behind === null ? value.toPrecision(6) : value.toFixed(behind)));
}

export function count(number) {
  return number.toLocaleString("en");
}
