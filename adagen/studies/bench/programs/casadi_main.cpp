
// PROGRAM STATES RESULT REPEAT: the function that casadi generated, above.

int main(int words, char** word) {
  if (words != 4) measure::fail("usage: STATES RESULT REPEAT");
  const measure::States states = measure::read_states(word[1]);
  casadi_int arguments = 0, results = 0, integers = 0, reals = 0;
  forward_dynamics_work(&arguments, &results, &integers, &reals);
  std::vector<const casadi_real*> in(static_cast<std::size_t>(arguments));
  std::vector<casadi_real*> out(static_cast<std::size_t>(results));
  std::vector<casadi_int> iw(static_cast<std::size_t>(integers));
  std::vector<casadi_real> w(static_cast<std::size_t>(reals));
  return measure::run(states, word[2], std::atoi(word[3]), [&](long s, double* qdd) {
    in[0] = states.q.data() + s * states.nq;
    in[1] = states.v.data() + s * states.nv;
    in[2] = states.tau.data() + s * states.nv;
    out[0] = qdd;
    forward_dynamics(in.data(), out.data(), iw.data(), w.data(), 0);
  });
}
