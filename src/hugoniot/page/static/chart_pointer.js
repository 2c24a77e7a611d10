"use strict";
// Pointer and keys of a chart: the computed point nearest to the pointer, zoom by wheel, drag and keys.
Object.assign(H.Chart.prototype, {
  hit(px, py) {
    const {spec, frame: f} = this;
    if (spec.readings) {
      if (px < f.left || px > f.width - f.right || py < f.top || py > f.height - f.bottom) return null;
      return {px, py, ...spec.readings(f.x.value(px), f.y.value(py))};      // what is read may have a place of its own
    }
    let best = null;
    spec.series.forEach((s, series) => {
      if (!s.hover) return;
      for (let i = 0; i < s.x.length; i++) {
        if (!usable(s.x[i], f.x) || !usable(s.y[i], f.y) || !inside(f.x, s.x[i]) || !inside(f.y, s.y[i])) continue;
        const dx = f.x.at(s.x[i]) - px, dy = f.y.at(s.y[i]) - py, d = dx * dx + dy * dy;
        if (!best || d < best.distance) best = {distance: d, series, index: i, x: s.x[i], y: s.y[i], id: s.id};
      }
    });
    return best;
  },
  _showCursor() {
    if (!this.top) return;
    H.clear(this.top);
    const {cursor: c, frame: f} = this, p = H.palette();
    if (!c) return;
    const s = this.spec.series[c.series];
    const x = c.px ?? (s && f.x.at(s.x[c.index])), y = c.py ?? (s && f.y.at(s.y[c.index]));
    if (!Number.isFinite(x) || !Number.isFinite(y)) return;
    this.top.append(H.s("path", {d: `M${f.left} ${r1(y)}H${f.width - f.right}M${r1(x)} ${f.top}V${f.height - f.bottom}`, stroke: p.quiet, "stroke-width": 0.8, "stroke-dasharray": "3 3", fill: "none"}),
      s?.origin ? H.s("line", {x1: f.x.at(s.origin[0]), y1: f.y.at(s.origin[1]), x2: x, y2: y, stroke: this.colour(s, p), "stroke-width": 1.1, "stroke-dasharray": "4 3", "data-line": "rayleigh"}) : "",
      H.s("circle", {cx: x, cy: y, r: 5, fill: s ? this.colour(s, p) : "none", stroke: s ? p.paper : p.ink, "stroke-width": 1.4}));
  },
  point(hit) { this.cursor = hit; this._showCursor(); if (hit && this.options.onHover) this.options.onHover(hit); },
  _local(event) { const r = this.svg.getBoundingClientRect(); return [event.clientX - r.left, event.clientY - r.top]; },
  _listen() {
    let down = null, grabbed = null;
    const svg = this.svg;
    svg.addEventListener("pointerdown", event => {
      const handle = event.target.closest("[data-handle]"), [x, y] = this._local(event);
      grabbed = handle && handle.dataset.handle;
      down = {x, y, zoom: {x: [this.frame.x.low, this.frame.x.high], y: [this.frame.y.low, this.frame.y.high]}, frame: this.frame};
      if (event.pointerType !== "touch" || grabbed) { svg.setPointerCapture(event.pointerId); }
      if (grabbed) event.preventDefault();
    });
    svg.addEventListener("pointermove", event => {
      const [x, y] = this._local(event);
      if (down && grabbed) { this.options.onDrag(grabbed, this.frame.x.value(x), this.frame.y.value(y)); return; }
      if (down && Math.hypot(x - down.x, y - down.y) > 4 && event.pointerType !== "touch") { down.moved = true; this._pan(down, x, y); return; }
      if (!down) this.point(this.hit(x, y));
    });
    svg.addEventListener("pointerup", event => {
      const [x, y] = this._local(event), moved = down && (down.moved || grabbed);
      if (grabbed && this.options.onDrop) this.options.onDrop(grabbed);
      if (down && down.moved) { cancelAnimationFrame(this.pending); this.pending = null; this.draw(); this._zoomed(); }
      down = grabbed = null;
      if (!moved) { const hit = this.hit(x, y); this.point(hit); if (hit && this.options.onPick) this.options.onPick(hit); }
    });
    svg.addEventListener("pointercancel", () => { down = grabbed = null; });
    svg.addEventListener("pointerleave", () => { if (!down && !this.options.keep) { this.cursor = null; this._showCursor(); } });
    svg.addEventListener("dblclick", () => this.zoomTo(null));
    svg.addEventListener("wheel", event => {
      if (!event.ctrlKey && !event.shiftKey && document.activeElement !== svg) return;    // the page scrolls unless the chart is meant
      event.preventDefault();
      const [x, y] = this._local(event);
      this.zoomBy(Math.exp(Math.sign(event.deltaY) * 0.2), x, y);
    }, {passive: false});
    svg.addEventListener("keydown", event => this._key(event));
  },
  _pan(down, x, y) {
    const move = (axis, range, d) => {
      const span = axis.to - axis.from;
      if (axis.log) { const k = (range[1] / range[0]) ** (-d / span); return [range[0] * k, range[1] * k]; }
      const k = -d / span * (range[1] - range[0]);
      return [range[0] + k, range[1] + k];
    };
    this.spec.zoom = {x: move(down.frame.x, down.zoom.x, x - down.x), y: move(down.frame.y, down.zoom.y, y - down.y)};
    if (!this.pending) this.pending = requestAnimationFrame(() => { this.pending = null; this.slide(); });
  },
  zoomBy(factor, px, py) {
    const f = this.frame, about = (axis, at) => {
      const v = axis.value(at);
      return axis.log ? [v * (axis.low / v) ** factor, v * (axis.high / v) ** factor] : [v + (axis.low - v) * factor, v + (axis.high - v) * factor];
    };
    this.zoomTo({x: about(f.x, px ?? (f.left + f.width - f.right) / 2), y: about(f.y, py ?? (f.top + f.height - f.bottom) / 2)});
  },
  zoomTo(zoom) { this.spec.zoom = zoom; this.draw(); this._zoomed(); },
  _zoomed() {
    const {zoomKey} = this.options, {zoom} = this.spec;
    if (zoomKey) H.set({[zoomKey]: zoom ? [...zoom.x, ...zoom.y].map(v => v.toPrecision(6)).join(",") : ""}, false);
  },
  _zoomOfAddress() {
    const four = H.get(this.options.zoomKey).split(",").map(Number);
    return four.length === 4 && four.every(Number.isFinite) ? {x: four.slice(0, 2), y: four.slice(2)} : null;
  },
  _key(event) {
    const step = event.shiftKey ? 10 : 1, name = event.key;
    if (name === "+" || name === "=") this.zoomBy(0.8);
    else if (name === "-") this.zoomBy(1.25);
    else if (name === "0" || name === "Escape") this.zoomTo(null);
    else if (name === "Enter" && this.cursor && this.options.onPick) this.options.onPick(this.cursor);
    else if (["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"].includes(name)) this._step(name, step);
    else return;
    event.preventDefault();
  },
  _step(name, step) {
    const f = this.frame, c = this.cursor;
    if (this.spec.readings) {
      const [across, along] = c?.step || [2, 2];
      const px = (c?.px ?? (f.left + f.width - f.right) / 2) + (name === "ArrowRight" ? across * step : name === "ArrowLeft" ? -across * step : 0);
      const py = (c?.py ?? (f.top + f.height - f.bottom) / 2) + (name === "ArrowDown" ? along * step : name === "ArrowUp" ? -along * step : 0);
      this.point(this.hit(Math.min(Math.max(px, f.left), f.width - f.right), Math.min(Math.max(py, f.top), f.height - f.bottom)));
      return;
    }
    const can = this.spec.series.map((s, k) => s.hover && s.x.length ? k : -1).filter(k => k >= 0);
    if (!can.length) return;
    let {series, index} = c && can.includes(c.series) ? c : {series: can[0], index: Math.floor(this.spec.series[can[0]].x.length / 2) - step};
    if (name === "ArrowUp" || name === "ArrowDown") series = can[(can.indexOf(series) + (name === "ArrowDown" ? 1 : can.length - 1)) % can.length];
    const s = this.spec.series[series];
    index = Math.min(Math.max(index + (name === "ArrowRight" ? step : name === "ArrowLeft" ? -step : 0), 0), s.x.length - 1);
    this.point({series, index, x: s.x[index], y: s.y[index], id: s.id});
  },
});
