// Pinocchio's dynamics with closed loops, instantiated from its headers: constraintDynamics (a
// sparse Cholesky factorization) and lcaba (loop-constrained articulated bodies).
//
// PROGRAM MODEL STATES RESULT REPEAT CONSTRAINTS FACTORS|LCABA MU
//
// CONSTRAINTS has a line for each: point or weld; joint, rotation and translation of frame 1, then
// of frame 2. Joint 0 is the ground. MU is the proximal parameter of constraintDynamics, 0 where
// constraints are independent.

#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#define BOOST_MPL_LIMIT_VECTOR_SIZE 30
#define PINOCCHIO_ENABLE_UNSUPPORTED
#include "pinocchio/algorithm/constrained-dynamics.hpp"
#include "pinocchio/algorithm/loop-constrained-aba.hpp"
#include "pinocchio_model.hpp"

namespace {

using Models = PINOCCHIO_STD_VECTOR_WITH_EIGEN_ALLOCATOR(pinocchio::RigidConstraintModel);
using Datas = PINOCCHIO_STD_VECTOR_WITH_EIGEN_ALLOCATOR(pinocchio::RigidConstraintData);

Models read_constraints(const char* path, const pinocchio::Model& model) {
  std::ifstream file(path);
  const auto vector = [&file] {
    Eigen::Vector3d x;
    file >> x[0] >> x[1] >> x[2];
    return x;
  };
  const auto place = [&vector] {
    Eigen::Matrix3d turn;
    for (int k = 0; k < 3; ++k) turn.row(k) = vector().transpose();
    return pinocchio::SE3(turn, vector());
  };
  Models found;
  std::string kind;
  while (file >> kind) {
    pinocchio::JointIndex one = 0, two = 0;
    file >> one;
    const pinocchio::SE3 first = place();
    file >> two;
    const pinocchio::SE3 second = place();
    const auto type = kind == "weld" ? pinocchio::CONTACT_6D : pinocchio::CONTACT_3D;
    found.emplace_back(type, model, one, first, two, second, pinocchio::LOCAL);
  }
  return found;
}

}  // namespace

int main(int words, char** word) {
  if (words != 8) measure::fail("usage: MODEL STATES RESULT REPEAT CONSTRAINTS FACTORS|LCABA MU");
  const pinocchio::Model model = read_model(word[1]);
  const measure::States states = measure::read_states(word[2]);
  if (model.nq != states.nq || model.nv != states.nv) measure::fail("states of another model");
  pinocchio::Data data(model);
  const Models constraints = read_constraints(word[5], model);
  Datas at;
  for (const auto& one : constraints) at.emplace_back(one);
  const std::vector<Vector> q = rows(states.q, states.count, states.nq);
  const std::vector<Vector> v = rows(states.v, states.count, states.nv);
  const std::vector<Vector> tau = rows(states.tau, states.count, states.nv);
  const bool factors = std::string(word[6]) == "FACTORS";
  const double mu = std::atof(word[7]);
  if (factors)
    pinocchio::initConstraintDynamics(model, data, constraints, at);
  else
    pinocchio::computeJointMinimalOrdering(model, data, constraints);
  return measure::run(states, word[3], std::atoi(word[4]), [&](long s, double* qdd) {
    const auto k = static_cast<std::size_t>(s);
    if (factors) {
      pinocchio::ProximalSettings settings(1e-14, mu, mu > 0 ? 10 : 1);
      pinocchio::constraintDynamics(model, data, q[k], v[k], tau[k], constraints, at, settings);
    } else {
      pinocchio::ProximalSettings settings(1e-10, 1e-4, 20);
      pinocchio::lcaba(model, data, q[k], v[k], tau[k], constraints, at, settings);
    }
    Vector::Map(qdd, model.nv) = data.ddq;
  });
}
