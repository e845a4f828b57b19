// Error against time of variants, both on logarithmic scales: the front, what a budget picks, zoom.

const CHART = { width: 1000, height: 520, left: 70, right: 970, top: 20, bottom: 470 };
const SHADES = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#808080"];

/** Return a number in few letters, as a label of an axis. */
function short(value) {
  const text = value.toPrecision(2);
  return value >= 0.01 && value < 1000 ? String(Number(text)) : Number(text).toExponential().replace("e+", "e");
}

/** Return the values at which an axis from 10^low to 10^high has labels. */
function ticksOf(low, high) {
  const step = Math.max(1, Math.ceil((high - low) / 12)), steps = high - low < 2.5 ? [1, 2, 5] : [1];
  const ticks = [];
  for (let k = Math.floor(low); k <= high; k += step) steps.forEach((n) => ticks.push(n * 10 ** k));
  return ticks.filter((tick) => Math.log10(tick) >= low - 1e-9 && Math.log10(tick) <= high + 1e-9);
}

/** Return the part of the plane, in powers of ten, that holds all points: [low, high] of x and y. */
function wholeView(points) {
  return [points.map((p) => p.time), points.map((p) => p.error)].map((values) => {
    const low = Math.log10(Math.min(...values)), high = Math.log10(Math.max(...values));
    const margin = Math.max(0.06 * (high - low), 0.1);
    return [low - margin, high + margin];
  });
}

/** Return what a budget picks: the fastest below an error, or else the most accurate in a time. */
function picked(points, error, time) {
  const kept = points.filter((p) => p.emitted && p.error < error && p.time < time);
  const cost = (p) => (error < Infinity ? p.time : p.error);
  return kept.reduce((best, p) => (best === null || cost(p) < cost(best) ? p : best), null);
}

/** Return where labels of points stand without lying on each other, on a point or beyond the chart. */
function labels(named, points, x, y, [left, right, top, bottom]) {
  const taken = points.map((p) => [x(p.time) - 7, y(p.error) - 7, x(p.time) + 7, y(p.error) + 7]), found = [];
  const free = ([a, b, c, d]) => a >= left && c <= right && b >= top && d <= bottom && taken.every(([e, f, g, h]) => c <= e || a >= g || d <= f || b >= h);
  named.forEach((p) => {
    const width = 7.2 * p.label.length, u = x(p.time), v = y(p.error);
    const places = [[u + 12, v - 6], [u - 12 - width, v - 6], [u + 12, v + 18], [u - 12 - width, v + 18], [u + 12, v - 22], [u + 12, v + 34]];
    const place = places.find(([a, b]) => free([a, b - 12, a + width, b + 4]));
    if (place === undefined) return;
    taken.push([place[0], place[1] - 12, place[0] + width, place[1] + 4]);
    found.push([p, { x: place[0], y: place[1] }]);
  });
  return found;
}

/** Draw axes, front and points of a view into an svg; say(point) is called as one is pointed at. */
function drawChart(svg, points, view, pick, say) {
  const { width, left, right, top, bottom } = CHART, [[x0, x1], [y0, y1]] = view;
  const x = (time) => left + ((Math.log10(time) - x0) / (x1 - x0)) * (right - left);
  const y = (error) => bottom - ((Math.log10(error) - y0) / (y1 - y0)) * (bottom - top);
  const inside = (p) => x(p.time) >= left && x(p.time) <= right && y(p.error) >= top && y(p.error) <= bottom;
  svg.replaceChildren();
  ticksOf(x0, x1).forEach((tick) => {
    svg.append(shape("line", { class: "rule", x1: x(tick), x2: x(tick), y1: top, y2: bottom }));
    svg.append(shape("text", { class: "muted", x: x(tick), y: bottom + 18, "font-size": 13, "text-anchor": "middle" }, short(tick)));
  });
  ticksOf(y0, y1).forEach((tick) => {
    svg.append(shape("line", { class: "rule", x1: left, x2: right, y1: y(tick), y2: y(tick) }));
    svg.append(shape("text", { class: "muted", x: left - 8, y: y(tick) + 4, "font-size": 13, "text-anchor": "end" }, short(tick)));
  });
  svg.append(shape("text", { x: width / 2, y: bottom + 42, "font-size": 14, "text-anchor": "middle" }, "time of an evaluation, µs"));
  svg.append(shape("text", { x: left, y: 14, "font-size": 14 }, "largest error"));
  const teams = [...new Set(points.map((p) => p.team))], shade = (p) => SHADES[teams.indexOf(p.team) % SHADES.length];
  const front = points.filter((p) => p.front && inside(p)).sort((a, b) => a.time - b.time);
  const stairs = front.map((p, k) => (k === 0 ? `M${x(p.time)} ${y(p.error)}` : `H${x(p.time)}V${y(p.error)}`)).join("");
  if (front.length > 1) svg.append(shape("path", { class: "front", d: stairs, fill: "none", stroke: shade(front[0]), "stroke-width": 1.5 }));
  points.filter(inside).forEach((p) => {
    const dot = shape("circle", { cx: x(p.time), cy: y(p.error), r: p.front ? 7 : 5, fill: p.front ? shade(p) : "transparent", stroke: shade(p), "stroke-width": 2 });
    dot.append(shape("title", {}, pointText(p)));
    dot.addEventListener("pointerenter", () => say(p));
    svg.append(dot);
  });
  labels(front, points.filter(inside), x, y, [left, right, top, bottom]).forEach(([p, at]) => svg.append(shape("text", { class: "label", ...at, "font-size": 13, "pointer-events": "none" }, p.label)));
  if (pick !== null && inside(pick)) svg.append(shape("ellipse", { class: "pick", cx: x(pick.time), cy: y(pick.error), rx: 12, ry: 12 }));
  teams.forEach((team, k) => {
    const at = right - 110 * (teams.length - k); // in the line above the points
    svg.append(shape("circle", { cx: at, cy: 9, r: 5, fill: SHADES[k % SHADES.length] }));
    svg.append(shape("text", { x: at + 12, y: 14, "font-size": 14 }, team));
  });
}

