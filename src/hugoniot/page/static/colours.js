"use strict";
// Colours that colour-blind readers tell apart (Okabe and Ito), as in the pictures of `hugoniot plot`, and a set for dark ground.
H.palettes = {
  light: {lines: ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#7a6a00", "#000000"], ink: "#222222", quiet: "#767676",
          faint: "#d9d9d9", paper: "#ffffff", text: "#222222"},
  dark: {lines: ["#56B4E9", "#F0803C", "#2CC295", "#E39BC5", "#F0B93A", "#A6D8F5", "#CDBB3A", "#F2F2F2"], ink: "#e9ebed", quiet: "#a4abb2",
         faint: "#363c42", paper: "#15181b", text: "#e9ebed"},
};
H.theme = () => document.documentElement.dataset.theme === "dark" ? "dark" : "light";
H.palette = () => H.palettes[H.theme()];

const ramp = (stops) => {       // 256 colours through the stops (position, #rrggbb), as 0xAABBGGRR
  const table = new Uint32Array(256);
  const parts = stops.map(([at, hex]) => [at, [1, 3, 5].map(i => parseInt(hex.slice(i, i + 2), 16))]);
  for (let k = 0; k < 256; k++) {
    const x = k / 255;
    let j = 1;
    while (j < parts.length - 1 && parts[j][0] < x) j++;
    const [a, low] = parts[j - 1], [b, high] = parts[j], w = Math.min(Math.max((x - a) / (b - a), 0), 1);
    const [r, g, bl] = low.map((v, i) => Math.round(v + w * (high[i] - v)));
    table[k] = (255 << 24 | bl << 16 | g << 8 | r) >>> 0;
  }
  return table;
};
// zero stress is grey: blank is where there is no material
H.ramps = {
  stress: ramp([[0, "#08306b"], [0.25, "#2171b5"], [0.42, "#9ecae1"], [0.5, "#e3e1dc"], [0.58, "#fdd49e"], [0.72, "#fc8d59"], [0.87, "#d7301f"], [1, "#67000d"]]),
  rising: ramp([[0, "#440154"], [0.13, "#472d7b"], [0.25, "#3b528b"], [0.38, "#2c728e"], [0.5, "#21918c"], [0.63, "#28ae80"], [0.75, "#5ec962"], [0.88, "#addc30"], [1, "#fde725"]]),
};
// the ramp and its limits for values: about zero for what has both signs
H.scaleOf = (low, high) => {
  if (low < -1e-3 * Math.abs(high) && high > 0 || low < 0 && high > 1e-3 * Math.abs(low)) {
    const top = Math.max(-low, high);
    return {ramp: H.ramps.stress, low: -top, high: top};
  }
  return {ramp: H.ramps.rising, low, high: high > low ? high : low + (Math.abs(low) * 1e-6 || 1)};
};
H.css = abgr => `rgb(${abgr & 255},${abgr >> 8 & 255},${abgr >> 16 & 255})`;
