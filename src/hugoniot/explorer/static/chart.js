"use strict";
// A chart as SVG: axes with units, lines named where they end, zoom by wheel, drag and keys, a pointer that snaps to computed points.
// A raster (x-t map, plane) is painted on a canvas behind it.
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

H.Chart = class {
  // options: label, height (of the width), most (highest), onHover(hit), onPick(hit), onZoom(zoom), paint(context), describe(hit), readings(x, y)
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
  show(spec) { this.spec = spec; if (this.cursor && !spec.series[this.cursor.series]) this.cursor = null; this.draw(); }
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
    this.render(this.svg, this.frame, H.palette());
    this._paint(this.canvas, this.frame, H.palette());
    this.top = H.s("g", {"pointer-events": "none"});
    this.svg.append(this.top);
    this._showCursor();
  }
  // -- geometry --------------------------------------------------------------------------------------------------------
  layout(width, height) {
    const {spec} = this, narrow = width < 560, named = !narrow && spec.series.some(s => s.label);
    const widest = Math.max(0, ...spec.series.map(s => (s.label || "").length));
    const right = spec.bar ? 86 : named ? Math.min(24 + 6.6 * widest, 0.27 * width) : 14;
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
  // -- drawing ---------------------------------------------------------------------------------------------------------
  render(root, f, p) {
    const {spec} = this, clip = `clip${Math.random().toString(36).slice(2)}`;
    root.append(H.s("defs", {}, H.s("clipPath", {id: clip}, H.s("rect", {x: f.left, y: f.top, width: f.width - f.left - f.right, height: f.height - f.top - f.bottom}))));
    const plot = H.s("g", {"clip-path": `url(#${clip})`});
    this._axes(root, f, p);
    root.append(plot);
    for (const s of spec.series) this._series(plot, s, f, p);
    for (const m of spec.marks || []) this._mark(plot, m, f, p);
    this._names(root, f, p);
    for (const head of spec.heads || []) root.append(text(f.x.at(head.x), f.top - 6, head.label, p.text, 11, "middle"));
    if (spec.bar) this._bar(root, f, p);
    for (const handle of spec.handles || []) this._handle(root, handle, f, p);
  }
  _axes(root, f, p) {
    const {spec} = this, base = f.height - f.bottom, end = f.width - f.right, size = f.narrow ? 10.5 : 11.5;
    const xs = spec.x.log ? H.logTicks(f.x.low, f.x.high) : H.ticks(f.x.low, f.x.high, (end - f.left) / (f.narrow ? 60 : 90));
    const ys = spec.y.log ? H.logTicks(f.y.low, f.y.high) : H.ticks(f.y.low, f.y.high, (base - f.top) / 55);
    const step = values => values.length > 1 ? Math.abs(values[1] - values[0]) : 1;
    let taken = -Infinity;
    for (const v of xs) {
      const at = f.x.at(v), words = tickText(v, spec.x.log ? v : step(xs));
      if (!spec.bar && !spec.plain) root.append(H.s("line", {x1: at, x2: at, y1: f.top, y2: base, stroke: p.faint, "stroke-width": 0.5}));
      root.append(H.s("line", {x1: at, x2: at, y1: base, y2: base + 4, stroke: p.ink, "stroke-width": 0.9}));
      if (at - 3.6 * words.length > taken) { root.append(text(at, base + 17, words, p.text, size, "middle")); taken = at + 3.6 * words.length + 4; }
    }
    let above = Infinity;
    for (const v of spec.y.bare ? [] : ys) {
      const at = f.y.at(v);
      if (!spec.bar && !spec.plain) root.append(H.s("line", {x1: f.left, x2: end, y1: at, y2: at, stroke: p.faint, "stroke-width": 0.5}));
      root.append(H.s("line", {x1: f.left - 4, x2: f.left, y1: at, y2: at, stroke: p.ink, "stroke-width": 0.9}));
      if (above - at > 13) { root.append(text(f.left - 7, at + 4, tickText(v, spec.y.log ? v : step(ys)), p.text, size, "end")); above = at; }
    }
    root.append(H.s("path", {d: spec.y.bare ? `M${f.left} ${base}H${end}` : `M${f.left} ${f.top}V${base}H${end}`, fill: "none", stroke: p.ink, "stroke-width": 0.9}));
    root.append(text((f.left + end) / 2, f.height - 6, spec.x.label, p.text, size + 0.7, "middle", {"data-axis": "x"}));
    root.append(text(0, 0, spec.y.label, p.text, size + 0.7, "middle", {transform: `translate(${f.narrow ? 11 : 13} ${(f.top + base) / 2}) rotate(-90)`, "data-axis": "y"}));
  }
  _series(plot, s, f, p) {
    const colour = this.colour(s, p);
    if (s.kind === "points") {
      for (let i = 0; i < s.x.length; i++) if (usable(s.x[i], f.x) && usable(s.y[i], f.y))
        plot.append(H.s("circle", {cx: r1(f.x.at(s.x[i])), cy: r1(f.y.at(s.y[i])), r: s.size || 3, fill: s.filled ? colour : "none", stroke: colour,
                                   "stroke-width": 0.9, opacity: s.faint ? 0.55 : s.opacity || 0.85}));
      return;
    }
    if (s.kind === "band") {
      const up = s.x.map((x, i) => `${r1(f.x.at(x))} ${r1(f.y.at(s.y[i]))}`), down = s.x.map((x, i) => `${r1(f.x.at(x))} ${r1(f.y.at(s.y2[i]))}`).reverse();
      plot.append(H.s("path", {d: `M${up.join("L")}L${down.join("L")}Z`, fill: colour, opacity: 0.18, stroke: "none"}));
      return;
    }
    plot.append(H.s("path", {d: path(s, f), fill: "none", stroke: colour, "stroke-width": s.width || (s.faint ? 1 : 1.8), "stroke-linejoin": "round", "stroke-linecap": "round",
                             "stroke-dasharray": s.dash || null, opacity: s.faint ? 0.55 : 1}));
  }
  colour(s, p) { return typeof s.colour === "number" ? p.lines[s.colour % p.lines.length] : p[s.colour] || s.colour || p.ink; }
  _mark(plot, m, f, p) {
    const colour = this.colour(m, p), x = m.x === undefined ? null : f.x.at(m.x), y = m.y === undefined ? null : f.y.at(m.y);
    const line = (x1, y1, x2, y2) => plot.append(H.s("line", {x1: r1(x1), y1: r1(y1), x2: r1(x2), y2: r1(y2), stroke: colour, "stroke-width": m.width || 1.1, "stroke-dasharray": m.dash || null, opacity: m.opacity || 1}));
    if (m.kind === "line") line(f.x.at(m.x1), f.y.at(m.y1), f.x.at(m.x2), f.y.at(m.y2));
    if (m.kind === "vline") line(x, f.top, x, f.height - f.bottom);
    if (m.kind === "hline") line(f.left, y, f.width - f.right, y);
    if (m.kind === "dot") plot.append(H.s("circle", {cx: r1(x), cy: r1(y), r: m.size || 4.5, fill: colour, stroke: p.paper, "stroke-width": 1.2}));
    if (m.kind === "polygon") plot.append(H.s("polygon", {points: m.xs.map((v, i) => `${r1(f.x.at(v))},${r1(f.y.at(m.ys[i]))}`).join(" "), fill: m.fill === false ? "none" : colour, "fill-opacity": m.opacity || 0.35, stroke: p.ink, "stroke-width": m.width || 0.8}));
    if (m.kind === "error") { const up = f.y.at(m.y - m.sy), down = f.y.at(m.y + m.sy), l = f.x.at(m.x - m.sx), r = f.x.at(m.x + m.sx); line(x, up, x, down); line(l, y, r, y); }
    if (m.label) {
      const right = m.side === "left" || (x ?? f.x.at(m.x2)) > f.width - f.right - 8 * m.label.length;
      const half = 3.5 * m.label.length, at = x ?? f.x.at(m.x2), kept = m.centre ? Math.min(Math.max(at, f.left + half), f.width - f.right - half) : at + (right ? -11 : 11);
      plot.append(text(kept, (y ?? f.y.at(m.y2)) + (m.below ? 22 : m.centre ? 4 : -6), m.label, this.colour({colour: m.ink || m.colour}, p), 11, m.centre ? "middle" : right ? "end" : "start", {}, m.centre ? null : p.paper));
    }
  }
  _names(root, f, p) {        // each line is named where it ends
    const ends = [];
    for (const s of this.spec.series) {
      if (!s.label || s.kind === "band") continue;
      let last = null;
      const from = s.named === "start" ? 0 : s.x.length - 1, step = s.named === "start" ? 1 : -1;
      for (let i = from; i >= 0 && i < s.x.length && !last; i += step)
        if (usable(s.x[i], f.x) && usable(s.y[i], f.y) && inside(f.x, s.x[i]) && inside(f.y, s.y[i])) last = [f.x.at(s.x[i]), f.y.at(s.y[i])];
      if (last) ends.push({label: s.label, colour: this.colour(s, p), x: last[0], y: last[1] - (s.named === "start" ? 22 : 0)});
    }
    if (!ends.length) return;
    const edge = f.width - f.right, last = new Map();       // the parts of one line have one name, where the last of them ends
    for (const e of ends) if (!last.has(e.label) || last.get(e.label).x < e.x) last.set(e.label, e);
    const beside = [...last.values()].filter(e => f.named && e.x > edge - 60), within = [...last.values()].filter(e => !beside.includes(e));
    apart(beside, 14);
    for (const e of beside) {
      const most = Math.floor((f.right - 12) / 6.4), label = e.label.length > most ? e.label.slice(0, most - 1) + "…" : e.label;
      root.append(text(edge + 7, Math.max(e.y, f.top + 4) + 4, label, e.colour, 11.5, "start"));
    }
    for (const e of within) e.y = Math.min(Math.max(e.y, f.top + 6), f.height - f.bottom - 8);
    apart(within, 14);
    for (const e of within) {
      const after = e.x + 8 + 6.4 * e.label.length < f.width - 4;
      root.append(text(e.x + (after ? 8 : -4), e.y + (after ? 4 : -6), e.label, e.colour, 11.5, after ? "start" : "end", {}, p.paper));
    }
  }
  _bar(root, f, p) {
    const {bar} = this.spec, x = f.width - f.right + 14, h = f.height - f.top - f.bottom, id = `bar${Math.random().toString(36).slice(2)}`;
    const stops = Array.from({length: 33}, (_, k) => H.s("stop", {offset: k / 32, "stop-color": H.css(bar.scale.ramp[Math.round(255 * k / 32)])}));
    root.append(H.s("defs", {}, H.s("linearGradient", {id, x1: 0, x2: 0, y1: 1, y2: 0}, stops)), H.s("rect", {x, y: f.top, width: 12, height: h, fill: `url(#${id})`}));
    const low = bar.scale.low * bar.factor, high = bar.scale.high * bar.factor, axis = new Axis(low, high, f.top + h, f.top, false), marks = H.ticks(low, high, h / 60);
    const step = marks.length > 1 ? marks[1] - marks[0] : 1;
    for (const v of marks) root.append(H.s("line", {x1: x + 12, x2: x + 15, y1: axis.at(v), y2: axis.at(v), stroke: p.ink, "stroke-width": 0.8}), text(x + 17, axis.at(v) + 4, tickText(v, step), p.text, 10.5, "start"));
    root.append(text(0, 0, bar.label, p.text, 11, "middle", {transform: `translate(${f.width - 5} ${f.top + h / 2}) rotate(-90)`}));
  }
  _handle(root, handle, f, p) {
    const x = f.x.at(handle.x), y = f.y.at(handle.y ?? f.y.low), colour = this.colour(handle, p);
    root.append(H.s("g", {class: "handle", "data-handle": handle.id, cursor: "ew-resize"},
      H.s("circle", {cx: x, cy: y, r: 15, fill: colour, opacity: 0.16}), H.s("circle", {cx: x, cy: y, r: 7, fill: colour, stroke: p.paper, "stroke-width": 1.6}),
      H.s("path", {d: `M${x - 11} ${y}l-5 0m2 -3l-3 3 3 3M${x + 11} ${y}l5 0m-2 -3l3 3 -3 3`, fill: "none", stroke: colour, "stroke-width": 1.4})));
  }
  _paint(canvas, f, p) {
    if (!this.spec.paint) { canvas.width = canvas.height = 0; return; }
    const ratio = Math.min(window.devicePixelRatio || 1, 2), w = f.width - f.left - f.right, h = f.height - f.top - f.bottom;
    Object.assign(canvas.style, {left: `${f.left}px`, top: `${f.top}px`, width: `${w}px`, height: `${h}px`});
    const wide = Math.max(1, Math.round(w * ratio)), high = Math.max(1, Math.round(h * ratio));
    if (canvas.width !== wide || canvas.height !== high) { canvas.width = wide; canvas.height = high; }
    const context = canvas.getContext("2d"), image = context.createImageData(wide, high);
    this.spec.paint(new Uint32Array(image.data.buffer), wide, high, f.x, f.y, p);
    context.putImageData(image, 0, 0);
  }
  // -- pointer and keys ------------------------------------------------------------------------------------------------
  hit(px, py) {
    const {spec, frame: f} = this;
    if (spec.readings) {
      if (px < f.left || px > f.width - f.right || py < f.top || py > f.height - f.bottom) return null;
      return {...spec.readings(f.x.value(px), f.y.value(py)), px, py};
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
  }
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
  }
  point(hit) { this.cursor = hit; this._showCursor(); if (hit && this.options.onHover) this.options.onHover(hit); }
  _local(event) { const r = this.svg.getBoundingClientRect(); return [event.clientX - r.left, event.clientY - r.top]; }
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
      if (down && down.moved) this._zoomed(true);
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
  }
  _pan(down, x, y) {
    const move = (axis, range, d) => {
      const span = axis.to - axis.from;
      if (axis.log) { const k = (range[1] / range[0]) ** (-d / span); return [range[0] * k, range[1] * k]; }
      const k = -d / span * (range[1] - range[0]);
      return [range[0] + k, range[1] + k];
    };
    this.spec.zoom = {x: move(down.frame.x, down.zoom.x, x - down.x), y: move(down.frame.y, down.zoom.y, y - down.y)};
    if (!this.pending) this.pending = requestAnimationFrame(() => { this.pending = null; this.draw(); });
  }
  zoomBy(factor, px, py) {
    const f = this.frame, about = (axis, at) => {
      const v = axis.value(at);
      return axis.log ? [v * (axis.low / v) ** factor, v * (axis.high / v) ** factor] : [v + (axis.low - v) * factor, v + (axis.high - v) * factor];
    };
    this.zoomTo({x: about(f.x, px ?? (f.left + f.width - f.right) / 2), y: about(f.y, py ?? (f.top + f.height - f.bottom) / 2)});
  }
  zoomTo(zoom) { this.spec.zoom = zoom; this.draw(); this._zoomed(); }
  _zoomed() { if (this.options.onZoom) this.options.onZoom(this.spec.zoom); }
  _key(event) {
    const step = event.shiftKey ? 10 : 1, name = event.key;
    if (name === "+" || name === "=") this.zoomBy(0.8);
    else if (name === "-") this.zoomBy(1.25);
    else if (name === "0" || name === "Escape") this.zoomTo(null);
    else if (name === "Enter" && this.cursor && this.options.onPick) this.options.onPick(this.cursor);
    else if (["ArrowLeft", "ArrowRight", "ArrowUp", "ArrowDown"].includes(name)) this._step(name, step);
    else return;
    event.preventDefault();
  }
  _step(name, step) {
    const f = this.frame, c = this.cursor;
    if (this.spec.readings) {
      const px = (c?.px ?? (f.left + f.width - f.right) / 2) + (name === "ArrowRight" ? 2 * step : name === "ArrowLeft" ? -2 * step : 0);
      const py = (c?.py ?? (f.top + f.height - f.bottom) / 2) + (name === "ArrowDown" ? 2 * step : name === "ArrowUp" ? -2 * step : 0);
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
  }
  stop() { this.watch.disconnect(); this.box.remove(); }
};

