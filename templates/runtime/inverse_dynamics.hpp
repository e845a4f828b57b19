// An independent check: inverse dynamics by Newton's and Euler's equations, body by body, in
// double. It shares the model's constants with the solver, and no arithmetic.
namespace check {

using Vec = std::array<double, 3>;
using Mat = std::array<Vec, 3>;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[i][0] * a[0] + m[i][1] * a[1] + m[i][2] * a[2];
  return result;
}
Vec transposed_times(const Mat& m, const Vec& a) {
  Vec result{};
  for (int i = 0; i < 3; ++i) result[i] = m[0][i] * a[0] + m[1][i] * a[1] + m[2][i] * a[2];
  return result;
}
Mat times(const Mat& a, const Mat& b) {
  Mat result{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k) result[i][j] += a[i][k] * b[k][j];
  return result;
}
Vec vec3(const Number* x) { return {double(x[0]), double(x[1]), double(x[2])}; }
Mat mat3(const Number* x) { return {vec3(x), vec3(x + 3), vec3(x + 6)}; }

struct Body {
  Mat turn;   // child to parent coordinates
  Vec shift;  // child origin in parent coordinates
  Vec w, dw;  // angular velocity and acceleration, in the body's frame
  Vec a;      // acceleration of its origin minus gravity, in the body's frame
  Vec f, n;   // force on it through its joint, and moment about its origin
};

// Rotation and origin of the child frame in the joint frame.
void displace(const Joint& joint, const Number* q, Mat& turn, Vec& shift) {
  turn = {Vec{1, 0, 0}, Vec{0, 1, 0}, Vec{0, 0, 1}};
  shift = {};
  const auto about_z = [&turn](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    turn = {Vec{c, -s, 0}, Vec{s, c, 0}, Vec{0, 0, 1}};
  };
  const auto orient = [&turn](const Number* p) {
    double x = double(p[0]), y = double(p[1]), z = double(p[2]), w = double(p[3]);
    const double length = std::sqrt(x * x + y * y + z * z + w * w);
    x /= length, y /= length, z /= length, w /= length;
    turn = {Vec{1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)},
            Vec{2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)},
            Vec{2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)}};
  };
  switch (joint.kind) {
    case JointKind::kRevolute:
      about_z(double(q[0]));
      break;
    case JointKind::kPrismatic:
      shift[2] = double(q[0]);
      break;
    case JointKind::kSpherical:
      orient(q);
      break;
    case JointKind::kPlanar:
      about_z(double(q[2])), shift = {double(q[0]), double(q[1]), 0};
      break;
    case JointKind::kFloating:
      orient(q + 3), shift = vec3(q);
      break;
  }
}

// Angular and linear part of a joint's velocity or acceleration, in the child's frame.
void motion(const Joint& joint, const Number* x, Vec& angular, Vec& linear) {
  angular = linear = {};
  switch (joint.kind) {
    case JointKind::kRevolute:
      angular[2] = double(x[0]);
      break;
    case JointKind::kPrismatic:
      linear[2] = double(x[0]);
      break;
    case JointKind::kSpherical:
      angular = vec3(x);
      break;
    case JointKind::kPlanar:
      linear = {double(x[0]), double(x[1]), 0}, angular[2] = double(x[2]);
      break;
    case JointKind::kFloating:
      linear = vec3(x), angular = vec3(x + 3);
      break;
  }
}

// What a joint's damping, friction, spring and rotor take of its torque.
void add_passive(const Joint& joint, const Number* q, const Number* v, const Number* qdd,
                 double* tau) {
  const auto& own = joint;
  for (int k = 0; k < joint.nv; ++k) {
    const double rate = double(v[joint.v + k]);
    tau[k] += double(own.damping) * rate + double(own.rotor) * double(qdd[joint.v + k]) +
              double(own.friction) * std::tanh(rate / double(own.friction_speed));
  }
  if (own.stiffness != 0) tau[0] += double(own.stiffness) * (double(q[joint.q]) - double(own.rest));
}

// The outer forces push their links.
void push(const Number* outer, std::vector<Body>& body) {
  for (const OuterForce& one : about.outer_forces) {
    Body& b = body[static_cast<std::size_t>(one.link)];
    const Mat turn = mat3(one.rotation);
    const Vec force = times(turn, vec3(outer)), moment = times(turn, vec3(outer + 3));
    const Vec lever = cross(vec3(one.translation), force);
    for (int k = 0; k < 3; ++k) b.f[k] -= force[k], b.n[k] -= moment[k] + lever[k];
    outer += 6;
  }
}

