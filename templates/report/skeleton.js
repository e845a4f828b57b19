// The robot as joints and links: where they are in a pose, and how that is seen.

const add = (a, b) => a.map((x, i) => x + b[i]);
const times = (m, v) => m.map((row) => row[0] * v[0] + row[1] * v[1] + row[2] * v[2]);
const product = (a, b) => a.map((row) => [0, 1, 2].map((k) => row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]));
const IDENTITY = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];

/** Return the rotation about a unit axis (Rodrigues). */
function rotationAbout(axis, angle) {
  const [x, y, z] = axis, s = Math.sin(angle), c = Math.cos(angle), t = 1 - c;
  return [
    [t * x * x + c, t * x * y - s * z, t * x * z + s * y],
    [t * x * y + s * z, t * y * y + c, t * y * z - s * x],
    [t * x * z - s * y, t * y * z + s * x, t * z * z + c],
  ];
}

/** Return the rotation that a rotation vector stands for. */
function rotationOf(vector) {
  const angle = Math.hypot(...vector);
  return angle === 0 ? IDENTITY : rotationAbout(vector.map((x) => x / angle), angle);
}

/** Sliders of a joint kind: what each is called, its range, its unit. */
const SLIDERS = {
  revolute: [["", Math.PI, "rad"]],
  prismatic: [["", 1, "m"]],
  spherical: [["x", Math.PI, "rad"], ["y", Math.PI, "rad"], ["z", Math.PI, "rad"]],
  planar: [["x", 1, "m"], ["y", 1, "m"], ["turn", Math.PI, "rad"]],
  floating: [["x", 1, "m"], ["y", 1, "m"], ["z", 1, "m"], ["turn x", Math.PI, "rad"], ["turn y", Math.PI, "rad"], ["turn z", Math.PI, "rad"]],
};

/** Return rotation and shift of a joint's child in the joint's frame. */
function motion(joint, q) {
  const still = [0, 0, 0], along = (vector, length) => vector.map((x) => x * length);
  switch (joint.kind) {
    case "revolute": return [rotationAbout(joint.axis, q[0]), still];
    case "prismatic": return [IDENTITY, along(joint.axis, q[0])];
    case "spherical": return [rotationOf(q), still];
    case "planar": {
      const [one, two] = joint.across;
      return [rotationAbout(joint.axis, q[2]), add(along(one, q[0]), along(two, q[1]))];
    }
    default: return [rotationOf(q.slice(3)), q.slice(0, 3)];
  }
}

/** Return where each link is in a pose (q of each joint): its rotation and origin in the ground. */
function placed(robot, pose) {
  const links = [{ rotation: IDENTITY, origin: [0, 0, 0] }];
  robot.joints.forEach((joint, j) => {
    const parent = links[joint.parent];
    const q = joint.mimic === null ? pose[j] : [joint.mimic[1] * pose[joint.mimic[0]][0] + joint.mimic[2]];
    const frame = product(parent.rotation, joint.rotation);
    const origin = add(parent.origin, times(parent.rotation, joint.translation));
    const [turn, shift] = motion(joint, q);
    links.push({
      rotation: product(frame, turn),
      origin: add(origin, times(frame, shift)),
      axis: times(frame, joint.axis),
      at: origin,
    });
  });
  return links;
}

const SVG = "http://www.w3.org/2000/svg";

