"use strict";
// Histories at gauges, surfaces and picked zones, of one run or several over each other; profiles along the position at one time.
H.RunLines = class {
  constructor(histories, profile, hooks) {
    this.histories = new H.Chart(histories, {label: "Time histories", height: 0.42, most: 380, least: 240, zoomKey: "hz", onHover: hooks.onTime, onPick: hooks.onPickTime});
    this.profile = new H.Chart(profile, {label: "Profile over position", height: 0.36, most: 330, least: 220, keep: true, zoomKey: "pz", onHover: hooks.onPlace});
  }
  showHistories(lines, field, at) {        // lines: {label, time, values, colour, dash, id}
    const span = lines.reduce((m, l) => Math.max(m, l.time.at(-1) || 0), 0) || 1, [tUnit, ft] = H.timeUnit(span);
    const top = lines.reduce((m, l) => { for (const v of l.values) if (Math.abs(v) > m) m = Math.abs(v); return m; }, 0), [unit, factor] = field.unit === "Pa" ? H.fits([top], "GPa", 1e-9) : [field.shown, field.factor];
    Object.assign(this, {ft, tUnit, unit, factor, lines});
    const series = lines.map(l => { const [x, y] = H.thinned(l.time, l.values); return {kind: l.points ? "points" : "line", size: 2.4, id: l.label, colour: l.colour, dash: l.dash, faint: l.faint, width: 1.5, hover: true, label: l.label, si: [x, y], x: x.map(v => v * ft), y: y.map(v => v * factor)}; });
    const marks = at === null ? [] : [{kind: "vline", x: at * ft, colour: "quiet", dash: "4 3"}];
    this.histories.show({series, marks, x: {label: H.labelled("time", tUnit), min: 0, max: span * ft}, y: {label: H.labelled(field.words, unit)}});
  }
  showProfile(x, values, field, regions, time, word, others = []) {      // word: of the coordinate; others: {x, values, regions, suffix, dash}
    const [xUnit, fx] = H.lengthUnit(x.at(-1) - x[0]), top = values.reduce((m, v) => Math.max(m, Math.abs(v)), 0), [unit, factor] = field.unit === "Pa" ? H.fits([top], "GPa", 1e-9) : [field.shown, field.factor];
    const [tUnit, ft] = H.timeUnit(time || 1e-6), all = [{x, values, regions, suffix: "", dash: null}, ...others];
    const series = all.flatMap(({x, values, regions, suffix, dash}) => regions.map((r, k) => {
      const part = [x, values].map(v => Array.from(v.slice(r.first, r.last + 1))), id = r.name + suffix;
      return {kind: "line", id, colour: k, dash, hover: true, width: 1.5, label: id, si: part, first: r.first, x: part[0].map(v => v * fx), y: part[1].map(v => v * factor)};
    }));
    Object.assign(this, {pUnit: unit, pFactor: factor, fx, xUnit});
    this.profile.show({series, x: {label: H.labelled(`${word}, at ${H.digits(time * ft, 4)} ${tUnit}`, xUnit)}, y: {label: H.labelled(field.words, unit)}});
  }
  stop() { this.histories.stop(); this.profile.stop(); }
};
