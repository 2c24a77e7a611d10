"use strict";
// Pressure or energy over density and temperature, computed in the page by the transcribed laws: lines of equal temperature, and a heat map
// whose curves, or the computed states themselves, are walked by the pointer.
(() => {
  const POINTS = 61, ISOTHERMS = [0, 300, 1000, 2000, 4000, 8000], MOST = 24, KEPT = 24, kept = new Map();
  const FIELDS = {pressure: ["pressure", "GPa", 1e-9], specific_internal_energy: ["internal energy", "kJ/kg", 1e-3]};
  H.surfaceFields = FIELDS;

  const listed = key => H.get(key).split(",").filter(part => part.trim()).map(Number);
  const spaced = (from, to) => Array.from({length: POINTS}, (_, k) => k === POINTS - 1 ? to : from + k * ((to - from) / (POINTS - 1)));
  const pair = (values, words) => { if (values.length !== 2 || !(values[0] >= 0 && values[0] < values[1])) throw new H.Refused(`${words}: give two increasing numbers`); return values; };
  function lines({temperatures, grid}) {       // the temperatures of isotherms
    const given = listed("iso"), values = [...new Set(given.length ? given : ISOTHERMS)].sort((a, b) => a - b);
    if (values.length > MOST || !values.every(t => t >= 0)) throw new H.Refused(`give up to ${MOST} temperatures for the isotherms, none below 0 K`);
    const inside = grid ? values.filter(t => t >= grid[0] && t <= grid[1]) : values;
    return given.length ? inside : inside.filter(t => t <= Math.max(temperatures[1], 1000));
  }
  function compute(c, isotherms) {
    const range = c.surface_range, T = H.theory;
    if (range.refused) throw new H.Refused(`${c.name}: ${range.refused}`);
    const par = H.impact.law(range.law, c.name), [least, most] = T.density_range(par);
    const [low, high] = H.get("rho") ? pair(listed("rho"), "densities") : range.densities;
    if (!(least <= low && high < most)) throw new H.Refused(`${c.name}: the law is defined for densities from ${H.digits(Math.max(least, 1e-6))}${Number.isFinite(most) ? ` to ${H.digits(most)}` : ""} kg/m³`);
    const density = spaced(low, high), temperature = isotherms ? lines(range) : spaced(...H.get("hot") ? pair(listed("hot"), "temperatures") : range.temperatures);
    const found = {name: c.name, density, temperature, pressure: [], specific_internal_energy: []};
    for (const rho of density) {
      const states = temperature.map(t => { try { const e = T.energy_at_temperature(rho, t, par), p = T.pressure(rho, e, par); return Number.isFinite(p + e) ? [p, e] : [null, null]; } catch (error) { if (error instanceof T.NoState) return [null, null]; throw error; } });
      found.pressure.push(states.map(s => s[0]));
      found.specific_internal_energy.push(states.map(s => s[1]));
    }
    return found;
  }
  // pressure (Pa) and energy (J/kg), [density][temperature], null where the law has no such state; the ranges are those of the address
  H.surface = (c, isotherms) => {
    const key = [c.name, isotherms, H.get("rho"), isotherms ? H.get("iso") : H.get("hot")].join(";");
    if (!kept.has(key)) { if (kept.size >= KEPT) kept.delete(kept.keys().next().value); kept.set(key, compute(c, isotherms)); }
    return kept.get(key);
  };
  const column = (grid, j) => grid.map(row => row[j]);

  // lines of equal temperature; the one at 0 K is the cold curve
  H.isothermPlane = {axes: [{label: "specific volume (cm³/g)"}, {label: "pressure (GPa)"}], series(c, colour, options, several) {
    if (!c.isotherms) return [];
    const {density, temperature, pressure, specific_internal_energy} = c.isotherms, volume = density.map(r => 1 / r), found = [];
    temperature.forEach((t, j) => {
      const p = column(pressure, j), words = t === 0 ? "0 K, cold curve" : `${H.digits(t, 5)} K`;
      found.push({kind: "line", id: t === 0 ? "cold curve" : "isotherm", name: c.name, colour, dash: t === 0 ? "6 3" : null, width: 1.5, hover: true, label: !several ? words : j === 0 || j === temperature.length - 1 ? `${c.short}, ${words}` : "",
        table: {temperature: density.map(() => t), density, pressure: p, specific_internal_energy: column(specific_internal_energy, j), specific_volume: volume}, x: volume.map(v => v * 1e3), y: p.map(v => v === null ? null : v * 1e-9)});
    });
    return found;
  }, marks: () => []};

  // the heat map of one material; spec of a chart
  H.surfaceSpec = (c, chart, colour) => {
    const {density, temperature} = c.surface, key = FIELDS[H.get("quantity")] ? H.get("quantity") : "pressure", grid = c.surface[key], [words, unit, factor] = FIELDS[key], n = density.length, m = temperature.length;
    let low = Infinity, high = -Infinity;
    for (const row of grid) for (const v of row) if (v !== null) { if (v < low) low = v; if (v > high) high = v; }
    const scale = H.scaleOf(low, high), inside = (table, k) => ({...table, at: k});
    const curves = [["hugoniot", c.hugoniot, null], ["isentrope", c.isentrope, "6 3"], ...c.releases.map(r => ["release", r, "2 3"]), ["release", c.pinned?.release, "2 3"], ["release", c.products?.isentrope, "2 3"]].filter(([, t]) => t?.temperature);
    const series = curves.map(([id, table, dash], k) => inside({kind: "line", id, name: c.name, table, colour: "ink", dash, width: id === "hugoniot" ? 1.8 : 1.2, hover: H.get("walk") !== "0", x: table.density, y: table.temperature,
      label: id === "hugoniot" ? "Hugoniot" : id === "isentrope" ? "isentrope from rest" : curves.findIndex(x => x[0] === "release") === k ? "releases" : ""}, k));
    const step = [(density[n - 1] - density[0]) / (n - 1), (temperature[m - 1] - temperature[0]) / (m - 1)];
    const paint = (pixels, wide, tall, ax, ay) => {
      const table = scale.ramp, by = 255 / (scale.high - scale.low);
      for (let row = 0; row < tall; row++) {
        const g = (ay.value(ay.to + (row + 0.5) / tall * (ay.from - ay.to)) - temperature[0]) / step[1], j = Math.min(Math.max(Math.floor(g), 0), m - 2), b = g - j;
        if (g < 0 || g > m - 1) continue;
        for (let col = 0; col < wide; col++) {
          const f = (ax.value(ax.from + (col + 0.5) / wide * (ax.to - ax.from)) - density[0]) / step[0], i = Math.min(Math.max(Math.floor(f), 0), n - 2), a = f - i;
          if (f < 0 || f > n - 1) continue;
          const four = [grid[i][j], grid[i + 1][j], grid[i][j + 1], grid[i + 1][j + 1]];
          if (four.includes(null)) continue;
          const v = (1 - b) * ((1 - a) * four[0] + a * four[1]) + b * ((1 - a) * four[2] + a * four[3]);
          pixels[row * wide + col] = table[Math.min(Math.max(Math.round((v - scale.low) * by), 0), 255)];
        }
      }
    };
    const readings = (rho, t) => {
      const i = Math.min(Math.max(Math.round((rho - density[0]) / step[0]), 0), n - 1), j = Math.min(Math.max(Math.round((t - temperature[0]) / step[1]), 0), m - 1), f = chart.frame;
      return {node: {density: density[i], temperature: temperature[j], pressure: c.surface.pressure[i][j], specific_internal_energy: c.surface.specific_internal_energy[i][j]}, px: f.x.at(density[i]), py: f.y.at(temperature[j]), step: [f.x.at(step[0] + density[0]) - f.x.at(density[0]), f.y.at(temperature[0]) - f.y.at(step[1] + temperature[0])]};
    };
    return {series, marks: [], plain: true, x: {label: "density (kg/m³)", min: density[0], max: density[n - 1]}, y: {label: "temperature (K)", min: temperature[0], max: temperature[m - 1]}, bar: {scale, factor, label: H.labelled(words, unit)}, paint, ...(H.get("walk") === "0" ? {readings} : {})};
  };
})();
