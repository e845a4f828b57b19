// A program that solves batches with an emitted solver and prints what it finds, a line each.
// Words: channel, the file of states, then cases: how many states, and which of them are spoilt.
#include <mpi.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "arm7_batch_p2.h"

namespace {

constexpr int kJoints = 9;  // all with one freedom

using Numbers = std::vector<double>;

// The first count of the states, over and over.
Numbers rows(const Numbers& given, int count) {
  Numbers result(static_cast<std::size_t>(count * kJoints));
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = given[k % given.size()];
  return result;
}

struct States {
  Numbers q, v, tau;
};

// "same" where each state's accelerations are, bit by bit, those that it has by itself.
const char* verdict(arm7_batch_p2_solver* solver, const States& s, int count, const Numbers& qdd) {
  for (int k = 0; k < count; ++k) {
    const long row = kJoints * k;
    double alone[kJoints];
    const int failed =
        arm7_batch_p2_solve_batch(solver, 1, &s.q[row], &s.v[row], &s.tau[row], alone);
    for (int j = 0; j < kJoints; ++j)
      if (failed != 0 ? !std::isnan(qdd[row + j]) : qdd[row + j] != alone[j]) return "other";
  }
  return "same";
}

void report(const char* what, const std::string& words, arm7_batch_p2_solver* solver, int failed,
            const States& s, int count, const Numbers& qdd) {
  std::printf("%s %s: %s;", what, words.c_str(), failed == 0 ? "fine" : "failed");
  if (failed != 0) std::printf(" %s;", arm7_batch_p2_failure(solver));
  for (int k = 0; arm7_batch_p2_failed_state(solver, k) >= 0; ++k)
    std::printf(" %d", arm7_batch_p2_failed_state(solver, k));
  std::printf("; %s\n", verdict(solver, s, count, qdd));
}

}  // namespace

int main(int count, char** words) {
  MPI_Init(&count, &words);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  arm7_batch_p2_solver* const solver = arm7_batch_p2_open(MPI_COMM_WORLD, words[1], 30);
  Numbers q, v, tau;
  std::ifstream file(words[2]);
  for (std::string line; std::getline(file, line);) {
    std::istringstream numbers(line);
    for (Numbers* part : {&q, &v, &tau})
      for (int k = 0; k < kJoints; ++k) {
        double x = 0;
        numbers >> x;
        part->push_back(x);
      }
  }
  for (int k = 3; k < count; ++k) {
    std::istringstream numbers(words[k]);
    int states = 0;
    numbers >> states;
    States s{rows(q, states), rows(v, states), rows(tau, states)};
    for (int spoilt; numbers >> spoilt;) s.v[kJoints * spoilt + 3] = std::nan("");
    Numbers qdd(s.q.size(), 12345);
    int failed =
        arm7_batch_p2_solve_batch(solver, states, s.q.data(), s.v.data(), s.tau.data(), qdd.data());
    if (rank == 1) report("alone", words[k], solver, failed, s, states, qdd);
    qdd.assign(qdd.size(), 12345);
    failed = rank == 0 ? arm7_batch_p2_solve_batch_at_root(solver, states, s.q.data(), s.v.data(),
                                                           s.tau.data(), qdd.data())
                       : arm7_batch_p2_solve_batch_at_root(solver, -1, nullptr, nullptr, nullptr,
                                                           nullptr);
    if (rank == 0) report("shared", words[k], solver, failed, s, states, qdd);
    if (rank == 1 && failed != 0) std::printf("process 1 failed\n");
  }
  arm7_batch_p2_close(solver);
  MPI_Finalize();
}
