
// Times the solver above on random states: median nanoseconds of an evaluation, over when the last
// process is done. A small program in place of the emitted one's own, which takes compilers twice
// as long as the solver.
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif

namespace {

using Time = std::chrono::steady_clock;

void pin(int rank) {
#if defined(__linux__)
  cpu_set_t all, own;
  if (sched_getaffinity(0, sizeof all, &all) != 0) return;
  for (int cpu = 0, left = rank; cpu < CPU_SETSIZE; ++cpu)
    if (CPU_ISSET(cpu, &all) && left-- == 0) {
      CPU_ZERO(&own);
      CPU_SET(cpu, &own);
      sched_setaffinity(0, sizeof own, &own);
      return;
    }
#endif
}

// All processes begin at the same instant, a little after the last one has come.
Time::time_point begin(int processes) {
  if (processes == 1) return Time::now();
  std::int64_t ns = Time::now().time_since_epoch().count();
  MPI_Allreduce(MPI_IN_PLACE, &ns, 1, MPI_INT64_T, MPI_MAX, MPI_COMM_WORLD);
  const Time::time_point start{Time::duration(ns + 20000)};
  while (Time::now() < start) {
  }
  return start;
}

}  // namespace

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int rank = 0, processes = 1, nq = 0, nv = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &processes);
  pin(rank);
  const char* name = nullptr;
  for (int k = 0, q, q_size, v, v_size; STEM_joint(k, &name, &q, &q_size, &v, &v_size); ++k)
    nq = q + q_size, nv = v + v_size;
  STEM_solver* const solver = STEM_open(OPENING);
  if (solver == nullptr) MPI_Abort(MPI_COMM_WORLD, 1);
  constexpr int states = 64;
  std::uint64_t seed = 88172645463325252;
  const auto random = [&seed] {  // Marsaglia's xorshift; from -1 to 1
    seed ^= seed << 13, seed ^= seed >> 7, seed ^= seed << 17;
    return static_cast<double>(seed >> 11) / 4503599627370496.0 - 1;
  };
  std::vector<double> q(static_cast<std::size_t>(states * nq)), v(states * nv), tau(v), qdd(v);
  for (std::vector<double>* all : {&q, &v, &tau})
    for (double& x : *all) x = random();
  std::vector<double> ns;
  const int repeat = argc > 1 ? std::atoi(argv[1]) : 20;
  int failed = 0;
  for (int pass = -3; pass < repeat; ++pass)  // the first ones warm up
    for (int s = 0; s < states; ++s) {
      const Time::time_point start = begin(processes);
      failed |= STEM_solve(solver, &q[static_cast<std::size_t>(s * nq)], &v[s * nv], &tau[s * nv],
                           &qdd[s * nv]);
      const double taken = std::chrono::duration<double, std::nano>(Time::now() - start).count();
      if (pass >= 0) ns.push_back(taken);
    }
  MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  MPI_Allreduce(MPI_IN_PLACE, ns.data(), static_cast<int>(ns.size()), MPI_DOUBLE, MPI_MAX,
                MPI_COMM_WORLD);
  std::nth_element(ns.begin(), ns.begin() + static_cast<std::ptrdiff_t>(ns.size() / 2), ns.end());
  if (rank == 0 && failed == 0) std::printf("%.1f\n", ns[ns.size() / 2]);
  STEM_close(solver);
  MPI_Finalize();
  return failed != 0;
}
