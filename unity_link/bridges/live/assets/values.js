// Numbers as people read them.

const MOST_DECIMALS = 4;

export function decimals(signal) {
  if (signal.step === null || signal.step >= 1 && Number.isInteger(signal.step)) return signal.step === null ? null : 0;
  return Math.min(MOST_DECIMALS, Math.max(1, Math.ceil(-Math.log10(signal.step))));
}

// Give the names of the numbers that a signal may be, as [number, name]: none where these are only numbers.
export function namesOf(signal) {
  return signal.kind === "bool" ? [[0, "off"], [1, "on"]] : signal.names;
}

// Write a value of a signal; nothing for one that never came.
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

// The same for a round number.
export function roundDuration(seconds) {
  const [number, unit] = duration(seconds).split(" ");
  return `${Number(number)} ${unit}`;
}

// Write a limit: as short as it can be.
export function limit(signal, value) {
  const behind = decimals(signal);
  return String(Number(behind === null ? value.toPrecision(6) : value.toFixed(behind)));
}

export function count(number) {
  return number.toLocaleString("en");
}
