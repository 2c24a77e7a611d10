"use strict";
// How a chart is drawn: axes, lines named where they end, marks, colour bar, handles.
Object.assign(H.Chart.prototype, {
  render(root, f, p) {        // gives the groups that move apart from each other while the picture is dragged
    const {spec} = this, clip = `clip${Math.random().toString(36).slice(2)}`, [axes, plot, names] = [0, 1, 2].map(() => H.s("g", {}));
    root.append(H.s("defs", {}, H.s("clipPath", {id: clip}, H.s("rect", {x: f.left, y: f.top, width: f.width - f.left - f.right, height: f.height - f.top - f.bottom}))));
    this._axes(axes, f, p);
    root.append(axes, H.s("g", {"clip-path": `url(#${clip})`}, plot), names);
    for (const s of spec.series) this._series(plot, s, f, p);
    for (const m of spec.marks || []) this._mark(plot, m, f, p);
    this._names(names, f, p);
    for (const head of spec.heads || []) names.append(text(f.x.at(head.x), f.top - 6, head.label, p.text, 11, "middle"));
    if (spec.bar) this._bar(root, f, p);
    for (const handle of spec.handles || []) this._handle(names, handle, f, p);
    return {axes, plot, names};
  },
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
  },
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
  },
  colour(s, p) { return typeof s.colour === "number" ? p.lines[s.colour % p.lines.length] : p[s.colour] || s.colour || p.ink; },
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
      const low = m.below && f.height - f.bottom - y > 44;      // near the axis there is no room below
      plot.append(text(kept, (y ?? f.y.at(m.y2)) + (low ? 22 : m.centre ? 4 : -6), m.label, this.colour({colour: m.ink || m.colour}, p), 11, m.centre ? "middle" : right ? "end" : "start", {}, m.centre ? null : p.paper));
    }
  },
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
    const beside = [...last.values()].filter(e => f.named && !this.spec.bar && e.x > edge - 60), within = [...last.values()].filter(e => !beside.includes(e));
    apart(beside, 14);
    for (const e of beside) {
      const most = Math.floor((f.right - 12) / 6.4), label = e.label.length > most ? e.label.slice(0, most - 1) + "…" : e.label;
      root.append(text(edge + 7, Math.max(e.y, f.top + 4) + 4, label, e.colour, 11.5, "start"));
    }
    for (const e of within) e.y = Math.min(Math.max(e.y, f.top + 6), f.height - f.bottom - 8);
    apart(within, 14);
    for (const e of within) {
      const after = e.x + 8 + 6.4 * e.label.length < (this.spec.bar ? edge : f.width - 4);
      root.append(text(e.x + (after ? 8 : -4), e.y + (after ? 4 : -6), e.label, e.colour, 11.5, after ? "start" : "end", {}, p.paper));
    }
  },
  _bar(root, f, p) {
    const {bar} = this.spec, x = f.width - f.right + 14, h = f.height - f.top - f.bottom, id = `bar${Math.random().toString(36).slice(2)}`;
    const stops = Array.from({length: 33}, (_, k) => H.s("stop", {offset: k / 32, "stop-color": H.css(bar.scale.ramp[Math.round(255 * k / 32)])}));
    root.append(H.s("defs", {}, H.s("linearGradient", {id, x1: 0, x2: 0, y1: 1, y2: 0}, stops)), H.s("rect", {x, y: f.top, width: 12, height: h, fill: `url(#${id})`}));
    const low = bar.scale.low * bar.factor, high = bar.scale.high * bar.factor, axis = new Axis(low, high, f.top + h, f.top, false), marks = H.ticks(low, high, h / 60);
    const step = marks.length > 1 ? marks[1] - marks[0] : 1;
    for (const v of marks) root.append(H.s("line", {x1: x + 12, x2: x + 15, y1: axis.at(v), y2: axis.at(v), stroke: p.ink, "stroke-width": 0.8}), text(x + 17, axis.at(v) + 4, tickText(v, step), p.text, 10.5, "start"));
    root.append(text(0, 0, bar.label, p.text, 11, "middle", {transform: `translate(${f.width - 5} ${f.top + h / 2}) rotate(-90)`}));
  },
  _handle(root, handle, f, p) {
    const x = f.x.at(handle.x), y = f.y.at(handle.y ?? f.y.low), colour = this.colour(handle, p);
    root.append(H.s("g", {class: "handle", "data-handle": handle.id, cursor: "ew-resize"},
      H.s("circle", {cx: x, cy: y, r: 15, fill: colour, opacity: 0.16}), H.s("circle", {cx: x, cy: y, r: 7, fill: colour, stroke: p.paper, "stroke-width": 1.6}),
      H.s("path", {d: `M${x - 11} ${y}l-5 0m2 -3l-3 3 3 3M${x + 11} ${y}l5 0m-2 -3l3 3 -3 3`, fill: "none", stroke: colour, "stroke-width": 1.4})));
  },
});

function apart(ends, least) {
  ends.sort((a, b) => a.y - b.y);
  for (let round = 0; round < 40; round++) for (let i = 1; i < ends.length; i++) {
    const short = least - (ends[i].y - ends[i - 1].y);
    if (short > 0) { ends[i - 1].y -= short / 2; ends[i].y += short / 2; }
  }
}
