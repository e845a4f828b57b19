// Error against time of variants, both on scales of powers of ten.

/** Return the powers of ten about some values, and where a value lies between them. */
function powers(values, from, to) {
  const low = Math.floor(Math.log10(Math.min(...values))), high = Math.ceil(Math.log10(Math.max(...values)) + 1e-9);
  const last = high > low ? high : low + 1;
  const ticks = Array.from({ length: last - low + 1 }, (_, k) => low + k);
  return [ticks, (value) => from + ((Math.log10(value) - low) / (last - low)) * (to - from)];
}

/** Return a chart of points with a time (µs) and an error, the best ones marked. */
function errorChart(chart) {
  const W = 1000, H = 520, points = chart.points.filter((p) => p.time > 0 && p.error > 0);
  const svg = shape("svg", { viewBox: `0 0 ${W} ${H}`, role: "img", "aria-label": `error against time of ${points.length} variants; the table has them all` });
  if (points.length === 0) return svg;
  const [times10, x] = powers(points.map((p) => p.time), 70, W - 30);
  const [errors10, y] = powers(points.map((p) => p.error), H - 50, 20);
  const label = (k) => `1e${k}`;
  times10.forEach((k) => {
    svg.append(shape("line", { class: "rule", x1: x(10 ** k), x2: x(10 ** k), y1: 20, y2: H - 50 }));
    svg.append(shape("text", { class: "muted", x: x(10 ** k), y: H - 32, "font-size": 13, "text-anchor": "middle" }, label(k)));
  });
  errors10.forEach((k) => {
    svg.append(shape("line", { class: "rule", x1: 70, x2: W - 30, y1: y(10 ** k), y2: y(10 ** k) }));
    if (errors10.length < 14 || k % 2 === 0) svg.append(shape("text", { class: "muted", x: 62, y: y(10 ** k) + 4, "font-size": 13, "text-anchor": "end" }, label(k)));
  });
  svg.append(shape("text", { x: W / 2, y: H - 8, "font-size": 14, "text-anchor": "middle" }, "time of an evaluation, µs"));
  svg.append(shape("text", { x: 70, y: 14, "font-size": 14 }, "largest error"));
  const teams = [...new Set(points.map((p) => p.team))], shades = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#808080"];
  points.forEach((p) => {
    const fill = p.front ? shades[teams.indexOf(p.team) % shades.length] : "none";
    const dot = shape("circle", { cx: x(p.time), cy: y(p.error), r: p.front ? 7 : 5, fill, stroke: shades[teams.indexOf(p.team) % shades.length], "stroke-width": 2 });
    dot.append(shape("title", {}, `${p.label}: ${p.time.toPrecision(3)} µs, ${p.error.toExponential(1)}`));
    svg.append(dot);
  });
  teams.forEach((team, k) => {
    svg.append(shape("circle", { cx: W - 180, cy: 36 + 20 * k, r: 5, fill: shades[k % shades.length] }));
    svg.append(shape("text", { x: W - 168, y: 41 + 20 * k, "font-size": 14 }, team));
  });
  return svg;
}
