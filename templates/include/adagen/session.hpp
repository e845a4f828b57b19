// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <ios>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "loops.hpp"
#include "options.hpp"
#include "program_setting.hpp"
#include "slave.hpp"
#include "states.hpp"
#include "status.hpp"
#include "watch.hpp"

namespace adagen {
namespace {

// Data that the parts of the program share: the solver, the states, and the report of failures.

// Closes the loops of random states, each from its own configuration, then from others: until the
// solver takes one, if any. Near singular poses it does not.
template <class Uniform, class Taken>
void close(States& states, Uniform uniform, Taken taken) {
  constexpr int kTries = 60;
  const std::size_t nq = static_cast<std::size_t>(about.nq),
                    nv = static_cast<std::size_t>(about.nv);
  std::vector<double> rest(nq);
  for (const Joint& joint : about.joints)
    if (joint.nq >= 4) rest[static_cast<std::size_t>(joint.q + joint.nq - 1)] = 1;
  for (int s = 0; s < states.count; ++s) {
    const std::size_t row = static_cast<std::size_t>(s);
    Number *const q = states.q.data() + row * nq, *const v = states.v.data() + row * nv;
    const std::vector<double> drawn(q, q + nq), rates(v, v + nv);
    for (int tries = 0; tries < kTries; ++tries) {
      std::vector<double> rate(rates), step(nv), start(nq);
      for (double& x : step) x = tries == 0 ? 0 : 3 * uniform() / (1 << 2 * (tries % 3));
      manifold::move(tries % 2 == 0 ? drawn : rest, step, start);
      if (!loops::settle(start, rate)) continue;
      slave(about.joints, start.data(), rate.data());
      std::copy(start.begin(), start.end(), q), std::copy(rate.begin(), rate.end(), v);
      if (taken(s)) break;
    }
  }
}

// Random states, the same on every machine (splitmix64).
States random_states(int count, std::uint64_t seed, Solver& solver) {
  const auto uniform = [&seed] {
    std::uint64_t z = (seed += 0x9E3779B97F4A7C15ULL);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBULL;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1;  // in [-1, 1)
  };
  States states;
  states.count = count;
  const auto size = [count](int n) {
    return static_cast<std::size_t>(count) * static_cast<std::size_t>(n);
  };
  states.q.resize(size(about.nq));
  states.v.resize(size(about.nv));
  states.tau.resize(size(about.ntau));
  for (int s = 0; s < count; ++s) {
    const long row = s;
    Number* const q = states.q.data() + row * about.nq;
    Number* const v = states.v.data() + row * about.nv;
    Number* const tau = states.tau.data() + row * about.ntau;
    for (const Joint& joint : about.joints) {
      const bool turns = joint.kind == JointKind::kRevolute;
      for (int k = 0; k < joint.nq; ++k)
        q[joint.q + k] = static_cast<Number>(turns ? 3.141592653589793 * uniform() : uniform());
      if (joint.nq >= 4) {
        double p[4], squared;
        do {
          squared = 0;
          for (double& x : p) x = uniform(), squared += x * x;
        } while (squared > 1 || squared < 0.01);
        for (int k = 0; k < 4; ++k)
          q[joint.q + joint.nq - 4 + k] = static_cast<Number>(p[k] / std::sqrt(squared));
      }
      for (int k = 0; k < joint.nv; ++k) {
        v[joint.v + k] = about.at_rest ? Number(0) : static_cast<Number>(uniform());
        tau[joint.v + k] = static_cast<Number>(uniform());
      }
    }
    for (int k = about.nv; k < about.ntau; ++k) tau[k] = static_cast<Number>(uniform());
    slave(about.joints, q, v);
  }
  if (loops::any()) {
    std::vector<Number> qdd(static_cast<std::size_t>(std::max(1, about.nqdd)));
    close(states, uniform, [&](int s) {
      const long row = s;
      return solver.solve(states.q.data() + row * about.nq, states.v.data() + row * about.nv,
                          states.tau.data() + row * about.ntau, qdd.data()) == kFine;
    });
  }
  return states;
}

// The states file, read by process 0 and passed to all.
int load(const std::string& path, MPI_Comm comm, int rank, States& states) {
  int status = kDone;
  if (rank == 0) {
    std::ifstream file(path == "-" ? "/dev/stdin" : path, std::ios::binary);
    file.peek();  // tells a folder from a file
    std::ostringstream text;
    if (!file.bad()) text << file.rdbuf();
    std::string wrong;
    if (!file.is_open() || file.bad())
      wrong = " error: cannot read the states file";
    else
      wrong = StatesReader(text.str()).read(states);
    if (!wrong.empty()) {
      std::fprintf(stderr, "%s:%s\n", path.c_str(), wrong.c_str());
      status = kInputAtFault;
    }
  }
  MPI_Bcast(&status, 1, MPI_INT, 0, comm);
  if (status != kDone) return status;
  MPI_Bcast(&states.count, 1, MPI_INT, 0, comm);
  int gravity = static_cast<int>(states.gravity.size());
  MPI_Bcast(&gravity, 1, MPI_INT, 0, comm);
  states.gravity.resize(static_cast<std::size_t>(gravity));
  MPI_Bcast(states.gravity.data(), gravity, MPI_DOUBLE, 0, comm);
  const auto share = [&](std::vector<Number>& x, int n) {
    x.resize(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(n));
    MPI_Bcast(x.data(), static_cast<int>(x.size()), kMpiNumber, 0, comm);
  };
  if (about.batch) return status;  // distributed as they are solved
  share(states.q, about.nq);
  share(states.v, about.nv);
  share(states.tau, about.ntau);
  return status;
}

struct Session {
  Options options;
  int rank;
  Watch watch;
  Solver& solver;
  States states;
  std::vector<Number> qdd;  // of each state accelerations, and forces of loops where asked for
  bool pinned = false;

