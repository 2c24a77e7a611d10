"use strict";
// A flyer on one target, from the sampled Hugoniots of both: while the velocity is dragged, and where there is no server.
// Cubics through four samples cross in the answer; how far other four samples move it says how many digits hold (few near a bend).
H.matchFromCurves = async (names, v) => {
  if (names.length > 2) throw new H.Refused("An exported page matches a flyer and one target; hugoniot explore also computes the reshock and release of further layers");
  const [flyer, target] = await Promise.all(names.map(async name => H.askOnce("material", {name: await H.resolved(name)})));
  for (const c of [flyer, target]) if (!c.hugoniot) throw new H.Refused(`${c.name}has no Hugoniot from rest`);
  const up = c => c.hugoniot.particle_velocity, most = Math.min(v, up(target).at(-1)), least = Math.max(0, v - up(flyer).at(-1));
  const crossing = (flyerWay, targetWay) => {
    const excess = u => targetWay(up(target), target.hugoniot.pressure, u) - flyerWay(up(flyer), flyer.hugoniot.pressure, v - u);
    let low = least, high = most;
    if (!(low < high) || excess(low) > 0 || excess(high) < 0) throw new H.Refused("This impact is beyond the sampled curves; hugoniot explore computes it");
    for (let k = 0; k < 60; k++) { const middle = (low + high) / 2; if (excess(middle) > 0) high = middle; else low = middle; }
    return low;
  };
  const u = crossing(cubic, cubic), others = [crossing(beside, cubic), crossing(cubic, beside)], p = cubic(up(target), target.hugoniot.pressure, u), q = beside(up(target), target.hugoniot.pressure, u);
  const off = Math.max(...others.map(o => Math.abs(o - u) / u), Math.abs(q - p) / p), digits = Math.min(Math.max(Math.floor(-Math.log10(off)), 2), 5);
  const state = Object.fromEntries(Object.keys(target.hugoniot).map(key => [key, key === "particle_velocity" ? u : target.hugoniot[key] ? cubic(up(target), target.hugoniot[key], u) : null]));
  const of = (c, mirror) => ({particle_velocity: mirror ? up(c).map(w => v - w) : up(c), pressure: c.hugoniot.pressure});
  return {layers: names, velocity: v, digits, states: [{interface: names.join("/"), ...state, reflected: "shock", transmitted: "shock"}], curves: [{behind: of(flyer, true), ahead: of(target, false)}], uncertain: [],
    warnings: H.exported() ? [`Interpolated from the exported curves, to ${digits} digits.`] : []};
};
const piece = (xs, x) => { let a = 0, b = xs.length - 1; while (b - a > 1) { const m = (a + b) >> 1; if (xs[m] <= x) a = m; else b = m; } return a; };
function cubic(xs, ys, x, aside = 0) {       // through four neighbouring states, or those one further
  const k = Math.min(Math.max(piece(xs, x) - 1 + aside, 0), xs.length - 4);
  let sum = 0;
  for (let i = k; i < k + 4; i++) { let w = ys[i]; for (let j = k; j < k + 4; j++) if (j !== i) w *= (x - xs[j]) / (xs[i] - xs[j]); sum += w; }
  return sum;
}
const beside = (xs, ys, x) => cubic(xs, ys, x, piece(xs, x) < xs.length / 2 ? 1 : -1);
