// Errors of answers, state by state, beside what bounds them: certified bounds, or the predicted error.

const ERRORS = { width: 1000, height: 300, left: 70, right: 970, top: 30, bottom: 255 };

/** Return the chart of errors and bounds, and what it shows in words. */
function accuracyChart({ errors, bounds, predicted, digits }) {
  const { width, height, left, right, top, bottom } = ERRORS;
  const known = bounds.filter((bound) => bound !== null), least = 1e-17; // below it lies an error of zero
  const all = [...errors, ...known, ...(predicted === null ? [] : [predicted])].map((e) => Math.log10(Math.max(e, least)));
  const low = Math.floor(Math.min(...all) - 0.2), high = Math.ceil(Math.max(...all) + 0.2);
  const y = (e) => bottom - ((Math.max(Math.log10(e), low) - low) / (high - low)) * (bottom - top);
  const x = (s) => left + ((s + 0.5) / errors.length) * (right - left);
  const worst = Math.max(...errors), parts = [`Largest error of ${errors.length} random states: ${worst.toExponential(1)}, in the energy norm, beside accelerations that are certain to ${digits} digits.`];
  if (known.length) {
    const over = errors.filter((error, s) => bounds[s] !== null && error > bounds[s]).length;
    parts.push(`Largest certified bound: ${Math.max(...known).toExponential(1)}; ${over === 0 ? "no error exceeds its bound" : `${over} exceed their bound`}.`);
  }
  if (predicted !== null) parts.push(`Predicted error: ${predicted.toExponential(1)}.`);
  const svg = shape("svg", { viewBox: `0 0 ${width} ${height}`, role: "img", "aria-label": parts.join(" ") });
  ticksOf(low, high).forEach((tick) => {
    svg.append(shape("line", { class: "rule", x1: left, x2: right, y1: y(tick), y2: y(tick) }));
    svg.append(shape("text", { class: "muted", x: left - 8, y: y(tick) + 4, "font-size": 13, "text-anchor": "end" }, short(tick)));
  });
  if (predicted !== null) svg.append(shape("line", { class: "predicted", x1: left, x2: right, y1: y(predicted), y2: y(predicted) }));
  errors.forEach((error, s) => {
    const bound = bounds[s] ?? null;
    if (bound !== null) {
      svg.append(shape("line", { class: "reach", x1: x(s), x2: x(s), y1: y(error), y2: y(bound) }));
      svg.append(shape("line", { class: "bound", x1: x(s) - 12, x2: x(s) + 12, y1: y(bound), y2: y(bound) }));
    }
    const dot = shape("circle", { class: "error", cx: x(s), cy: y(error), r: 5 });
    dot.append(shape("title", {}, `state ${s + 1}: error ${error.toExponential(1)}${bound === null ? "" : `, bound ${bound.toExponential(1)}`}`));
    svg.append(dot, shape("text", { class: "muted", x: x(s), y: bottom + 18, "font-size": 13, "text-anchor": "middle" }, s + 1));
  });
  svg.append(shape("text", { x: width / 2, y: bottom + 38, "font-size": 14, "text-anchor": "middle" }, "random state"));
  const legend = [["error", "error"], ...(known.length ? [["bound", "certified bound"]] : []), ...(predicted === null ? [] : [["predicted", "predicted error"]])];
  legend.forEach(([kind, words], k) => {
    const at = left + 170 * k;
    svg.append(kind === "error" ? shape("circle", { class: kind, cx: at + 10, cy: 13, r: 5 }) : shape("line", { class: kind, x1: at, x2: at + 22, y1: 13, y2: 13 }));
    svg.append(shape("text", { x: at + 28, y: 18, "font-size": 14 }, words));
  });
  return [svg, parts.join(" ")];
}