  Session(Options given, Solver& own, int own_rank)
      : options(std::move(given)), rank(own_rank), solver(own) {}

  MPI_Comm comm() const { return solver.comm(); }
  const Number* q(int s) const { return states.q.data() + static_cast<long>(s) * about.nq; }
  const Number* v(int s) const { return states.v.data() + static_cast<long>(s) * about.nv; }
  const Number* tau(int s) const { return states.tau.data() + static_cast<long>(s) * about.ntau; }
  Number* acceleration(int s) { return qdd.data() + static_cast<long>(s) * about.nqdd; }

  // The states file; where it says another gravity, and that can be set, it holds from now on.
  int load_states() {
    const int status = load(options.states, comm(), rank, states);
    if (status != kDone || states.gravity.empty()) return status;
    gravity_ = states.gravity;
    about.gravity = gravity_.data();
    solver.set_gravity(about.gravity);
    return status;
  }

  void use(States given) {
    states = std::move(given);
    qdd.assign(static_cast<std::size_t>(states.count) * static_cast<std::size_t>(about.nqdd),
               Number(0));
  }

  // Hands the states of process 0 to all.
  void share_states() {
    for (auto* const x : {&states.q, &states.v, &states.tau})
      MPI_Bcast(x->data(), static_cast<int>(x->size()), kMpiNumber, 0, comm());
  }

  int complain(int status, const std::string& what, const std::string& file = "") const {
    const std::string place = file.empty() ? "" : file + ": ";
    if (rank == 0) std::fprintf(stderr, "%serror: %s\n", place.c_str(), what.c_str());
    return status;
  }

  // A process that waited in vain cannot be waited for: the whole run ends.
  void give_up_if_broken(int failed) const {
    if (failure_kind(failed) != kNoAnswer) return;
    std::fprintf(stderr, "error: process %d: %s\n", rank, solver.in_words(failed));
    std::fflush(stderr);
    MPI_Abort(MPI_COMM_WORLD, kFault);
  }

 private:
  std::vector<double> gravity_;
};

}  // namespace
}  // namespace adagen