/** Return a new SVG element with attributes and, if given, text. */
function shape(tag, attributes, text) {
  const element = document.createElementNS(SVG, tag);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Return the links that hang on each link by a joint. */
function childrenOf(robot) {
  const found = robot.links.map(() => []);
  robot.joints.forEach((joint, j) => found[joint.parent].push(j + 1));
  return found;
}

/** Return the strokes of a robot: of what class, from where to where. */
function strokes(robot, children, links) {
  const found = [];
  links.forEach((link, k) => {
    for (const child of children[k]) {
      found.push(["bone", link.origin, links[child].at]);
      if (links[child].at.some((x, i) => x !== links[child].origin[i])) found.push([robot.joints[child - 1].kind === "floating" ? "ground" : "bone", links[child].at, links[child].origin]);
    }
    const { mass, com, fixed } = robot.links[k];
    const point = (at) => add(link.origin, times(link.rotation, at));
    if (k > 0 && mass > 0) found.push(["mass", link.origin, point(com)]);
    if (k > 0 && children[k].length === 0) fixed.forEach((frame) => found.push(["mass", link.origin, point(frame.at)]));
  });
  return found;
}

/** Return both ends of a loop in the ground, and how far the loop is open along the axes it holds. */
function endsOf(loop, links) {
  const [one, two] = loop.ends.map((end) => add(links[end.link].origin, times(links[end.link].rotation, end.at)));
  const axes = product(links[loop.ends[0].link].rotation, loop.rotation), apart = two.map((x, i) => x - one[i]);
  const along = [0, 1, 2].map((k) => axes[0][k] * apart[0] + axes[1][k] * apart[1] + axes[2][k] * apart[2]);
  return [one, two, Math.hypot(...loop.held.map((k) => along[k]))];
}

/** Return the strokes of loops: from links to their ends, and dashes between the ends. */
function loopStrokes(robot, links) {
  return robot.loops.flatMap((loop) => {
    const [one, two] = endsOf(loop, links);
    const arms = loop.ends.map((end, k) => ["bone", links[end.link].origin, [one, two][k], end.link]);
    return [...arms.filter(([, , , link]) => link > 0), ["loop", one, two]];
  });
}

/** Draw the robot and return what draws it again in another pose or view. */
function skeleton(svg, robot, colours) {
  const W = 800, H = 600;
  svg.setAttribute("viewBox", `0 0 ${W} ${H}`);
  const children = childrenOf(robot), rest = placed(robot, restingPose(robot));
  const points = [...strokes(robot, children, rest), ...loopStrokes(robot, rest)].flatMap(([, a, b]) => [a, b]).concat([[0, 0, 0]]);
  const bounds = [0, 1, 2].map((k) => points.reduce(([low, high], p) => [Math.min(low, p[k]), Math.max(high, p[k])], [Infinity, -Infinity]));
  const centre = bounds.map(([low, high]) => (low + high) / 2);
  const size = Math.hypot(...bounds.map(([low, high]) => high - low)) || 1;
  const scale = (0.92 * Math.min(W, H)) / size;
  return (pose, yaw, pitch) => {
    const turned = product(rotationAbout([1, 0, 0], pitch - Math.PI / 2), rotationAbout([0, 0, 1], yaw));
    const seen = (p) => {
      const [x, y] = times(turned, p.map((v, i) => v - centre[i]));
      return [W / 2 + scale * x, H / 2 - scale * y];
    };
    const line = (kind, a, b) => {
      const [x1, y1] = seen(a), [x2, y2] = seen(b);
      return shape("line", { class: kind, x1, y1, x2, y2 });
    };
    const links = placed(robot, pose), g = 0.3 * size;
    const drawn = [line("ground", [-g, 0, 0], [g, 0, 0]), line("ground", [0, -g, 0], [0, g, 0])];
    [...strokes(robot, children, links), ...loopStrokes(robot, links)].forEach(([kind, a, b]) => drawn.push(line(kind, a, b)));
    robot.loops.forEach((loop) => {
      const [cx, cy] = seen(endsOf(loop, links)[0]), ring = shape("circle", { class: "ring", cx, cy, r: 7 });
      ring.append(shape("title", {}, `loop ${loop.name}: ${loop.kind}`));
      drawn.push(ring);
    });
    robot.joints.forEach((joint, j) => {
      const { at, axis } = links[j + 1], [cx, cy] = seen(at), half = axis.map((x) => 0.025 * size * x);
      if (["revolute", "prismatic"].includes(joint.kind)) drawn.push(line("axis", add(at, half.map((x) => -x)), add(at, half)));
      const disc = shape("circle", { class: "disc", cx, cy, r: joint.kind === "spherical" ? 7 : 5, fill: colours[joint.owner][0] });
      disc.append(shape("title", {}, `${joint.name}: ${joint.kind}, process ${joint.owner}`));
      drawn.push(disc);
    });
    svg.replaceChildren(...drawn);
  };
}

/** Return q of each joint as the page begins: zero, or near to it with loops closed. */
function restingPose(robot) {
  return robot.rest.map((q) => [...q]);
}
