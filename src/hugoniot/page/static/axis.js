"use strict";
// Scales of a chart: round marks, their text, linear and logarithmic axes, and what is drawn with their pixels.
const FONT = '"DejaVu Sans", Verdana, Geneva, sans-serif';

H.ticks = (low, high, count) => {
  const span = high - low, raw = span / Math.max(count, 2), ten = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 2.5, 5, 10].map(k => k * ten).find(s => s >= raw * (1 - 1e-9));
  const found = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * span; k++) found.push(k * step);
  return found;
};
H.logTicks = (low, high) => {
  const found = [], decades = Math.log10(high / low), steps = decades > 5 ? [1] : decades > 1.5 ? [1, 2, 5] : [1, 1.5, 2, 3, 4, 5, 6, 8];
  for (let d = Math.floor(Math.log10(low)); d <= Math.ceil(Math.log10(high)); d++)
    for (const k of steps) { const v = k * 10 ** d; if (v >= low * (1 - 1e-9) && v <= high * (1 + 1e-9)) found.push(v); }
  return found;
};
const tickText = (value, step) => {
  const size = Math.abs(value);
  if (value === 0 || size < 1e-9 * step) return "0";
  if (size >= 1e5 || size < 1e-3) return value.toExponential(2).replace(/\.?0+e/, "e").replace("e+", "e").replace(/-/g, "−");
  let places = 0;
  while (places < 6 && Math.abs(step * 10 ** places - Math.round(step * 10 ** places)) > 1e-6 * step * 10 ** places) places++;
  return value.toFixed(places).replace("-", "−");
};

class Axis {
  constructor(low, high, from, to, log) { Object.assign(this, {low, high, from, to, log}); }
  at(value) {
    const w = this.log ? Math.log(value / this.low) / Math.log(this.high / this.low) : (value - this.low) / (this.high - this.low);
    return this.from + w * (this.to - this.from);
  }
  value(pixel) {
    const w = (pixel - this.from) / (this.to - this.from);
    return this.log ? this.low * (this.high / this.low) ** w : this.low + w * (this.high - this.low);
  }
}

const r1 = v => Math.round(v * 100) / 100;
const usable = (v, axis) => v !== null && Number.isFinite(v) && (!axis.log || v > 0);
const inside = (axis, v) => { const a = axis.at(v), low = Math.min(axis.from, axis.to), high = Math.max(axis.from, axis.to); return a >= low - 0.5 && a <= high + 0.5; };
function path(s, f) {      // points that fall on the same pixel as the last are left out, but for the end of a piece
  let d = "", pen = false, lastX = NaN, lastY = NaN, held = "";
  const n = s.x.length;
  for (let i = 0; i < n; i++) {
    const vx = s.x[i], vy = s.y[i];
    if (!usable(vx, f.x) || !usable(vy, f.y)) { d += held; held = ""; pen = false; continue; }
    const x = Math.min(Math.max(f.x.at(vx), -1e5), 1e5), y = Math.min(Math.max(f.y.at(vy), -1e5), 1e5);
    if (pen && Math.abs(x - lastX) < 0.4 && Math.abs(y - lastY) < 0.4) { held = `L${r1(x)} ${r1(y)}`; continue; }
    d += `${held}${pen ? "L" : "M"}${r1(x)} ${r1(y)}`;
    held = ""; pen = true; lastX = x; lastY = y;
  }
  return d + held;
}
function text(x, y, words, colour, size, anchor, more = {}, halo = null) {
  const around = halo ? {stroke: halo, "stroke-width": 3, "paint-order": "stroke", "stroke-linejoin": "round"} : {};
  return H.s("text", {x: r1(x), y: r1(y), fill: colour, "font-size": size, "font-family": FONT, "text-anchor": anchor, ...around, ...more}, words);
}
