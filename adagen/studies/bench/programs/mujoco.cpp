// MuJoCo's smooth forward dynamics: kinematics, composite inertia, its factor, bias, solve. No
// contacts, constraints, actuators or sensors, which the model has none of.
//
// PROGRAM MODEL STATES RESULT REPEAT

#include <mujoco/mujoco.h>

int main(int words, char** word) {
  if (words != 5) measure::fail("usage: MODEL STATES RESULT REPEAT");
  mjModel* const model = mj_loadModel(word[1], nullptr);
  if (model == nullptr) measure::fail("MuJoCo cannot load its model");
  const measure::States states = measure::read_states(word[2]);
  if (model->nq != states.nq || model->nv != states.nv) measure::fail("states of another model");
  mjData* const data = mj_makeData(model);
  mj_forward(model, data);
  const auto nq = static_cast<std::size_t>(states.nq), nv = static_cast<std::size_t>(states.nv);
  const int status = measure::run(states, word[3], std::atoi(word[4]), [&](long s, double* qdd) {
    std::copy_n(states.q.data() + s * states.nq, nq, data->qpos);
    std::copy_n(states.v.data() + s * states.nv, nv, data->qvel);
    const double* const tau = states.tau.data() + s * states.nv;
    mj_kinematics(model, data);
    mj_comPos(model, data);
    mj_makeM(model, data);
    mj_factorM(model, data);
    mj_comVel(model, data);
    mj_rne(model, data, 0, data->qfrc_bias);
    for (std::size_t k = 0; k < nv; ++k) data->qfrc_smooth[k] = tau[k] - data->qfrc_bias[k];
    mj_solveM(model, data, qdd, data->qfrc_smooth, 1);
  });
  mj_deleteData(data);
  mj_deleteModel(model);
  return status;
}
