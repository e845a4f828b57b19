// A program that has two emitted solvers linked in: one for two processes, one for each process
// by itself. It reads states (numbers in text) and prints what it gets, one line for each fact.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <vector>

#include "arm7_p2.h"
#include "mobile_p1.h"

namespace {

constexpr double kUntouched = 12345;

struct State {
  std::vector<double> q, v, tau;
};

std::vector<State> read(const char* path, int nq, int nv) {
  std::ifstream file(path);
  std::vector<State> states;
  const auto take = [&file](std::vector<double>& x, int n) {
    x.resize(static_cast<std::size_t>(n));
    for (double& value : x) file >> value;
  };
  for (;;) {
    State state;
    take(state.q, nq), take(state.v, nv), take(state.tau, nv);
    if (!file) return states;
    states.push_back(state);
  }
}

void print(const char* solver, const char* what, int rank, const std::vector<double>& qdd) {
  std::printf("%s %s %d", solver, what, rank);
  for (const double x : qdd) std::printf(x == kUntouched ? " -" : " %.17g", x);
  std::printf("\n");
}

template <class Solver>
struct Functions {
  const char* name;
  int (*joint)(int, const char**, int*, int*, int*, int*);
  Solver* (*open)(MPI_Comm, const char*, double);
  int (*solve)(Solver*, const double*, const double*, const double*, double*);
  int (*solve_at_root)(Solver*, const double*, const double*, const double*, double*);
  const char* (*failure)(const Solver*);
  void (*close)(Solver*);
};

template <class Solver>
void use(const Functions<Solver>& f, MPI_Comm comm, const char* channel, const char* path) {
  int rank = 0, world = 0, nq = 0, nv = 0;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_rank(MPI_COMM_WORLD, &world);
  const char* name = nullptr;
  for (int k = 0, q, q_size, v, v_size; f.joint(k, &name, &q, &q_size, &v, &v_size); ++k) {
    if (world == 0)
      std::printf("%s joint %d %s %d %d %d %d\n", f.name, k, name, q, q_size, v, v_size);
    nq = q + q_size, nv = v + v_size;
  }
  Solver* const solver = f.open(comm, channel, 30);
  if (solver == nullptr) {
    std::printf("%s cannot be opened\n", f.name);
    return;
  }
  const std::vector<State> states = read(path, nq, nv);
  std::vector<double> qdd(static_cast<std::size_t>(nv));
  for (const State& s : states) {
    qdd.assign(qdd.size(), kUntouched);
    if (f.solve(solver, s.q.data(), s.v.data(), s.tau.data(), qdd.data()) == 0)
      print(f.name, "place", world, qdd);
  }
  const auto at_root = [&](const State& s, const char* what) {
    qdd.assign(qdd.size(), kUntouched);
    const int failed =
        rank == 0 ? f.solve_at_root(solver, s.q.data(), s.v.data(), s.tau.data(), qdd.data())
                  : f.solve_at_root(solver, nullptr, nullptr, nullptr, nullptr);
    if (rank == 0) print(f.name, what, world, qdd);
    if (failed != 0) std::printf("%s failure %d %s\n", f.name, world, f.failure(solver));
  };
  for (const State& s : states) at_root(s, "root");
  State spoilt = states.front();
  spoilt.v.back() = std::nan("");
  at_root(spoilt, "spoilt");
  at_root(states.front(), "after");
  f.close(solver);
}

// One process knows no other.
mobile_p1_solver* open_mobile(MPI_Comm, const char*, double) { return mobile_p1_open(); }

constexpr Functions<arm7_p2_solver> kArm{"arm7_p2",     arm7_p2_joint,         arm7_p2_open,
                                         arm7_p2_solve, arm7_p2_solve_at_root, arm7_p2_failure,
                                         arm7_p2_close};
constexpr Functions<mobile_p1_solver> kMobile{"mobile_p1",     mobile_p1_joint, open_mobile,
                                              mobile_p1_solve, mobile_p1_solve, mobile_p1_failure,
                                              mobile_p1_close};

// What cannot be opened says why.
void refuse(MPI_Comm comm, const char* channel, double time_limit) {
  arm7_p2_solver* const solver = arm7_p2_open(comm, channel, time_limit);
  std::printf("refuses %d: %s\n", solver == nullptr, arm7_p2_failure(nullptr));
}

}  // namespace

int main(int count, char** words) {
  refuse(MPI_COMM_WORLD, "auto", 30);
  MPI_Init(&count, &words);
  use(kArm, MPI_COMM_WORLD, words[1], words[2]);
  use(kMobile, MPI_COMM_SELF, words[1], words[3]);
  refuse(MPI_COMM_SELF, "auto", 30);
  refuse(MPI_COMM_WORLD, "pigeon", 30);
  refuse(MPI_COMM_WORLD, "auto", 0);
  MPI_Finalize();
}