// Torques that give accelerations qdd at (q, v) beside the outer forces; slaved joints count
// through their sources' torques.
void inverse_dynamics(const Number* q, const Number* v, const Number* qdd, const Number* outer,
                      double* tau) {
  static std::vector<Body> body;
  body.resize(static_cast<std::size_t>(about.links.count));
  body[0] = {};
  for (int k = 0; k < 3; ++k) body[0].a[k] = -about.gravity[k];
  for (int j = 0; j < about.joints.count; ++j) {
    const Joint& joint = about.joints[j];
    const Link& link = about.links[j + 1];
    const Body& parent = body[joint.parent];
    Body& b = body[j + 1];
    Mat turn;
    Vec shift, spin, slide, spin_rate, slide_rate;
    displace(joint, q + joint.q, turn, shift);
    motion(joint, v + joint.v, spin, slide);
    motion(joint, qdd + joint.v, spin_rate, slide_rate);
    b.turn = times(mat3(joint.rotation), turn);
    b.shift = vec3(joint.translation) + times(mat3(joint.rotation), shift);
    const Vec carried = transposed_times(b.turn, parent.w);
    b.w = carried + spin;
    b.dw = transposed_times(b.turn, parent.dw) + cross(carried, spin) + spin_rate;
    const Vec at_origin =
        parent.a + cross(parent.dw, b.shift) + cross(parent.w, cross(parent.w, b.shift));
    const Vec coriolis = cross(carried, slide);
    b.a =
        transposed_times(b.turn, at_origin) + coriolis + coriolis + cross(spin, slide) + slide_rate;
    const Vec c = vec3(link.com);
    const Vec at_com = b.a + cross(b.dw, c) + cross(b.w, cross(b.w, c));
    const Mat inertia = mat3(link.tensor);
    for (int k = 0; k < 3; ++k) b.f[k] = double(link.mass) * at_com[k];
    b.n = times(inertia, b.dw) + cross(b.w, times(inertia, b.w)) + cross(c, b.f);
  }
  push(outer, body);
  for (int j = about.joints.count - 1; j >= 0; --j) {
    const Joint& joint = about.joints[j];
    const Body& b = body[j + 1];
    double* t = tau + joint.v;
    switch (joint.kind) {
      case JointKind::kRevolute:
        t[0] = b.n[2];
        break;
      case JointKind::kPrismatic:
        t[0] = b.f[2];
        break;
      case JointKind::kSpherical:
        std::copy(b.n.begin(), b.n.end(), t);
        break;
      case JointKind::kPlanar:
        t[0] = b.f[0], t[1] = b.f[1], t[2] = b.n[2];
        break;
      case JointKind::kFloating:
        std::copy(b.f.begin(), b.f.end(), t);
        std::copy(b.n.begin(), b.n.end(), t + 3);
        break;
    }
    add_passive(joint, q, v, qdd, t);
    Body& parent = body[joint.parent];
    const Vec force = times(b.turn, b.f);
    parent.f = parent.f + force;
    parent.n = parent.n + times(b.turn, b.n) + cross(b.shift, force);
  }
  for (int j = 0; j < about.joints.count; ++j) {
    if (about.joints[j].source < 0) continue;
    tau[about.joints[about.joints[j].source].v] +=
        about.joints[j].multiplier * tau[about.joints[j].v];
    tau[about.joints[j].v] = 0;
  }
}

// How far slaved accelerations are from following their sources, relative to their size, and
// prescribed ones from what was prescribed.
double slip(const Number* tau, const Number* qdd) {
  double worst = 0;
  for (const Joint& joint : about.joints) {
    for (int k = joint.v; joint.prescribed && k < joint.v + joint.nv; ++k)
      worst = std::max(worst, std::abs(double(qdd[k]) - double(tau[k])));
    if (joint.source < 0) continue;
    const double own = double(qdd[joint.v]);
    const double due = joint.multiplier * double(qdd[about.joints[joint.source].v]);
    worst = std::max(worst, std::abs(own - due) / std::max(1.0, std::abs(due)));
  }
  return worst;
}

// The larger of that and of |ID(q, v, qdd) - tau| relative to the size of the torques that it
// balances.
double residual(const Number* q, const Number* v, const Number* tau, const Number* qdd) {
  const std::size_t nv = static_cast<std::size_t>(about.nv);
  static std::vector<double> needed(nv), at_rest(nv), given(nv);
  static const std::vector<Number> zero(nv);
  inverse_dynamics(q, v, qdd, tau + about.nv, needed.data());
  inverse_dynamics(q, v, zero.data(), tau + about.nv, at_rest.data());
  for (int k = 0; k < about.nv; ++k) given[k] = double(tau[k]);
  for (const Joint& joint : about.joints) {
    for (int k = joint.v; joint.prescribed && k < joint.v + joint.nv; ++k)
      given[k] = needed[k] = at_rest[k] = 0;  // nobody asks for its torque
  }
  for (int j = 0; j < about.joints.count; ++j) {
    if (about.joints[j].source < 0) continue;
    given[about.joints[about.joints[j].source].v] +=
        about.joints[j].multiplier * given[about.joints[j].v];
    given[about.joints[j].v] = 0;
  }
  double error = 0, size = 0;
  for (int k = 0; k < about.nv; ++k) {
    error += (needed[k] - given[k]) * (needed[k] - given[k]);
    size += given[k] * given[k] + at_rest[k] * at_rest[k];
  }
  return std::max(size > 0 ? std::sqrt(error / size) : std::sqrt(error), slip(tau, qdd));
}

}  // namespace check