function apart(ends, least) {
  ends.sort((a, b) => a.y - b.y);
  for (let round = 0; round < 40; round++) for (let i = 1; i < ends.length; i++) {
    const short = least - (ends[i].y - ends[i - 1].y);
    if (short > 0) { ends[i - 1].y -= short / 2; ends[i].y += short / 2; }
  }
}
const r1 = v => Math.round(v * 100) / 100;
const usable = (v, axis) => v !== null && Number.isFinite(v) && (!axis.log || v > 0);
const inside = (axis, v) => { const a = axis.at(v), low = Math.min(axis.from, axis.to), high = Math.max(axis.from, axis.to); return a >= low - 0.5 && a <= high + 0.5; };
function path(s, f) {
  let d = "", pen = false;
  for (let i = 0; i < s.x.length; i++) {
    if (!usable(s.x[i], f.x) || !usable(s.y[i], f.y)) { pen = false; continue; }
    const x = Math.min(Math.max(f.x.at(s.x[i]), -1e5), 1e5), y = Math.min(Math.max(f.y.at(s.y[i]), -1e5), 1e5);
    d += `${pen ? "L" : "M"}${r1(x)} ${r1(y)}`;
    pen = true;
  }
  return d;
}
function text(x, y, words, colour, size, anchor, more = {}, halo = null) {
  const around = halo ? {stroke: halo, "stroke-width": 3, "paint-order": "stroke", "stroke-linejoin": "round"} : {};
  return H.s("text", {x: r1(x), y: r1(y), fill: colour, "font-size": size, "font-family": FONT, "text-anchor": anchor, ...around, ...more}, words);
}
