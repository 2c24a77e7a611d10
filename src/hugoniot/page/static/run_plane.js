"use strict";
// A two-dimensional run: a field over the plane at one time, with outlines, mesh, mirror, and the zone under the pointer.
H.PlaneMap = class {
  constructor(host, hooks) {
    this.chart = new H.Chart(host, {label: "Field in the plane", height: 0.75, most: 640, keep: true, zoomKey: "map", onHover: hooks.onHover, onPick: hooks.onPick});
  }
  show(run, data) {
    const {x, y, values, field, limits} = data, mirror = run.geometry === "axisymmetric" && H.get("mirror") !== "0", plane = new H.PlaneField(run.corners, run.corners.length / run.block_of.length, x, y, mirror);
    let [low, high] = limits || [Infinity, -Infinity];
    if (!limits) for (const v of values) { if (v < low) low = v; if (v > high) high = v; }
    const scale = H.scaleOf(low, high), [unit, factor] = field.unit === "Pa" ? H.fits([low, high], "GPa", 1e-9) : [field.shown, field.factor];
    let [x0, x1, y0, y1] = [Infinity, -Infinity, Infinity, -Infinity];
    for (let i = 0; i < x.length; i++) { x0 = Math.min(x0, x[i]); x1 = Math.max(x1, x[i]); y0 = Math.min(y0, y[i]); y1 = Math.max(y1, y[i]); }
    if (mirror) x0 = -x1;
    const [lengthUnit, f] = H.lengthUnit(Math.max(x1 - x0, y1 - y0)), room = 0.03 * Math.max(x1 - x0, y1 - y0);
    Object.assign(this, {plane, lengthUnit, f, unit, factor});
    this.chart.options.height = Math.min(Math.max((y1 - y0) / (x1 - x0), 0.35), 1.2);
    const painter = plane.paint(values, scale, H.get("mesh") === "1", run.block_of), inSi = axis => ({low: axis.low / f, high: axis.high / f});
    this.chart.show({series: [], equal: true, plain: true, x: {label: H.labelled(mirror ? "radius" : run.axes[0], lengthUnit), min: (x0 - room) * f, max: (x1 + room) * f}, y: {label: H.labelled(run.axes[1], lengthUnit), min: (y0 - room) * f, max: (y1 + room) * f},
      bar: {scale, factor, label: H.labelled(field.words, unit)},
      paint: (pixels, wide, tall, ax, ay, p) => { const begun = performance.now(); painter(pixels, wide, tall, inSi(ax), inSi(ay), p); this.chart.box.dataset.painted = (performance.now() - begun).toFixed(1); },
      readings: (px, py) => { const zone = plane.zoneAt(px / f, py / f); return {zone, record: data.record, x: px / f, y: py / f, value: zone < 0 ? null : values[zone]}; }});
  }
};
