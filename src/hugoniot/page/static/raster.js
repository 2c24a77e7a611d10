"use strict";
// Fields on a canvas: zones over position and time, and quadrilaterals in the plane. Values are looked up in the arrays of the run.

// Records (nt, nzone) between which waves are carried along the direction in which they match best, as in the wave diagram of
// `hugoniot plot`; at the times of the records the field is the recorded one.
H.WaveField = class {
  constructor(times, left, right, values) {
    Object.assign(this, {times, left, right, values, zones: values.length / times.length, shifts: []});
    let low = Infinity, high = -Infinity;
    for (const v of values) { if (v < low) low = v; if (v > high) high = v; }
    Object.assign(this, {low, high});
  }
  record(t) {       // the nearest record
    const {times} = this;
    let a = 0, b = times.length - 1;
    while (b - a > 1) { const m = (a + b) >> 1; if (times[m] <= t) a = m; else b = m; }
    return times.length > 1 && t - times[a] > times[b] - t ? b : a;
  }
  zoneAt(k, x) {
    const n = this.zones, at = k * n;
    let a = 0, b = n - 1;
    while (b > a) { const m = (a + b + 1) >> 1; if (this.left[at + m] <= x) a = m; else b = m - 1; }
    return x >= this.left[at + a] && x <= this.right[at + a] ? a : -1;
  }
  paint(scale) {
    return (pixels, wide, high, xAxis, tAxis) => {
      const {times, left, right, values, zones: n} = this, last = times.length - 1, table = scale.ramp, factor = 255 / (scale.high - scale.low);
      let k = 0;
      for (let row = high - 1; row >= 0; row--) {
        const t = tAxis.value(tAxis.to + (row + 0.5) / high * (tAxis.from - tAxis.to));
        if (t < times[0] || t > times[last]) continue;
        while (k < last - 1 && times[k + 1] <= t) k++;
        while (k > 0 && times[k] > t) k--;
        const next = Math.min(k + 1, last), w = next > k ? (t - times[k]) / (times[next] - times[k]) : 0, a = k * n, b = next * n;
        const between = high * (times[next] - times[k]) / (tAxis.high - tAxis.low) > 1.5 && next > k, move = between ? this._moves(k) : null, near = w < 0.5 ? a : b;
        const from = xAxis.low, per = wide / (xAxis.high - xAxis.low), line = row * wide;
        for (let z = this._firstSeen(a, xAxis.low, n); z < n; z++) {
          const start = Math.max(0, Math.ceil(((1 - w) * left[a + z] + w * left[b + z] - from) * per - 0.5)), end = Math.min(wide - 1, Math.floor(((1 - w) * right[a + z] + w * right[b + z] - from) * per - 0.5));
          if (start >= wide) break;
          if (end < start) continue;
          let v;
          if (!between) v = values[near + z];
          else {
            const way = 2 * move.shift[z], before = Math.min(Math.max(z - Math.round(way * w), move.first[z]), move.last[z]), behind = Math.min(Math.max(z + Math.round(way * (1 - w)), move.first[z]), move.last[z]);
            v = (1 - w) * values[a + before] + w * values[b + behind];
          }
          const colour = table[Math.min(Math.max(Math.round((v - scale.low) * factor), 0), 255)];
          for (let col = start; col <= end; col++) pixels[line + col] = colour;
        }
      }
    };
  }
  _firstSeen(at, x, n) {      // some zones before the first that reaches x: between two records faces move
    let a = 0, b = n - 1;
    while (b > a) { const m = (a + b) >> 1; if (this.right[at + m] < x) a = m + 1; else b = m; }
    return Math.max(0, a - 40);
  }
  _moves(k) {       // of the interval after record k: by how many zones the field around each zone moves, half of it, body by body
    if (this.shifts[k]) return this.shifts[k];
    const {zones: n, left, right, values} = this, at = (k + 1) * n, least = 1e-6 * (right[at + n - 1] - left[at]);
    const shift = new Int16Array(n), first = new Int32Array(n), last = new Int32Array(n);
    for (let start = 0; start < n;) {
      let end = start;
      while (end < n - 1 && left[at + end + 1] - right[at + end] <= least) end++;
      first.fill(start, start, end + 1); last.fill(end, start, end + 1);
      this._match(k * n, at, start, end, shift);
      start = end + 1;
    }
    return this.shifts[k] = {shift, first, last};
  }
  _match(a, b, start, end, shift) {
    const n = end - start + 1, window = 7, most = Math.min(40, Math.floor(this.zones / 6)), half = window >> 1, {values} = this;
    const clip = z => Math.min(Math.max(z, start), end), best = new Float64Array(n).fill(Infinity), sums = new Float64Array(n + window + 1);
    const price = 2e-2 * window * (this.high - this.low) / Math.max(most, 1);
    for (let i = 0; i <= 2 * most; i++) {
      const m = i % 2 ? (i + 1) / 2 : -i / 2;        // small moves first: they win where many agree
      for (let j = 0; j < n + window; j++) { const z = start + j - half; sums[j + 1] = sums[j] + Math.abs(values[a + clip(z - m)] - values[b + clip(z + m)]); }
      for (let z = 0; z < n; z++) { const cost = sums[z + window] - sums[z] + price * Math.abs(m); if (cost < best[z] - 1e-12 * this.high) { best[z] = cost; shift[start + z] = m; } }
    }
  }
};

