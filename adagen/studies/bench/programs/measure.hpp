// What every peer's program does around its own solver: read states, time as an emitted program
// does (`--time`: one reading of the clock on either side of each evaluation), write the answers.

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>
#if defined(__linux__)
#include <sched.h>
#endif

namespace measure {

using Clock = std::chrono::steady_clock;

// States in the peer's own coordinates: `count` rows of each.
struct States {
  long count = 0, nq = 0, nv = 0;
  std::vector<double> q, v, tau;
};

[[noreturn]] inline void fail(const std::string& what) {
  std::fprintf(stderr, "error: %s\n", what.c_str());
  std::exit(3);
}

inline States read_states(const char* path) {
  std::ifstream file(path, std::ios::binary);
  States states;
  double sizes[3] = {0, 0, 0};
  const auto read = [&file](double* to, std::size_t n) {
    file.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(n * sizeof(double)));
  };
  read(sizes, 3);
  states.count = static_cast<long>(sizes[0]);
  states.nq = static_cast<long>(sizes[1]);
  states.nv = static_cast<long>(sizes[2]);
  states.q.resize(static_cast<std::size_t>(states.count * states.nq));
  for (std::vector<double>* x : {&states.v, &states.tau})
    x->resize(static_cast<std::size_t>(states.count * states.nv));
  for (std::vector<double>* x : {&states.q, &states.v, &states.tau}) read(x->data(), x->size());
  if (!file || states.count < 1) fail(std::string("cannot read the states in ") + path);
  return states;
}

// The first core of those that this process may use, as process 0 of an emitted program.
inline bool pin() {
#if defined(__linux__)
  cpu_set_t allowed, one;
  if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return false;
  int cpu = 0;
  while (cpu < CPU_SETSIZE && !CPU_ISSET(cpu, &allowed)) ++cpu;
  CPU_ZERO(&one);
  CPU_SET(cpu, &one);
  return sched_setaffinity(0, sizeof one, &one) == 0;
#else
  return false;
#endif
}

// Calls solve(s, qdd) for each state in turn, `repeat` times over and once before to warm up;
// reports nanoseconds as JSON and writes the answers.
template <class Solve>
int run(const States& states, const char* result, int repeat, Solve&& solve) {
  const bool pinned = pin();
  std::vector<double> qdd(static_cast<std::size_t>(states.count * states.nv)), ns;
  for (int pass = -1; pass < repeat; ++pass)
    for (long s = 0; s < states.count; ++s) {
      const Clock::time_point start = Clock::now();
      solve(s, qdd.data() + s * states.nv);
      const double spent = std::chrono::duration<double, std::nano>(Clock::now() - start).count();
      if (pass >= 0) ns.push_back(spent);
    }
  std::sort(ns.begin(), ns.end());
  std::ofstream file(result, std::ios::binary);
  file.write(reinterpret_cast<const char*>(qdd.data()),
             static_cast<std::streamsize>(qdd.size() * sizeof(double)));
  if (!file.flush()) fail(std::string("cannot write ") + result);
  std::printf("{\"pinned\": %s, \"evaluations\": %zu, \"median_ns\": %.0f, \"min_ns\": %.0f}\n",
              pinned ? "true" : "false", ns.size(), ns[ns.size() / 2], ns.front());
  return 0;
}

}  // namespace measure
