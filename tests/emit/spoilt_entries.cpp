// Follows an emitted solver for one process, here named `guarded`: spoils each entry of a state in
// turn and prints what the solver says of it; "unlike" where it writes, or answers differently
// after.
#include <fstream>
#include <vector>

int main(int, char** words) {
  const char* name = nullptr;
  int nq = 0, nv = 0;
  for (int k = 0, q, q_size, v, v_size; guarded_p1_joint(k, &name, &q, &q_size, &v, &v_size); ++k)
    nq = q + q_size, nv = v + v_size;
  std::vector<Number> x[3];
  const int sizes[3] = {nq, nv, nv};
  std::ifstream file(words[1]);
  for (int f = 0; f < 3; ++f) {
    x[f].resize(static_cast<std::size_t>(sizes[f]));
    for (Number& value : x[f]) file >> value;
  }
  guarded_p1_solver* const solver = guarded_p1_open();
  const std::vector<Number> untouched(static_cast<std::size_t>(nv), 12345);
  std::vector<Number> good = untouched;
  const auto solve = [&](std::vector<Number>& qdd) {
    return guarded_p1_solve(solver, x[0].data(), x[1].data(), x[2].data(), qdd.data());
  };
  if (solve(good) != 0) std::printf("%s\n", guarded_p1_failure(solver));
  constexpr Number kInfinity = std::numeric_limits<Number>::infinity();
  for (int f = 0; f < 3; ++f)
    for (std::size_t k = 0; k < x[f].size(); ++k)
      for (const Number bad : {std::numeric_limits<Number>::quiet_NaN(), kInfinity, -kInfinity}) {
        std::vector<Number> qdd = untouched, after = untouched;
        const Number kept = x[f][k];
        x[f][k] = bad;
        const int failed = solve(qdd);
        x[f][k] = kept;
        std::printf("%d %zu %s\n", f, k, failed == 0 ? "answers" : guarded_p1_failure(solver));
        if (qdd != untouched || solve(after) != 0 || after != good) std::printf("unlike\n");
      }
  guarded_p1_close(solver);
}
