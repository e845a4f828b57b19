// Pinocchio's articulated-body algorithm, instantiated from its headers with this program's own
// flags; nothing of the prebuilt library is linked, so that no Eigen types are mixed.
//
// PROGRAM MODEL STATES RESULT REPEAT LOCAL|WORLD

// Its variant of joints has more kinds than Boost allows for by itself.
#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#define BOOST_MPL_LIMIT_VECTOR_SIZE 30
#include "pinocchio/algorithm/aba.hpp"

namespace {

using Vector = Eigen::VectorXd;

// One joint a line: kind, parent, rotation, translation; mass, centre of mass, inertia about it.
pinocchio::Model read_model(const char* path) {
  std::ifstream file(path);
  pinocchio::Model model;
  const auto vector = [&file] {
    Eigen::Vector3d x;
    file >> x[0] >> x[1] >> x[2];
    return x;
  };
  const auto matrix = [&vector] {
    Eigen::Matrix3d rows;
    for (int k = 0; k < 3; ++k) rows.row(k) = vector().transpose();
    return rows;
  };
  model.gravity.linear() = vector();
  std::string kind;
  while (file >> kind) {
    pinocchio::JointIndex parent;
    double mass;
    file >> parent;
    const Eigen::Matrix3d turn = matrix();
    const pinocchio::SE3 place(turn, vector());
    file >> mass;
    const Eigen::Vector3d centre = vector();
    const pinocchio::Inertia inertia(mass, centre, matrix());
    const std::string name = "j" + std::to_string(model.njoints);
    pinocchio::JointIndex joint = 0;
    if (kind == "revolute")
      joint = model.addJoint(parent, pinocchio::JointModelRZ(), place, name);
    else if (kind == "prismatic")
      joint = model.addJoint(parent, pinocchio::JointModelPZ(), place, name);
    else if (kind == "spherical")
      joint = model.addJoint(parent, pinocchio::JointModelSpherical(), place, name);
    else if (kind == "planar")
      joint = model.addJoint(parent, pinocchio::JointModelPlanar(), place, name);
    else if (kind == "floating")
      joint = model.addJoint(parent, pinocchio::JointModelFreeFlyer(), place, name);
    else
      measure::fail("unknown kind of joint " + kind);
    model.appendBodyToJoint(joint, inertia, pinocchio::SE3::Identity());
  }
  return model;
}

std::vector<Vector> rows(const std::vector<double>& all, long count, long width) {
  std::vector<Vector> found;
  for (long s = 0; s < count; ++s)
    found.push_back(Eigen::Map<const Vector>(all.data() + s * width, width));
  return found;
}

}  // namespace

int main(int words, char** word) {
  if (words != 6) measure::fail("usage: MODEL STATES RESULT REPEAT LOCAL|WORLD");
  const pinocchio::Model model = read_model(word[1]);
  const measure::States states = measure::read_states(word[2]);
  if (model.nq != states.nq || model.nv != states.nv) measure::fail("states of another model");
  pinocchio::Data data(model);
  const std::vector<Vector> q = rows(states.q, states.count, states.nq);
  const std::vector<Vector> v = rows(states.v, states.count, states.nv);
  const std::vector<Vector> tau = rows(states.tau, states.count, states.nv);
  const bool world = std::string(word[5]) == "WORLD";
  const pinocchio::Convention convention =
      world ? pinocchio::Convention::WORLD : pinocchio::Convention::LOCAL;
  return measure::run(states, word[3], std::atoi(word[4]), [&](long s, double* qdd) {
    const auto k = static_cast<std::size_t>(s);
    pinocchio::aba(model, data, q[k], v[k], tau[k], convention);
    Vector::Map(qdd, model.nv) = data.ddq;
  });
}
