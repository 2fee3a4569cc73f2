// The rows of one plot: instants, and the values of each curve. Their number is limited: if samples arrive faster than
// the plot has points, each bin of time keeps the lowest and highest value of each curve, so that peaks remain visible.

const BINS = 500; // bins across the plot: about one for each of its pixels
const MOST_ROWS = 8192;
const SET_ANEW = 1; // seconds by which an instant must be earlier to count as a restart of the gateway's clock
const AWAY = 1; // seconds of a gap after which values of other streams count as older than the gateway's absence

export class History {
  constructor(curves) {
    this.curves = curves; // source of each curve: { stream, column }
    this.rows = [[], ...curves.map(() => [])];
    this.values = curves.map(() => null);
    this.newest = -Infinity;
    this.bin = null;
    this.width = 0; // seconds of a bin; 0 if each sample is a row
  }

  // Add samples of the stream that leads this plot; curves of other streams keep their latest value.
  take(leader, batch, window) {
    const width = window / BINS;
    this.width = leader.rate * width > 2 ? width : 0;
    for (let i = 0; i < batch.count; i++) {
      let at = batch.at[i];
      if (at < this.newest - SET_ANEW) this.clear();
      at = Math.max(at, this.newest);
      if (batch.missing[i]) { // samples before this one were lost
        if (at - this.newest > AWAY) this.forgetOthers(leader, (this.newest + at) / 2);
        this.gap(at);
      }
      this.newest = at;
      // Use one array for all rows: this code runs for each sample, and garbage collection would delay drawing.
      const values = this.values;
      for (let curve = 0; curve < values.length; curve++) {
        const { stream, column } = this.curves[curve];
        values[curve] = stream === leader ? numberOrNothing(batch.columns[column][i]) : stream.latest[column];
      }
      if (this.width) this.collect(at, values);
      else this.push(at, values);
    }
    if (this.rows[0].length > MOST_ROWS) this.rows.forEach((row) => row.splice(0, MOST_ROWS / 2));
  }

  // End the curves with a gap.
  gap(at) {
    this.flush();
    this.push(at, this.curves.map(() => null));
  }

  forgetOthers(leader, until) {
    for (const { stream } of this.curves) if (stream !== leader) stream.forget(until);
  }

  clear() {
    this.rows.forEach((row) => (row.length = 0));
    this.bin = null;
    this.newest = -Infinity;
  }

  push(at, values) {
    this.flush();
    this.rows[0].push(at);
    values.forEach((value, curve) => this.rows[curve + 1].push(value));
  }

  collect(at, values) {
    const number = Math.floor(at / this.width);
    if (this.bin === null || this.bin.number !== number) {
      this.flush();
      this.bin = { number, first: at, last: at, low: values.slice(), high: values.slice(), rising: values.map(() => true) };
      return;
    }
    const { low, high, rising } = this.bin;
    this.bin.last = at;
    for (let curve = 0; curve < values.length; curve++) {
      const value = values[curve];
      if (value === null) continue;
      if (low[curve] === null || value < low[curve]) { low[curve] = value; rising[curve] = false; }
      if (high[curve] === null || value > high[curve]) { high[curve] = value; rising[curve] = true; }
    }
  }

  flush() {
    const bin = this.bin;
    if (bin === null) return;
    this.bin = null;
    this.push(bin.first, bin.low.map((low, curve) => (bin.rising[curve] ? low : bin.high[curve])));
    if (bin.last > bin.first) this.push(bin.last, bin.high.map((high, curve) => (bin.rising[curve] ? high : bin.low[curve])));
  }
}

function numberOrNothing(value) {
  return Number.isFinite(value) ? value : null;
}
