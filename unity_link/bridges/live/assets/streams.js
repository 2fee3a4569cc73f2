// Samples as they come, and the time that they are of.

export class Stream {
  constructor({ name, rate_hz: rate }, columns) {
    this.name = name;
    this.periodic = rate; // samples a second as the robot says; null where they are not periodic
    this.rate = rate ?? 0; // as they come
    this.latest = Array(columns).fill(null); // of the newest sample, for curves; null for a value that no curve can show
    this.newest = -Infinity;
    this.shown = Array(columns).fill(null); // of the newest sample, as it came; null for a value that is unknown
    this.cards = []; // whose plots move with it
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

  // Hold no value any longer that is from before an instant.
  forget(until = Infinity) {
    if (this.newest >= until) return;
    this.latest.fill(null);
    this.shown.fill(null);
  }

  // Note how many came within some seconds.
  measure(seconds) {
    const rate = this.counted / seconds;
    this.counted = 0;
    this.rate = this.periodic ?? rate;
    return rate;
  }
}

// Read a message of samples: a head, then batches of tables of doubles.
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

const SET_ANEW = 1; // seconds
const DRIFT = 1e-4; // seconds by which an estimate grows old with each message

// The other side's clock: of all messages the quickest tells best, and grows old slowly.
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
