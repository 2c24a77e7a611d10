"use strict";
// Shocks, releases and impacts, computed in the page. The laws and the searches for a state are H.theory, transcribed from the package; here they
// are asked for one state at a time, as theory.hugoniot, theory.isentrope and theory.riemann ask them for many.
H.impact = (() => {
  const T = H.theory, BY = {pressure: 0, particle_velocity: 1, shock_velocity: 2, density: 3}, FEEBLE = 1e-6, ALONG = 24;
  const beyond = par => new H.Refused(`${par.called}: outside the range of its equation of state (law ${par.law.name}); the command below shows the limit`);
  const answered = (par, work) => { try { return work(); } catch (error) { throw error instanceof T.NoState ? new H.Refused(`${par.called}: ${error.message}`) : error; } };

  // -- materials: parameters of a law, with its functions under `law`
  const law = (given, called) => given === null || typeof given !== "object" ? (typeof given === "string" ? T.number(given) : given)
    : Array.isArray(given) ? given.map(v => law(v, called))
    : {law: T.laws[given.$], called, ...Object.fromEntries(Object.entries(given).filter(([key]) => key !== "$").map(([key, value]) => [key, law(value, called)]))};
  async function layer(name) {
    const all = await H.askOnce("layers"), own = await H.resolved(name), found = all[own];
    if (!found) { if (!H.exported()) await H.ask("about", {name}); throw new H.Refused(`${name} is not a complete material of the library`); }
    if (found.none) throw new H.Refused(`${own}: ${found.none}`);
    return {...found, name: own, par: law(found.law, own)};
  }

  // -- states
  const reference = (par, velocity = 0) => { const [density, energy] = T.reference_state(par); return {par, density, pressure: T.pressure(density, energy, par), specific_internal_energy: energy, particle_velocity: velocity, shock_velocity: null}; };
  const squared = (par, s) => T.sound_speed_squared(s.density, s.specific_internal_energy, par);
  const known = value => Number.isFinite(value) ? value : null;
  const gives = (par, name) => name in par.law && Object.values(par).every(inner => !inner?.law || gives(inner, name));     // laws inside too
  const columns = s => { const {par, density, pressure, specific_internal_energy, particle_velocity, shock_velocity} = s, at = [density, specific_internal_energy, par]; return {pressure, density, particle_velocity, shock_velocity, specific_internal_energy, temperature: gives(par, "temperature") ? known(T.temperature(...at)) : null, sound_speed: known(Math.sqrt(squared(par, s)))}; };
  const more = s => { const at = [s.density, s.specific_internal_energy, s.par]; return {entropy: gives(s.par, "entropy") ? known(T.entropy(...at)) : null, gruneisen: T.gruneisen(...at), adiabatic_exponent: known(s.density * squared(s.par, s) / s.pressure)}; };

  function shock(par, start, by, value, direction = 1) {        // into `start`
    const ahead = {density: start.density, pressure: start.pressure, energy: start.specific_internal_energy, heat: 0}, velocity = by.endsWith("velocity");
    const wanted = velocity ? direction * (value - start.particle_velocity) : value, mode = BY[by];
    if (!Number.isFinite(wanted) || (velocity && wanted < 0) || (by === "pressure" && wanted < ahead.pressure) || (by === "shock_velocity" && wanted === 0)) throw beyond(par);
    const [v0, least, most] = answered(par, () => T.interval(par, ahead)), floor = T.crushed(par, ahead, v0), c0 = T.sound_speed_ahead(par, ahead);
    const target = by === "shock_velocity" ? wanted * ahead.density : wanted, rest = {pressure: ahead.pressure, particle_velocity: 0, density: ahead.density}[by];
    let x = 0, p = ahead.pressure, e = ahead.energy, status = 0;
    if (target !== rest || floor > 0) [status, x, p, e] = T.shocked(mode, target, Math.max(T.first_guess(mode, target, v0, ahead.pressure, c0), floor), least, most, v0, ahead.pressure, ahead.energy, par);
    const rise = Math.max(p - ahead.pressure, 0), up = by === "particle_velocity" ? wanted : Math.sqrt(rise * Math.max(x, 0));
    if (status !== 0 || up > T.fastest(par, ahead) * (1 + 1e-9)) throw beyond(par);
    const still = (p === ahead.pressure || x <= 0) && !T.distended(par, ahead), us = still ? c0 : x > 0 ? Math.sqrt(rise / x) / ahead.density : 0;
    return {par, density: 1 / (1 / ahead.density - x), pressure: p, specific_internal_energy: e, particle_velocity: start.particle_velocity + direction * up, shock_velocity: start.particle_velocity + direction * us};
  }
  function isentrope(par, start, pressure, direction) {
    const [low, high] = T.density_range(par), y0 = Math.log(start.density);
    const [status, y, e, u] = T.to_pressure(y0, start.specific_internal_energy, 0, pressure, Math.log(low), Number.isFinite(high) ? Math.log(high) : 700, par);
    if (status !== 0) throw beyond(par);
    return {par, density: y === y0 ? start.density : Math.exp(y), pressure, specific_internal_energy: e, particle_velocity: start.particle_velocity + direction * u, shock_velocity: null};
  }
  const remembers = par => par.law.flags.includes("remembers"), elastic = par => remembers(par) ? {...T.unloading(par), called: par.called} : par;
  function history(par, start) {         // the law as the loading to `start` left it
    if (!remembers(par)) return par;
    const own = start.par.law === par.law ? start.par : par, branch = elastic(own), at = [start.density, start.specific_internal_energy];
    if (Math.abs(T.pressure(...at, branch) - start.pressure) <= 1e-10 * start.density * Math.abs(squared(branch, start))) return own;
    return {...T.remembered(T.compacted(0, ...at, start.pressure, own), own), called: par.called};
  }
  function release(par, start, to, points, direction) {
    const branch = elastic(history(par, start)), found = [];
    let here = start;
    for (let k = 0; k < points; k++) { const p = start.pressure + (to - start.pressure) * k / (points - 1); here = p === start.pressure ? {...start, par: branch, shock_velocity: null} : isentrope(branch, here, p, direction); found.push(here); }
    return found;
  }

  // -- where two wave curves meet
  class Side {
    constructor(par, state, direction) {
      this.par = history(par, state);
      this.elastic = elastic(this.par);
      this.state = state;
      this.direction = direction;
      const square = squared(this.par, state);
      if (!(square > 0)) throw beyond(par);
      this.c = Math.sqrt(square);
      this.fan = {...state, par: this.elastic};
      this.weak = FEEBLE * state.density * square;       // below this rise a shock is found as an isentrope
    }
    behind(p) {
      const {state, direction} = this, shocked = () => shock(this.par, state, "pressure", p, direction);
      if (p > state.pressure + this.weak) return shocked();
      if (p === state.pressure) return state;
      this.fan = isentrope(p < state.pressure ? this.elastic : this.par, this.fan, p, direction);
      if (p > state.pressure && this.fan.density > (1 + FEEBLE) * state.density) return shocked();
      const rise = p - state.pressure, gained = Math.abs(this.fan.particle_velocity - state.particle_velocity);
      return {...this.fan, par: this.par, shock_velocity: rise > 0 ? state.particle_velocity + direction * (rise > 0.01 * this.weak ? rise / (state.density * gained) : this.c) : null};
    }
    slope(p, behind) {          // |du/dp|
      const {state} = this, rho = behind.density;
      if (p <= state.pressure + this.weak) return 1 / (rho * Math.sqrt(squared(p < state.pressure ? this.elastic : this.par, behind)));
      const rise = p - state.pressure, x = 1 / state.density - 1 / rho, [slope, heat] = T.pressure_derivatives(rho, behind.specific_internal_energy, this.par);
      return x > 0 ? 0.5 * (x + rise * (1 - 0.5 * heat * x) / (rho * rho * slope + 0.5 * heat * (p + state.pressure))) / Math.sqrt(rise * x) : 1 / (rho * this.c);
    }
    wave(p) {
      const {state} = this;
      if (Math.abs(p - state.pressure) <= 1e-15 * Math.max(Math.abs(p), Math.abs(state.pressure))) return ["none", state];
      return [p > state.pressure ? "shock" : "fan", this.behind(p)];
    }
    curve(through, top) {       // states by the wave, from released to reshocked, as far as the law goes
      const {state, direction} = this, floor = Math.max(Math.min(reference(this.par).pressure, state.pressure), 0), mine = [state], span = top - state.pressure;
      const go = (list, levels, found) => { try { for (const p of levels) list.push(found(p)); } catch (error) { if (!(error instanceof H.Refused)) throw error; } };
      if (span > 0) go(mine, [...Array(ALONG).keys()].map(k => state.pressure + span * ((k + 1) / ALONG) ** 2).concat(through > state.pressure ? through : []).sort((a, b) => a - b), p => shock(this.par, state, "pressure", p, direction));
      const down = [];
      let here = {...state, par: this.elastic};
      if (state.pressure > floor + 1e-6 * top) go(down, [...Array(ALONG).keys()].map(k => state.pressure + (floor - state.pressure) * (k + 1) / ALONG).concat(through < state.pressure ? through : []).sort((a, b) => b - a), p => here = isentrope(this.elastic, here, p, direction));
      const drawn = [...down.reverse(), ...mine];
      return {particle_velocity: drawn.map(s => s.particle_velocity), pressure: drawn.map(s => s.pressure)};
    }
  }
  function meet(left, right) {          // the pressure at which both have one velocity: Newton in a bracket
    const za = left.state.density * left.c, zb = right.state.density * right.c, lowest = Math.min(left.state.pressure, right.state.pressure);
    let p = (zb * left.state.pressure + za * right.state.pressure + za * zb * (left.state.particle_velocity - right.state.particle_velocity)) / (za + zb), low = 0, high = Infinity, g = NaN;
    if (p <= 0) p = 0.5 * (lowest > 0 ? lowest : Math.max(left.state.pressure, right.state.pressure, 1e-9 * (za * left.c + zb * right.c)));
    for (let k = 0; k < 200; k++) {
      const a = left.behind(p), b = right.behind(p);
      g = b.particle_velocity - a.particle_velocity;
      if (g === 0) return p;
      if (g < 0) low = p; else high = p;
      let next = p - g / (right.slope(p, b) + left.slope(p, a));
      if (Number.isFinite(high) && !(low < next && next < high)) next = low > 0 ? Math.sqrt(low * high) : 0.5 * (low + high);
      else if (next <= low) next = low === 0 ? 0.1 * p : 0.5 * (p + low);
      else if (next >= high) next = 0.5 * (p + high);
      next = Math.min(next, 100 * p);
      if (Math.abs(next - p) <= 2e-15 * Math.max(Math.abs(p), 1e-9 * (za + zb))) return next;
      p = next;
    }
    if (Math.abs(g) <= 1e-9 * (left.c + right.c)) return p;
    throw new H.Refused(`The wave curves of ${left.par.called} and ${right.par.called} do not intersect`);
  }
  function match(pars, velocity) {
    const met = [];
    let arriving = reference(pars[0], velocity);
    for (let k = 0; k + 1 < pars.length; k++) {
      const left = new Side(pars[k], arriving, -1), right = new Side(pars[k + 1], reference(pars[k + 1]), 1), p = meet(left, right);
      const [reflected, behind] = left.wave(p), [transmitted, ahead] = right.wave(p);
      met.push({left, right, reflected, transmitted, behind, ahead});
      arriving = ahead;
    }
    return met;
  }

  // -- error bands: linear propagation through central differences over half a standard deviation
  const ANSWERS = ["pressure", "particle_velocity", "shock_velocity", "density"];
  function spreads(layers, velocity, sigma, bands) {
    const inputs = sigma > 0 ? [{name: null, of: "velocity", sigma}] : [], of = (a, b) => a === b ? a.sigma ** 2 : a.name !== null && a.name === b.name ? a.covariance[a.at][b.at] : 0;
    for (const {name, bands: known} of bands ? new Map(layers.map(l => [l.name, l])).values() : []) known?.names.forEach((p, at) => inputs.push({name, of: p, at, sigma: Math.sqrt(known.covariance[at][at]), covariance: known.covariance}));
    if (!inputs.length) return {rows: null, used: []};
    const moved = (input, by) => match(layers.map(l => l.name === input.name ? {...l.par, [input.of]: l.par[input.of] + by} : l.par), input.name === null ? velocity + by : velocity).map(m => m.ahead);
    const slopes = inputs.map(input => { const h = 0.5 * input.sigma, up = moved(input, h), down = moved(input, -h); return up.map((s, i) => ANSWERS.map(key => (s[key] - down[i][key]) / (2 * h))); });
    const rows = slopes[0].map((_, i) => Object.fromEntries(ANSWERS.map((key, n) => [key, Math.sqrt(Math.max(0, inputs.reduce((sum, a, j) => sum + inputs.reduce((part, b, k) => part + slopes[j][i][n] * of(a, b) * slopes[k][i][n], 0), 0)))])));
    return {rows, used: [...new Set(inputs.map(input => input.name ?? "velocity"))]};
  }

  const about = (l, jump) => [...(l.split && jump >= l.split.low && jump <= l.split.high ? [l.split.words] : []), ...(l.beyond && jump > l.beyond.limit ? [l.beyond.words] : [])].map(words => words.replace("{up}", H.digits(jump)));
  function warnings(layers, velocity, met) {
    const jump = i => i === 0 ? velocity - met[0].behind.particle_velocity : met[i - 1].ahead.particle_velocity;
    return [...new Set(layers.flatMap((l, i) => [...about(l, jump(i)), ...l.warnings]))];
  }

  // the states at every interface, flyer first, SI, with the curves that meet there
  async function impact(names, velocity, {sigma = 0, bands = false} = {}) {
    const layers = await Promise.all(names.map(layer)), met = match(layers.map(l => l.par), velocity), top = 1.3 * Math.max(...met.map(m => m.ahead.pressure)), {rows, used} = spreads(layers, velocity, sigma, bands);
    const shown = names.map((name, k) => layers[k].unreacted ? `${name} (unreacted)` : name);
    return {layers: names, shown, titles: layers.map(l => l.title), velocity, uncertain: used, warnings: warnings(layers, velocity, met),
      states: met.map((m, i) => ({interface: `${shown[i]}/${shown[i + 1]}`, ...columns(m.ahead), reflected: m.reflected, transmitted: m.transmitted, ...(rows ? {uncertainty: rows[i]} : {})})),
      curves: met.map(m => ({behind: m.left.curve(m.behind.pressure, top), ahead: m.right.curve(m.ahead.pressure, top)}))};
  }

  // one state of the principal Hugoniot, with the release from it
  async function state(name, by, value) {
    const one = await layer(name), {par} = one, ahead = reference(par), scale = 1e-12 * ahead.density * Math.abs(squared(par, ahead));
    if (Math.abs(ahead.pressure) < scale) ahead.pressure = 0;
    const found = shock(par, ahead, by, value), table = {}, told = [...about(one, found.particle_velocity), ...one.of_law];
    if (!one.of_law.length) try { release(par, found, Math.max(reference(par).pressure, 0), 25, -1).map(s => ({...columns(s), entropy: more(s).entropy, specific_volume: 1 / s.density})).forEach(s => Object.entries(s).forEach(([key, v]) => (table[key] ||= []).push(v))); } catch (error) { if (!(error instanceof H.Refused)) throw error; }
    for (const key of Object.keys(table)) if (table[key].every(v => v === null)) delete table[key];
    const {entropy, ...rest} = more(found);
    return {state: {...columns(found), entropy, ...(one.of_law.length ? {} : rest)}, ahead: {density: ahead.density, pressure: ahead.pressure}, release: table.pressure ? table : null, warnings: told};
  }

  // the deck of an impact: a flyer of 2 mm on layers of 4 mm, with gauges at the interfaces and on the free surface
  async function deck(names, velocity) {
    const layers = await Promise.all(names.map(layer)), burning = layers.find(l => l.burns);
    if (burning) throw new H.Refused(`${burning.name}: an explosive, which burns in a run; the match treats it as inert, so no deck is offered`);
    const met = match(layers.map(l => l.par), velocity), print = (value, digits) => String(Number(value.toPrecision(digits)));
    const called = ["flyer", ...(names.length === 2 ? ["target"] : names.length === 3 ? ["target", "backing"] : names.slice(1).map((_, k) => `layer ${k + 1}`))];
    const stop = 1.6 * met.reduce((sum, m) => sum + 4e-3 / (m.ahead.shock_velocity || Math.sqrt(squared(m.ahead.par, m.ahead))), 0) * 1e6, words = layers.map(l => l.title).join(" on ").replace(/"/g, "'").replace(/\\/g, "/");
    const head = [...layers.filter((l, k) => H.files[l.name] && layers.findIndex(o => o.name === l.name) === k).map(l => `# The tables of ${l.name} in ${H.files[l.name]} belong in this deck, under [material.${l.name}]`), "# Expected from impedance matching, without strength:", ...met.map((m, i) => `#   ${layers[i].name}/${layers[i + 1].name}: ${print(m.ahead.pressure * 1e-9, 5)} GPa, ${print(m.ahead.particle_velocity, 5)} m/s`),
      `title = "${words}, ${print(velocity, 6)} m/s"`, 'geometry = "planar"', `stop_time = "${print(stop, 3)} us"`];
    const regions = layers.map((l, k) => ["", "[[region]]", `name = "${called[k]}"`, `material = "${l.name}"`, `from = "${k && 4 * k - 2} mm"`, `to = "${4 * k + 2} mm"`, 'zone_size = "20 um"', ...(k ? [] : [`velocity = "${print(velocity, 9)} m/s"`])]);
    const gauges = called.slice(1).map((b, k) => ["", "[[gauge]]", `name = "${called[k]}/${b}"`, `at = "${called[k]}/${b}"`]);
    return [...head, ...regions.flat(), ...gauges.flat(), "", "[[gauge]]", 'name = "free surface"', 'at = "free surface right"', "", "[output]", `snapshots = "${print(stop / 150, 3)} us"`, ""].join("\n");
  }
  return {impact, state, deck, law, match};
})();
