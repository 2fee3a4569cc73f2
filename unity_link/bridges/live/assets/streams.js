// Streams of samples from the server, and the server's clock.

export class Stream {
  constructor({ name, rate_hz: rate }, columns) {
    this.name = name;
    this.periodic = rate; // samples per second from the spec or the server; null if they are not periodic
    this.rate = rate ?? 0; // samples per second, measured if they are not periodic
    this.latest = Array(columns).fill(null); // values of the newest sample for curves; null for NaN and infinities
    this.newest = -Infinity;
    this.shown = Array(columns).fill(null); // values of the newest sample, unchanged; null for an unknown value
    this.cards = []; // cards whose plots this stream leads
    this.columns = columns;
    this.counted = 0;
  }

  take(batch, window) {
    this.counted += batch.count;
    for (const card of this.cards) card.history.take(this, batch, window);
    batch.columns.forEach((column, number) => {
      const value = column[batch.count - 1];
      this.shown[number] = value;
      this.latest[number] = Number.isFinite(value) ? value : null;
    });
    this.newest = batch.at[batch.count - 1];
  }

  // Forget the values, if the newest sample is from before an instant.
  forget(until = Infinity) {
    if (this.newest >= until) return;
    this.latest.fill(null);
    this.shown.fill(null);
  }

  // Measure the rate, over `seconds` since the last call.
  measure(seconds) {
    const rate = this.counted / seconds;
    this.counted = 0;
    this.rate = this.periodic ?? rate;
    return rate;
  }
}

// Yield the streams and batches of a message of samples: a head, then tables of doubles.
export function* batches(buffer, streams) {
  const view = new DataView(buffer);
  for (let place = 16; place < buffer.byteLength; ) {
    const stream = streams[view.getUint32(place, true)];
    const count = view.getUint32(place + 4, true);
    place += 8;
    const row = () => {
      const numbers = new Float64Array(buffer, place, count);
      place += 8 * count;
      return numbers;
    };
    yield [stream, { count, at: row(), missing: row(), columns: Array.from({ length: stream.columns }, row) }];
  }
}

export function head(buffer) {
  const view = new DataView(buffer);
  return { now: view.getFloat64(0, true), dropped: Number(view.getBigUint64(8, true)) };
}

const SET_ANEW = 1; // seconds by which an estimate must be off to begin again
const DRIFT = 1e-4; // seconds by which the estimate is reduced with each message

// The server's clock, estimated from the message with the least delay; the estimate is reduced slowly.
export class Clock {
  constructor() {
    this.ahead = null;
  }

  hear(now) {
    const ahead = now - performance.now() / 1000;
    const anew = this.ahead === null || Math.abs(ahead - this.ahead) > SET_ANEW;
    this.ahead = anew ? ahead : Math.max(ahead, this.ahead - DRIFT);
  }

  now() {
    return performance.now() / 1000 + (this.ahead ?? 0);
  }
}