/** Return a point in words. */
function pointText(p) {
  return `${p.label}: ${p.time.toPrecision(3)} µs, error ${p.error.toExponential(1)}`;
}

/** Return a slider over powers of ten; change(limit) gets Infinity at its right end. */
function limitSlider(id, name, [low, high], start, unit, change) {
  const box = element("div", undefined, { class: "slider" });
  const input = element("input", undefined, { type: "range", id, min: 0, max: 100, step: 1 });
  const output = element("output", "", { for: id });
  input.addEventListener("input", () => {
    const limit = input.value === "100" ? Infinity : Number((10 ** (low + (high - low) * (input.value / 100))).toPrecision(2));
    output.textContent = limit === Infinity ? "any" : `< ${short(limit)}${unit}`;
    change(limit);
  });
  input.value = start;
  box.append(element("label", name, { for: id }), output, input);
  return [box, input];
}

/** Return the chart with its controls: points have a time (µs) and an error. */
function errorChart(chart) {
  const points = chart.points.filter((p) => p.time > 0 && p.error > 0), box = element("div");
  const svg = shape("svg", { viewBox: `0 0 ${CHART.width} ${CHART.height}`, role: "img", "aria-label": `error against time of ${points.length} variants; the table has them all` });
  box.append(wide(svg, "error against time"));
  if (points.length === 0) return box;
  const whole = wholeView(points), figures = element("p", "Point at a variant to see its figures.", { class: "note", "aria-live": "polite" });
  const verdict = element("p", "", { id: "budget", "aria-live": "polite" });
  let view = whole, error = Infinity, time = Infinity;
  let pick = null;
  const draw = () => {
    const free = error === Infinity && time === Infinity;
    pick = free ? null : picked(points, error, time);
    drawChart(svg, points, view, pick, (p) => { figures.textContent = pointText(p); });
    verdict.textContent = free ? "No budget." : pick === null ? "Nothing keeps this budget." : `This budget picks (ringed) ${pointText(pick)}.`;
  };
  const zoom = (factor, at) => {
    view = view.map(([low, high], k) => {
      const centre = low + at[k] * (high - low);
      return [centre + (low - centre) * factor, centre + (high - centre) * factor];
    });
    draw();
  };
  const zoomAtPick = (factor) => { // what is ringed, or else the front, stays where it is
    const fixed = pick ?? points.find((p) => p.front) ?? points[0], at = [fixed.time, fixed.error].map(Math.log10);
    zoom(factor, view.map(([low, high], k) => Math.min(1, Math.max(0, (at[k] - low) / (high - low)))));
  };
  svg.addEventListener("wheel", (event) => {
    event.preventDefault();
    const area = svg.getBoundingClientRect(), scale = CHART.width / area.width;
    const u = (event.clientX - area.left) * scale, v = (event.clientY - area.top) * scale;
    zoom(event.deltaY > 0 ? 1.25 : 0.8, [(u - CHART.left) / (CHART.right - CHART.left), (CHART.bottom - v) / (CHART.bottom - CHART.top)]);
  }, { passive: false });
  let from = null;
  svg.addEventListener("pointerdown", (event) => { from = [event.clientX, event.clientY]; svg.setPointerCapture(event.pointerId); });
  svg.addEventListener("pointerup", () => { from = null; });
  svg.addEventListener("pointermove", (event) => {
    if (from === null) return;
    const scale = CHART.width / svg.getBoundingClientRect().width;
    const part = [(scale * (from[0] - event.clientX)) / (CHART.right - CHART.left), (scale * (event.clientY - from[1])) / (CHART.bottom - CHART.top)];
    view = view.map(([low, high], k) => [low + part[k] * (high - low), high + part[k] * (high - low)]);
    from = [event.clientX, event.clientY];
    draw();
  });
  const controls = element("div", undefined, { class: "controls" });
  [["Zoom in", () => zoomAtPick(0.6)], ["Zoom out", () => zoomAtPick(1 / 0.6)], ["Whole chart", () => { view = whole; draw(); }]].forEach(([name, act]) => {
    const button = controls.appendChild(element("button", name, { type: "button" }));
    button.addEventListener("click", act);
  });
  const [errorBox, errorInput] = limitSlider("budget-error", "budget: error", whole[1], 100, "", (limit) => { error = limit; draw(); });
  const [timeBox, timeInput] = limitSlider("budget-time", "budget: time", whole[0], 100, " µs", (limit) => { time = limit; draw(); });
  const start = Math.round((100 * (-10 - whole[1][0])) / (whole[1][1] - whole[1][0]));
  if (start > 0 && start < 100) errorInput.value = start;
  [errorInput, timeInput].forEach((input) => input.dispatchEvent(new Event("input")));
  controls.append(errorBox, timeBox);
  box.append(figures, controls, verdict);
  return box;
}
