// Pinocchio's articulated-body algorithm, instantiated from its headers with this program's own
// flags; nothing of the prebuilt library is linked, so that no Eigen types are mixed.
//
// PROGRAM MODEL STATES RESULT REPEAT LOCAL|WORLD

// Its variant of joints has more kinds than Boost allows for by itself.
#define BOOST_MPL_CFG_NO_PREPROCESSED_HEADERS
#define BOOST_MPL_LIMIT_LIST_SIZE 30
#define BOOST_MPL_LIMIT_VECTOR_SIZE 30
#include "pinocchio/algorithm/aba.hpp"
#include "pinocchio_model.hpp"

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
