"use strict";
// The planes in which materials are compared: what each draws of the curves of a material.
(() => {
  const times = (values, factor) => values.map(v => v === null ? null : v * factor);
  const columnsOf = {
    "us-up": t => [times(t.particle_velocity, 1e-3), times(t.shock_velocity, 1e-3)], "p-up": t => [times(t.particle_velocity, 1e-3), times(t.pressure, 1e-9)],
    "p-v": t => [times(t.specific_volume, 1e3), times(t.pressure, 1e-9)], "t-p": t => t.temperature ? [times(t.pressure, 1e-9), t.temperature] : [[], []],
  };
  const AXES = {
    "us-up": [{label: "particle velocity (km/s)", min: 0}, {label: "shock velocity (km/s)"}], "p-up": [{label: "particle velocity (km/s)", min: 0}, {label: "pressure (GPa)", min: 0}],
    "p-v": [{label: "specific volume (cm³/g)"}, {label: "pressure (GPa)", min: 0}], "t-p": [{label: "pressure (GPa)", min: 0}, {label: "temperature (K)", zero: true}],
  };
  const rayleigh = {"p-up": a => [0, a.pressure * 1e-9], "p-v": a => [1e3 / a.density, a.pressure * 1e-9]};      // where a Rayleigh line starts
  const line = (id, c, colour, table, axes, more) => { const [x, y] = columnsOf[axes](table); return {id, name: c.name, table, x, y, colour, ...more}; };
  const inert = c => c.products ? `${c.short}, unreacted` : c.short;      // whose shocks the planes of Hugoniots show

  function hugoniots(axes) {
    return {axes: AXES[axes], series(c, colour, options) {
      if (!c.hugoniot) return [];
      const found = [], h = c.hugoniot, known = c.valid_up_to ? h.particle_velocity.filter(u => u <= c.valid_up_to * (1 + 1e-9)).length : h.particle_velocity.length;
      const part = (from, to) => Object.fromEntries(Object.entries(h).map(([k, v]) => [k, v.slice(from, to)]));
      if (options.measured && (axes === "us-up" || axes === "p-up")) for (const m of c.measured)
        found.push({kind: "points", id: "measured", outside: true, colour, x: times(m.up, 1e-3), y: axes === "us-up" ? times(m.us, 1e-3) : times(m.p, 1e-9)});
      if (options.sources && (axes === "us-up" || axes === "p-up")) for (const s of c.sources)
        found.push({kind: "line", id: "source", source: s, name: c.name, colour, faint: true, dash: "2 3", hover: false, x: times(s.up, 1e-3), y: axes === "us-up" ? times(s.us, 1e-3) : times(s.p, 1e-9)});
      if (known < h.particle_velocity.length) found.push(line("beyond", c, colour, part(Math.max(known - 1, 0)), axes, {dash: "5 4", hover: true, label: inert(c)}));
      for (const s of found) if (s.id === "beyond" && rayleigh[axes]) s.origin = rayleigh[axes](c.ahead);
      found.push(line("hugoniot", c, colour, part(0, known), axes, {hover: true, origin: rayleigh[axes]?.(c.ahead), label: inert(c)}));
      if (options.releases && axes !== "us-up") for (const r of [...c.releases, ...(c.pinned?.release ? [c.pinned.release] : [])])
        found.push(line("release", c, colour, r, axes, {faint: true, hover: true}));
      return found;
    }, marks(c, colour) {
      if (!c.pinned || !c.hugoniot) return [];
      const s = Object.fromEntries(Object.entries({...c.pinned.state, specific_volume: 1 / c.pinned.state.density}).map(([k, v]) => [k, [v]])), [[x], [y]] = columnsOf[axes](s);
      if (x === undefined) return [];
      const found = [{kind: "dot", x, y, colour}], a = c.ahead;
      if (axes === "p-up") found.unshift({kind: "line", x1: 0, y1: a.pressure * 1e-9, x2: x, y2: y, colour, dash: "4 3"});
      if (axes === "p-v") found.unshift({kind: "line", x1: 1e3 / a.density, y1: a.pressure * 1e-9, x2: x, y2: y, colour, dash: "4 3"});
      return found;
    }};
  }
  const isentropes = {...hugoniots("p-v"), series(c, colour) {
    if (!c.hugoniot) return [];
    const found = [line("hugoniot", c, colour, c.hugoniot, "p-v", {hover: true, label: inert(c)})];
    if (c.isentrope) found.push(line("isentrope", c, colour, c.isentrope, "p-v", {hover: true, dash: "6 3", width: 1.3}));
    for (const r of [...c.releases, ...(c.pinned?.release ? [c.pinned.release] : [])]) found.push(line("release", c, colour, r, "p-v", {hover: true, faint: true}));
    return found;
  }};
  const detonation = {axes: AXES["p-v"], series(c, colour) {
    if (!c.products) return [];
    const p = c.products, found = [line("products", c, colour, p.hugoniot, "p-v", {hover: true, label: c.short}), line("release", c, colour, fallen(p.isentrope, 1e9), "p-v", {hover: true, dash: "6 3", width: 1.3})];
    if (c.hugoniot) found.push(line("unreacted", c, colour, below(c.hugoniot, 2 * p.cj.pressure), "p-v", {hover: true, faint: true}));
    return found;
  }, marks(c, colour) {
    if (!c.products) return [];
    const p = c.products, x = 1e3 / p.cj.density, y = p.cj.pressure * 1e-9, v0 = 1e3 / p.ahead.density;
    return [{kind: "line", x1: v0, y1: p.ahead.pressure * 1e-9, x2: x, y2: y, colour, dash: "4 3"}, {kind: "dot", x, y, colour, label: "CJ"}];
  }};
  const pick = (table, keep) => { const k = table.pressure.map((p, i) => keep(p, i) ? i : -1).filter(i => i >= 0); return Object.fromEntries(Object.entries(table).map(([n, v]) => [n, k.map(i => v[i])])); };
  const fallen = (table, least) => pick(table, p => p >= least), below = (table, most) => pick(table, p => p <= most);
  const expansion = {axes: [{label: "specific volume (cm³/g)", log: true}, {label: "pressure (GPa)", log: true}],
    series: (c, colour) => c.products ? [line("release", c, colour, c.products.isentrope, "p-v", {hover: true, label: c.short})] : [],
    marks: (c, colour) => c.products ? [{kind: "dot", x: 1e3 / c.products.cj.density, y: c.products.cj.pressure * 1e-9, colour, label: "CJ"}] : []};
  const gurney = {axes: [{label: "mass of metal over mass of explosive, M/C", log: true}, {label: "Gurney metal velocity (km/s)", min: 0}],
    series(c, colour) {
      if (!c.gurney) return [];
      const dashes = {cylinder: null, sphere: "7 3", symmetric: "2 3", open: "9 3 2 3"};
      return Object.entries(c.gurney.velocity).map(([kind, v]) => ({kind: "line", id: `gurney ${kind}`, name: c.name, colour, dash: dashes[kind], x: c.gurney.ratio, y: times(v, 1e-3), hover: true,
        label: `${c.short}, ${kind === "symmetric" ? "sandwich" : kind === "open" ? "open sandwich" : kind}`, table: {mass_ratio: c.gurney.ratio, gurney_velocity: v}}));
    }, marks: () => []};
  const pop = {axes: [{label: "pressure (GPa)", log: true}, {label: "run distance to detonation (mm)", log: true}],
    series: (c, colour) => c.pop.flatMap(r => {
      const [low, high] = [r.pressure_low * 1e-9, r.pressure_high * 1e-9], n = 40, p = Array.from({length: n + 1}, (_, k) => low * (high / low) ** (k / n));
      const run = (a, b) => p.map(q => 10 ** ((Math.log10(q) - a) / b));
      const x = run(r.a, r.b), found = [];
      if (r.a_deviation) found.push({kind: "band", colour, x: p, y: run(r.a - r.a_deviation, r.b), y2: run(r.a + r.a_deviation, r.b)});
      return [...found, {kind: "line", id: `Pop plot ${r.row}`, name: c.name, colour, x: p, y: x, hover: true, label: `${r.label} (${r.row})`, table: {pressure: p.map(q => q * 1e9), run_distance: x.map(v => v * 1e-3)}}];
    }), marks: () => []};

  H.planes = {"us-up": ["Us–up", hugoniots("us-up")], "p-up": ["p–up", hugoniots("p-up")], "p-v": ["p–v", hugoniots("p-v")], "t-p": ["T–p", hugoniots("t-p")], isentropes: ["Isentropes", isentropes], isotherms: ["Isotherms", H.isothermPlane], surface: ["Surface", {axes: [{}, {}], series: () => [], marks: () => []}],
              detonation: ["Detonation", detonation], expansion: ["Expansion", expansion], gurney: ["Gurney", gurney], pop: ["Pop plot", pop]};
  H.ofExplosives = ["detonation", "expansion", "gurney", "pop"];
  H.curveWords = {isotherm: "isotherm", "cold curve": "cold curve: the isotherm at 0 K", hugoniot: "Hugoniot", beyond: "Hugoniot, beyond the range of the data", release: "isentrope", isentrope: "isentrope from rest", products: "detonation Hugoniot", unreacted: "Hugoniot of the unreacted explosive"};
})();
