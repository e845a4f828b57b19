// A program in time: a row for each process, a stripe for each SIMD lane.

const LANE = 15, ROW = 26, LEFT = 120, WIDTH = 1100, RIGHT = 80;

/** Return a step of an axis: 1, 2 or 5 times a power of ten, some eight steps to its end. */
function stepOf(end) {
  const rough = end / 8, power = 10 ** Math.floor(Math.log10(rough));
  return power * [1, 2, 5, 10].find((k) => k * power >= rough);
}

/** Draw an axis of time under a chart. */
function timeAxis(svg, end, scale, y) {
  svg.append(shape("line", { class: "rule", x1: LEFT, x2: LEFT + end * scale, y1: y, y2: y }));
  const step = stepOf(end), digits = Math.max(0, -Math.floor(Math.log10(step)));
  for (let k = 0; k * step <= end * (1 + 1e-9); k += 1) {
    const x = LEFT + k * step * scale;
    svg.append(shape("line", { class: "rule", x1: x, x2: x, y1: y, y2: y + 4 }));
    svg.append(shape("text", { class: "muted", x, y: y + 17, "font-size": 11, "text-anchor": "middle" }, (k * step).toFixed(digits)));
  }
  svg.append(shape("text", { class: "muted", x: LEFT + end * scale + 22, y: y + 17, "font-size": 11 }, "µs"));
}

/** Return a name that fits a width, or nothing. */
const fitting = (name, width) => (name.length * 6.2 <= width ? name : "");

/** Draw one bar, or one for each lane. */
function bars(svg, each, x, width, y, height, [fill, ink]) {
  const lanes = each.lanes.length > 1 ? each.lanes : [each.name];
  const shown = `${each.name || each.what}: ${each.start.toFixed(3)} to ${each.end.toFixed(3)} µs`;
  lanes.forEach((name, k) => {
    const top = y + (k * height) / lanes.length, tall = height / lanes.length;
    const kind = ["call", "wait"].includes(each.what) ? each.what : ["send", "receive"].includes(each.what) ? "message" : "bar";
    const box = shape("rect", { class: kind, x, y: top, width, height: tall, ...(kind === "bar" ? { fill } : {}) });
    box.append(shape("title", {}, lanes.length > 1 ? `${shown}; lane ${k}: ${name}` : shown));
    svg.append(box);
    if (kind !== "bar") return;
    if (each.what === "kinematics") svg.append(shape("rect", { class: "stripe", x: x + 0.5, y: top + 1, width: Math.max(width - 1, 0), height: tall * 0.3, "pointer-events": "none" }));
    if (["disassembly", "slaved"].includes(each.what)) svg.append(shape("rect", { class: "stripe", x: x + 0.5, y: top + tall - 4, width: Math.max(width - 1, 0), height: 2.5, "pointer-events": "none" }));
    const short = fitting(name.replace(/^[a-z ]+? (?=\S+$)/, ""), width - 6);
    if (short && each.what === "assembly") {
      svg.append(shape("text", { x: x + width / 2, y: top + tall / 2 + 4, "font-size": 11, "text-anchor": "middle", style: `fill: ${ink}`, "pointer-events": "none" }, short));
    }
  });
}

/** Return a chart of a timeline, on the scale of the longest one. */
function timelineChart(line, processes, colours, longest) {
  const most = Array.from({ length: processes }, (_, p) => Math.max(1, ...line.intervals.filter((i) => i.process === p).map((i) => i.lanes.length)));
  const heights = most.map((lanes) => Math.max(ROW, lanes * LANE));
  const tops = heights.map((_, p) => 8 + heights.slice(0, p).reduce((a, b) => a + b + 8, 0));
  const bottom = tops[processes - 1] + heights[processes - 1] + 8, scale = (WIDTH - LEFT - RIGHT) / longest;
  const longer = line.source === "measured" ? " (longer while it is traced)" : "";
  const words = `${line.source} time of an evaluation${longer}: ${line.makespan.toFixed(3)} µs on ${processes} process${processes > 1 ? "es" : ""}`;
  const svg = shape("svg", { viewBox: `0 0 ${WIDTH} ${bottom + 26}`, role: "img", "aria-label": words });
  heights.forEach((height, p) => {
    svg.append(shape("rect", { x: 8, y: tops[p] + height / 2 - 6, width: 12, height: 12, fill: colours[p][0] }));
    svg.append(shape("text", { x: 26, y: tops[p] + height / 2 + 4, "font-size": 12 }, `process ${p}`));
    const share = `${Math.round((100 * line.busy[p]) / line.makespan)} % busy`;
    svg.append(shape("text", { class: "muted", x: WIDTH - 8, y: tops[p] + height / 2 + 4, "font-size": 11, "text-anchor": "end" }, share));
  });
  line.intervals.forEach((each) => {
    bars(svg, each, LEFT + each.start * scale, Math.max((each.end - each.start) * scale, 0.2), tops[each.process], heights[each.process], colours[each.process]);
  });
  line.exchanges.forEach((each) => {
    const middle = (p) => tops[p] + heights[p] / 2;
    const x2 = LEFT + each.used * scale, y2 = middle(each.to);
    svg.append(shape("line", { class: "sent", x1: LEFT + each.sent * scale, y1: middle(each.from), x2, y2 }));
    svg.append(shape("circle", { class: "message", cx: x2, cy: y2, r: 2.5 }));
  });
  timeAxis(svg, line.makespan, scale, bottom);
  return [svg, words];
}
