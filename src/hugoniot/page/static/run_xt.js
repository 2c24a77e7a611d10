"use strict";
// The x-t map of a run: a field over position and time, interfaces and gauges as lines, the value of the zone under the pointer.
H.XtMap = class {
  constructor(host, hooks) {
    this.hooks = hooks;
    this.chart = new H.Chart(host, {label: "Field over position and time", height: 0.62, most: 600, keep: true, zoomKey: "xt", onHover: hit => hooks.onHover(hit), onPick: hit => hooks.onPick(hit)});
  }
  show(run, data) {
    const {times, left, right, values, field} = data, n = values.shape[1];
    const wave = this.wave?.source === values ? this.wave : new H.WaveField(times, left.data, right.data, values.data);
    wave.source = values;
    this.wave = wave;
    const [xUnit, fx] = H.lengthUnit(this._extent(left.data, right.data, n).reduce((a, b) => b - a)), [tUnit, ft] = H.timeUnit(times.at(-1) || run.stop_time || 1e-6);
    const scale = H.scaleOf(wave.low, wave.high), [unit, factor] = field.unit === "Pa" ? H.fits([wave.low, wave.high], "GPa", 1e-9) : [field.shown, field.factor];
    Object.assign(this, {fx, ft, xUnit, tUnit, unit, factor, field});
    const [low, high] = this._extent(left.data, right.data, n), series = [];
    const edge = (array, zone) => ({kind: "line", colour: "ink", width: 0.9, hover: false, x: Array.from(times, (_, k) => array[k * n + zone] * fx), y: Array.from(times, t => t * ft)});
    for (const r of run.regions) series.push(edge(left.data, r.first), edge(right.data, r.last));
    for (const g of data.gauges || []) series.push({kind: "line", colour: "ink", dash: "1.5 3", width: 1, hover: false, x: g.position.map(v => v * fx), y: g.time.map(t => t * ft)});
    const heads = run.regions.map(r => ({x: 0.5 * (left.data[(times.length - 1) * n + r.first] + right.data[(times.length - 1) * n + r.last]) * fx, label: r.name})).filter(h => h.x > low * fx && h.x < high * fx);
    // SVG axes are in the shown units; the painter works in SI
    const inSi = (axis, f) => ({low: axis.low / f, high: axis.high / f, from: axis.from, to: axis.to, value: at => axis.value(at) / f});
    const painter = wave.paint(scale);
    this.chart.show({series, marks: [...(data.marks || [])], heads: spaced(heads, (high - low) * fx), plain: true, x: {label: H.labelled(run.geometry === "planar" ? "position" : "radius", xUnit), min: low * fx, max: high * fx}, y: {label: `${H.labelled("time", tUnit)}, ${times.length} snapshot${times.length === 1 ? "" : "s"}`, min: times[0] * ft, max: times.at(-1) * ft || 1},
      bar: {scale, factor, label: H.labelled(field.words, unit)},
      paint: (pixels, wide, tall, x, y, p) => painter(pixels, wide, tall, inSi(x, fx), inSi(y, ft), p),
      readings: (x, y) => { const record = wave.record(y / ft), zone = wave.zoneAt(record, x / fx); return {record, zone, x: x / fx, t: times[record], value: zone < 0 ? null : values.data[record * n + zone]}; }});
  }
  _extent(left, right, n) {      // no further out than the bodies are wide together at the start
    const count = left.length / n, first = [left[0], right[n - 1]], room = 0.6 * (first[1] - first[0]);
    let low = first[0], high = first[1];
    for (let k = 0; k < count; k++) { low = Math.min(low, left[k * n]); high = Math.max(high, right[k * n + n - 1]); }
    return [Math.max(low, first[0] - room), Math.min(high, first[1] + room)];
  }
};
function spaced(heads, span) {
  let taken = -Infinity;
  return heads.sort((a, b) => a.x - b.x).filter(h => { const half = 0.006 * h.label.length * span; if (h.x - half < taken) return false; taken = h.x + half; return true; });
}
