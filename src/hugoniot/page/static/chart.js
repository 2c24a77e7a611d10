"use strict";
// A chart: its size and ranges, and what is shown. How it is drawn stands in chart_drawing.js, pointer and keys in chart_pointer.js.
// A raster (x-t map, plane, surface) is painted on a canvas behind the SVG.
H.Chart = class {
  // options: label, height (of the width), most (highest), onHover(hit), onPick(hit), zoomKey (of the address), paint(context), describe(hit), readings(x, y)
  constructor(host, options) {
    this.options = {height: 0.62, most: 620, least: 280, ...options};
    this.host = host;
    this.canvas = H.h("canvas", {"aria-hidden": "true"});
    this.svg = H.s("svg", {tabindex: 0, role: "img", "aria-label": options.label, focusable: "true"});
    this.box = H.h("div", {class: "chart"}, this.canvas, this.svg);
    host.append(this.box);
    this.box.chart = this;
    this.spec = {series: [], x: {}, y: {}};
    this.cursor = null;
    this.watch = new ResizeObserver(() => this.draw());
    this.watch.observe(this.box);
    this._listen();
  }
  show(spec) {
    this.spec = this.options.zoomKey ? {...spec, zoom: this._zoomOfAddress()} : spec;
    if (this.cursor && !spec.series[this.cursor.series]) this.cursor = null;
    this.draw();
  }
  size() {
    const width = Math.max(this.box.clientWidth || 600, 200);
    const height = Math.min(Math.max(width * this.options.height, this.options.least), this.options.most);
    return [width, height];
  }
  draw() {
    const [width, height] = this.size();
    if (this.box.style.height !== `${height}px`) this.box.style.height = `${height}px`;
    this.frame = this.layout(width, height);
    H.clear(this.svg);
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.layers = this.render(this.svg, this.frame, H.palette());
    this._paint(this.canvas, this.frame, H.palette());
    this.drawn = {at: performance.now(), frame: this.frame};
    this.top = H.s("g", {"pointer-events": "none"});
    this.svg.append(this.top);
    this._showCursor();
  }
  // While a picture is dragged what was drawn last slides along, with new axes; it is drawn anew a few times a second, and at the end.
  slide() {
    const from = this.drawn.frame, [width, height] = this.size();
    if (performance.now() - this.drawn.at > 300) { this.draw(); return; }
    const f = this.frame = this.layout(width, height), dx = f.x.at(from.x.low) - f.left, dy = f.y.at(from.y.low) - (height - f.bottom);
    const axes = H.s("g", {}), {plot, names} = this.layers;
    this._axes(axes, f, H.palette());
    this.layers.axes.replaceWith(axes);
    this.layers.axes = axes;
    plot.setAttribute("transform", `translate(${r1(dx)} ${r1(dy)})`);
    H.clear(names);
    H.clear(this.top);
    if (this.bitmap) {
      const context = this.canvas.getContext("2d"), ratio = this.canvas.width / (f.width - f.left - f.right);
      context.clearRect(0, 0, this.canvas.width, this.canvas.height);
      context.drawImage(this.bitmap, Math.round(dx * ratio), Math.round(dy * ratio));
    }
  }
  // -- geometry --------------------------------------------------------------------------------------------------------
  layout(width, height) {
    const {spec} = this, narrow = width < 560, named = !narrow && spec.series.some(s => s.label);
    const widest = Math.max(0, ...spec.series.map(s => (s.label || "").length));
    const right = spec.right ?? (spec.bar ? 86 : named ? Math.min(24 + 6.6 * widest, 0.27 * width) : 14);
    let left = narrow ? 50 : 62;
    const bottom = 44, top = spec.heads ? 22 : 12;
    const [x, y] = ["x", "y"].map(a => this._range(a));
    const marks = spec.y.bare || spec.y.log ? [] : H.ticks(y[0], y[1], (height - top - bottom) / 55), step = marks.length > 1 ? marks[1] - marks[0] : 1;
    left = Math.max(left, 26 + 7.2 * Math.max(0, ...marks.map(v => tickText(v, step).length)));
    if (spec.equal) {     // a plane: one scale for both axes
      const scale = Math.min((width - left - right) / (x[1] - x[0]), (height - top - bottom) / (y[1] - y[0]));
      for (const [r, room] of [[x, width - left - right], [y, height - top - bottom]]) {
        const more = room / scale - (r[1] - r[0]);
        r[0] -= more / 2; r[1] += more / 2;
      }
    }
    return {width, height, left, right, top, bottom, narrow, named,
            x: new Axis(x[0], x[1], left, width - right, spec.x.log), y: new Axis(y[0], y[1], height - bottom, top, spec.y.log)};
  }
  _range(axis) {
    const {spec} = this, zoomed = spec.zoom && spec.zoom[axis];
    if (zoomed) return [...zoomed];
    const given = spec[axis];
    if (given.min !== undefined && given.max !== undefined) return [given.min, given.max];
    let low = Infinity, high = -Infinity;
    for (const s of spec.series) {
      if (s.outside) continue;
      for (const key of axis === "y" && s.y2 ? ["y", "y2"] : [axis]) for (const v of s[key]) {
        if (!Number.isFinite(v) || given.log && v <= 0) continue;
        if (v < low) low = v;
        if (v > high) high = v;
      }
    }
    if (!(high >= low)) return given.log ? [1, 10] : [0, 1];
    if (given.log) return [given.min ?? low * 0.9, given.max ?? high * 1.1];
    const room = (high - low || Math.abs(high) || 1) * 0.04;
    if (given.zero && low > 0 && low < 0.6 * high) low = 0;
    return [given.min ?? (low === 0 ? 0 : low - room), given.max ?? high + room];
  }
  // -- the raster -------------------------------------------------------------------------------------------------------
  _paint(canvas, f, p) {
    this.bitmap = null;
    canvas.hidden = !this.spec.paint;
    if (!this.spec.paint) { canvas.width = canvas.height = 0; return; }
    const ratio = Math.min(window.devicePixelRatio || 1, 2), w = f.width - f.left - f.right, h = f.height - f.top - f.bottom;
    Object.assign(canvas.style, {left: `${f.left}px`, top: `${f.top}px`, width: `${w}px`, height: `${h}px`});
    const wide = Math.max(1, Math.round(w * ratio)), high = Math.max(1, Math.round(h * ratio));
    if (canvas.width !== wide || canvas.height !== high) { canvas.width = wide; canvas.height = high; }
    const bitmap = this.bitmap = H.h("canvas", {width: wide, height: high}), context = bitmap.getContext("2d"), image = context.createImageData(wide, high);
    this.spec.paint(new Uint32Array(image.data.buffer), wide, high, f.x, f.y, p);
    context.putImageData(image, 0, 0);
    const seen = canvas.getContext("2d");
    seen.clearRect(0, 0, wide, high);
    seen.drawImage(bitmap, 0, 0);
  }
  stop() { this.watch.disconnect(); this.box.remove(); }
};
