"use strict";
// A chart as a file: always on white paper, whatever the page looks like.
H.chartFile = (chart, width = 760) => {
  const height = Math.round(Math.min(Math.max(width * chart.options.height, chart.options.least), chart.options.most));
  const frame = chart.layout(width, height), p = H.palettes.light;
  const svg = H.s("svg", {xmlns: SVG_NS, width, height, viewBox: `0 0 ${width} ${height}`});
  svg.append(H.s("rect", {width, height, fill: p.paper}));
  if (chart.spec.paint) {
    const wide = 2 * Math.round(width - frame.left - frame.right), high = 2 * Math.round(height - frame.top - frame.bottom);
    const canvas = H.h("canvas", {width: wide, height: high}), context = canvas.getContext("2d"), image = context.createImageData(wide, high);
    chart.spec.paint(new Uint32Array(image.data.buffer), wide, high, frame.x, frame.y, p);
    context.putImageData(image, 0, 0);
    svg.append(H.s("image", {x: frame.left, y: frame.top, width: width - frame.left - frame.right, height: height - frame.top - frame.bottom, href: canvas.toDataURL("image/png")}));
  }
  chart.render(svg, frame, p);
  svg.querySelectorAll(".handle").forEach(handle => handle.remove());
  return svg;
};
const download = (blob, name) => {
  const link = H.h("a", {href: URL.createObjectURL(blob), download: name});
  document.body.append(link); link.click(); link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 5000);
  H.say(`saved ${name}`);
};
H.saveSvg = (chart, name) => download(new Blob(['<?xml version="1.0" encoding="UTF-8"?>\n', new XMLSerializer().serializeToString(H.chartFile(chart))], {type: "image/svg+xml"}), `${name}.svg`);
H.savePng = (chart, name) => {
  const svg = H.chartFile(chart), width = Number(svg.getAttribute("width")), height = Number(svg.getAttribute("height"));
  const source = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(svg)], {type: "image/svg+xml"})), picture = new Image();
  picture.onload = () => {
    const canvas = H.h("canvas", {width: 2.5 * width, height: 2.5 * height}), context = canvas.getContext("2d");
    context.drawImage(picture, 0, 0, canvas.width, canvas.height);
    URL.revokeObjectURL(source);
    canvas.toBlob(blob => download(blob, `${name}.png`), "image/png");
  };
  picture.src = source;
};
H.saveButtons = (chart, name) => [
  H.h("button", {type: "button", onclick: () => H.saveSvg(chart(), name()), title: "Save the plot as SVG"}, "SVG"),
  H.h("button", {type: "button", onclick: () => H.savePng(chart(), name()), title: "Save the plot as PNG"}, "PNG"),
];
H.saveText = (text, name) => download(new Blob([text], {type: "text/plain"}), name);
