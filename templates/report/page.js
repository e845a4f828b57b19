// The document of the report, put into the page.

const data = JSON.parse(document.getElementById("data").textContent);
const byId = (id) => document.getElementById(id);

/** Return a new element with text and attributes. */
function element(tag, text, attributes = {}) {
  const made = document.createElement(tag);
  if (text !== undefined) made.textContent = text;
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

/** Fill a table: the first row are heads. */
function fillTable(table, heads, rows) {
  const head = table.appendChild(element("thead")).appendChild(element("tr"));
  heads.forEach((text) => head.append(element("th", text, { scope: "col" })));
  const body = table.appendChild(element("tbody"));
  rows.forEach((cells) => {
    const row = body.appendChild(element("tr"));
    cells.forEach((text, k) => row.append(k === 0 ? element("th", text, { scope: "row" }) : element("td", text)));
  });
}

/** Return a slider with its label and value; tell(value) is called as it moves. */
function slider(id, name, range, unit, tell) {
  const box = element("div", undefined, { class: "slider" });
  const input = element("input", undefined, { type: "range", id, min: -range, max: range, step: range / 200, value: 0 });
  const output = element("output", `0.00 ${unit}`, { for: id });
  input.addEventListener("input", () => {
    const value = (Math.round((200 * Number(input.value)) / range) * range) / 200; // zero is zero
    output.textContent = `${value.toFixed(2)} ${unit}`;
    tell(value);
  });
  box.append(element("label", name, { for: id }), output, input);
  return [box, input];
}

/** Set a slider, as a hand would. */
function slide(input, value) {
  input.value = value;
  input.dispatchEvent(new Event("input"));
}

function showRobot() {
  const { robot, program } = data, svg = byId("skeleton");
  const draw = skeleton(svg, robot, program.colours), pose = restingPose(robot), view = [0.7, 0.35];
  const again = () => {
    draw(pose, view[0], view[1]);
    if (robot.loops.length === 0) return;
    const links = placed(robot, pose), open = Math.max(...robot.loops.map((loop) => endsOf(loop, links)[2]));
    byId("loops").textContent = `Rings: loops. ${open < 5e-4 ? "In this pose they are closed." : `In this pose they are open by up to ${open.toPrecision(2)} m.`} Sliders do not keep them closed.`;
  };
  const turns = [["turn", 0, Math.PI], ["tilt", 1, Math.PI / 2]].map(([name, k, range]) => {
    const [box, input] = slider(`view-${k}`, name, range, "rad", (value) => { view[k] = value; again(); });
    byId("view").append(box);
    slide(input, view[k]);
    return input;
  });
  const inputs = [];
  robot.joints.forEach((joint, j) => {
    if (joint.mimic !== null) return;
    SLIDERS[joint.kind].forEach(([part, range, unit], k) => {
      const [box, input] = slider(`joint-${j}-${k}`, part ? `${joint.name}, ${part}` : joint.name, range, unit, (value) => { pose[j][k] = value; again(); });
      byId("joints").append(box);
      inputs.push([input, j, k]);
    });
  });
  const home = () => {
    inputs.forEach(([input, j, k]) => {
      slide(input, robot.rest[j][k]);
      pose[j][k] = robot.rest[j][k]; // sliders go in steps
    });
    again();
  };
  byId("home").textContent = robot.loops.length ? "Close all loops" : "All joints to zero";
  byId("home").addEventListener("click", home);
  svg.addEventListener("pointermove", (event) => {
    if (!event.buttons) return;
    slide(turns[0], Math.max(-Math.PI, Math.min(Math.PI, view[0] + event.movementX / 150)));
    slide(turns[1], Math.max(-Math.PI / 2, Math.min(Math.PI / 2, view[1] + event.movementY / 150)));
  });
  home();
}

/** Return the joints on a link as a list; it is nested where the robot branches. */
function treeFrom(link, children, item) {
  const list = element("ul");
  let on = children[link];
  for (; on.length === 1; on = children[on[0]]) list.append(item(on[0]));
  on.forEach((child) => {
    const own = list.appendChild(item(child));
    if (children[child].length) own.append(treeFrom(child, children, item));
  });
  return list;
}

function showTree() {
  const { robot, program } = data, several = program.colours.length > 1;
  byId("tree").append(treeFrom(0, childrenOf(robot), (child) => {
    const joint = robot.joints[child - 1], { name, mass } = robot.links[child];
    const item = element("li"), mark = element("span", undefined, { class: "mark", "aria-hidden": "true" });
    mark.style.background = program.colours[joint.owner][0];
    const process = several ? `, process ${joint.owner}` : "";
    item.append(mark, element("strong", joint.name), ` ${joint.kind}: ${robot.links[joint.parent].name} to ${name}, ${Number(mass.toPrecision(4))} kg${process}`);
    return item;
  }));
}

function showProgram() {
  const { program } = data, processes = program.colours.length;
  byId("program-summary").textContent = `${program.title}; form ${program.form}, shape ${program.shape}, ${program.scalar}`;
  const legend = [["call", "call"], ["kinematics", "kinematics"], ["assembly", "assembly: inwards"], ["disassembly", "disassembly: outwards"], ["send", "message"], ["wait", "waiting"]];
  legend.forEach(([what, words]) => {
    const sample = shape("svg", { viewBox: "0 0 28 16", "aria-hidden": "true" });
    bars(sample, { what, name: "", lanes: [], start: 0, end: 0 }, 0, 28, 0, 16, program.colours[0]);
    sample.querySelectorAll("title").forEach((each) => each.remove());
    const item = element("li");
    item.append(sample, words);
    byId("legend").append(item);
  });
  const longest = Math.max(...program.timelines.map((line) => line.makespan), 1e-9);
  program.timelines.forEach((line) => {
    const [svg, words] = timelineChart(line, processes, program.colours, longest);
    const figure = element("figure");
    figure.append(element("h3", words[0].toUpperCase() + words.slice(1)), wide(svg, words));
    const table = element("table"), details = element("details");
    fillTable(table, ["operation", "process", "from, µs", "to, µs", "lanes"], line.intervals.map((i) => [i.name ? `${i.name} (${i.what})` : i.what, i.process, i.start.toFixed(3), i.end.toFixed(3), i.lanes.length || 1]));
    details.append(element("summary", "The same as a table"), table);
    byId("timelines").append(figure, details);
  });
  if (program.untimed !== null) byId("timelines").append(element("p", program.untimed, { class: "note" }));
  byId("legend").hidden = program.timelines.length === 0;
}

/** Return a wide picture in a box that scrolls where the page is narrow. */
function wide(svg, words) {
  const box = element("div", undefined, { class: "wide", tabindex: 0, role: "region", "aria-label": words });
  box.append(svg);
  return box;
}

/** Return a note that a part is missing, and the command that adds it. */
function missing(words, ...commands) {
  const note = element("p", `${words} `, { class: "note" });
  commands.forEach((name, k) => note.append(k ? ", then " : "", element("code", data.commands[name] ?? "")));
  return note;
}

function showAccuracy() {
  const { accuracy } = data, place = byId("accuracy-d");
  if (accuracy === null) { place.append(missing("Not measured here. To measure errors, and times beside the predicted ones:", "run")); return; }
  if (accuracy.missing) { place.append(element("p", accuracy.missing, { class: "note" })); return; }
  const [svg, words] = accuracyChart(accuracy), table = element("table"), details = element("details");
  const shown = (x) => (x === null || x === undefined ? "–" : x.toExponential(1));
  fillTable(table, ["state", "error", "certified bound"], accuracy.errors.map((error, s) => [s + 1, shown(error), shown(accuracy.bounds[s])]));
  details.append(element("summary", "The same as a table"), table);
  place.append(element("p", words), wide(svg, words), details);
}

function showRest() {
  const { robot, chart, scene } = data;
  byId("summary").textContent = `${robot.joints.length} joints, ${robot.nv} degrees of freedom, ${robot.floating ? "floating" : "fixed"} base, ${Number(robot.mass.toPrecision(6))} kg, gravity ${robot.gravity.join(" ")} m/s²`;
  const shown = (value) => (value === null ? "–" : typeof value === "number" ? String(Number(value.toPrecision(3))) : value);
  fillTable(byId("figures-t"), ["", "predicted", "measured", ""], data.figures.map((row) => [row.what, shown(row.predicted), shown(row.measured), row.unit]));
  if (chart === null) {
    byId("chart-d").append(missing("No record of variants was given. To measure them (minutes), and to show them here:", "chart", "record"));
    byId("chart").querySelector(".command").remove();
  } else {
    const table = element("table"), details = element("details");
    fillTable(table, ["variant", "µs", "largest error", "no other is better"], chart.points.map((p) => [p.label, p.time.toPrecision(3), p.error.toExponential(1), p.front ? "yes" : ""]));
    details.append(element("summary", "The same as a table"), table);
    byId("chart-d").append(element("p", `${chart.model}, errors over ${chart.states} states, on ${chart.machine}; filled and joined by a line: no other variant of adagen is faster and more accurate, one state at a time. Wheel and drag to zoom and move.`, { class: "note" }), errorChart(chart), details);
  }
  if (scene !== null) scene.lines.forEach((line) => byId("scene-l").append(element("li", line)));
  data.remarks.forEach((line) => byId("remarks-l").append(element("li", line)));
  byId("scene").hidden = scene === null;
  byId("remarks").hidden = data.remarks.length === 0;
}

function showCommands() {
  document.querySelectorAll("[data-command]").forEach((place) => {
    const command = data.commands[place.dataset.command];
    if (command === undefined) { place.hidden = true; return; }
    place.append("made by ", element("code", command));
  });
  document.querySelectorAll("main section").forEach((section) => {
    if (!section.hidden) byId("parts").append(element("a", section.querySelector("h2").textContent, { href: `#${section.id}` }));
  });
}

showRobot();
showTree();
showProgram();
showRest();
showAccuracy();
showCommands();