// Zones in the plane, `sides` nodes each: which zone each pixel belongs to.
H.PlaneField = class {
  constructor(corners, sides, x, y, mirror) { Object.assign(this, {corners, sides, x, y, mirror}); }
  zonesOf(wide, high, xAxis, yAxis) {
    const ids = new Int32Array(wide * high).fill(-1), {corners, sides, x, y} = this, sx = wide / (xAxis.high - xAxis.low), sy = high / (yAxis.high - yAxis.low);
    const px = new Float64Array(sides), py = new Float64Array(sides), count = corners.length / sides;
    for (const side of this.mirror ? [1, -1] : [1]) for (let z = 0; z < count; z++) {
      let low = Infinity, top = -Infinity;
      for (let c = 0; c < sides; c++) {
        const node = corners[sides * z + c];
        px[c] = (side * x[node] - xAxis.low) * sx - 0.5; py[c] = (yAxis.high - y[node]) * sy - 0.5;
        if (py[c] < low) low = py[c];
        if (py[c] > top) top = py[c];
      }
      for (let row = Math.max(0, Math.ceil(low)); row <= Math.min(high - 1, Math.floor(top)); row++) {
        let from = Infinity, to = -Infinity;
        for (let c = 0, d = sides - 1; c < sides; d = c++) {
          const y1 = py[d], y2 = py[c];
          if ((y1 < row && y2 < row) || (y1 > row && y2 > row)) continue;
          const v = y1 === y2 ? px[d] : px[d] + (row - y1) / (y2 - y1) * (px[c] - px[d]);
          if (v < from) from = v;
          if (v > to) to = v;
          if (y1 === y2) { if (px[c] < from) from = px[c]; if (px[c] > to) to = px[c]; }
        }
        for (let col = Math.max(0, Math.ceil(from)); col <= Math.min(wide - 1, Math.floor(to)); col++) ids[row * wide + col] = z;
      }
    }
    return ids;
  }
  paint(values, scale, mesh, regions) {
    return (pixels, wide, high, xAxis, yAxis, palette) => {
      const ids = this.zonesOf(wide, high, xAxis, yAxis), table = scale.ramp, factor = 255 / (scale.high - scale.low), ink = palette === H.palettes.dark ? 0xffe9ebed : 0xff222222;
      this.seen = {ids, wide, high, xAxis, yAxis};
      for (let i = 0; i < ids.length; i++) if (ids[i] >= 0) pixels[i] = table[Math.min(Math.max(Math.round((values[ids[i]] - scale.low) * factor), 0), 255)];
      for (let row = 0; row < high; row++) for (let col = 0; col < wide; col++) {
        const i = row * wide + col, z = ids[i], right = col + 1 < wide ? ids[i + 1] : z, below = row + 1 < high ? ids[i + wide] : z;
        if (right === z && below === z) continue;
        const edge = right < 0 || below < 0 || z < 0 || regions[right] !== regions[z] || regions[below] !== regions[z];
        if (edge) pixels[i] = ink; else if (mesh) pixels[i] = faded(pixels[i]);
      }
    };
  }
  zoneAt(x, y) {
    const s = this.seen;
    if (!s) return -1;
    const col = Math.floor((x - s.xAxis.low) / (s.xAxis.high - s.xAxis.low) * s.wide), row = Math.floor((s.yAxis.high - y) / (s.yAxis.high - s.yAxis.low) * s.high);
    return col >= 0 && row >= 0 && col < s.wide && row < s.high ? s.ids[row * s.wide + col] : -1;
  }
};
const faded = c => ((255 << 24) | (Math.round((c >> 16 & 255) * 0.7) << 16) | (Math.round((c >> 8 & 255) * 0.7) << 8) | Math.round((c & 255) * 0.7)) >>> 0;
H.thinned = (x, y, most = 1600) => {      // the lowest and the highest of each piece: what is drawn is what was recorded
  if (x.length <= 2 * most) return [Array.from(x), Array.from(y)];
  const xs = [], ys = [], step = x.length / most;
  for (let k = 0; k < most; k++) {
    const from = Math.floor(k * step), to = Math.min(Math.floor((k + 1) * step), x.length);
    let low = from, high = from;
    for (let i = from; i < to; i++) { if (y[i] < y[low]) low = i; if (y[i] > y[high]) high = i; }
    for (const i of low < high ? [low, high] : low > high ? [high, low] : [low]) { xs.push(x[i]); ys.push(y[i]); }
  }
  return [xs, ys];
};
