// Follows an emitted solver of threads, here named SOLVER: what it answers, refuses and costs while
// nothing is asked of it.
#include <dirent.h>
#include <sched.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <thread>
#include <utility>
#include <vector>

namespace {

// CPU time of all threads so far, ms.
double spent() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  const auto ms = [](const timeval& t) {
    return 1e3 * double(t.tv_sec) + 1e-3 * double(t.tv_usec);
  };
  return ms(used.ru_utime) + ms(used.ru_stime);
}

void sleep(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

// Binds this thread to the first core it may use. Returns it, or -1 if that is the only one.
int bound() {
  cpu_set_t own, one;
  CPU_ZERO(&one);
  if (sched_getaffinity(0, sizeof own, &own) != 0 || CPU_COUNT(&own) < 2) return -1;
  std::size_t core = 0;
  while (!CPU_ISSET(core, &own)) ++core;
  CPU_SET(core, &one);
  return sched_setaffinity(0, sizeof one, &one) == 0 ? int(core) : -1;
}

// How many other threads of this program may run on a core; on any.
int others(int core = -1) {
  int count = 0;
  DIR* const tasks = opendir("/proc/self/task");
  while (const dirent* const task = readdir(tasks)) {
    const int id = std::atoi(task->d_name);
    cpu_set_t own;
    if (id == 0 || id == getpid() || sched_getaffinity(id, sizeof own, &own) != 0) continue;
    count += core < 0 || CPU_ISSET(core, &own);
  }
  closedir(tasks);
  return count;
}

}  // namespace

int main() {
  std::vector<Number> q(kNq, Number(0.3)), v(kNv, Number(0.2)), tau(kNtau, Number(0.1)), qdd(kNv),
      first(kNv);
  std::printf("%d ", SOLVER_open_threads(nullptr, 0) == nullptr);
  std::printf("%s\n", SOLVER_failure(nullptr));
  const std::vector<int> nowhere(kProcesses, 100000);
  std::printf("%d ", SOLVER_open_threads(nowhere.data(), 1) == nullptr);
  std::printf("%s\n", SOLVER_failure(nullptr));

  for (int again = 0; again < 20; ++again) {
    SOLVER_solver* const solver = SOLVER_open_threads(nullptr, 20);
    SOLVER_solve(solver, q.data(), v.data(), tau.data(), first.data());
    SOLVER_close(solver);
  }
  sleep(50);
  const int strangers = others();  // threads of a sanitizer

  SOLVER_solver* const solver = SOLVER_open_threads(nullptr, 20);
  int other = 0;
  const auto solve = [&] {
    const int status = SOLVER_solve(solver, q.data(), v.data(), tau.data(), qdd.data());
    other += status != 0 || qdd != first;
  };
  for (int k = 0; k < 2000; ++k) solve();
  for (int k = 0; k < 50; ++k) sleep(1), solve();  // the threads have gone to sleep
  std::printf("other answers: %d\n", other);
  const int core = bound();
  sleep(5), solve();
  std::printf("on the caller's core: %d\n", core < 0 ? 0 : others(core) - strangers);

  for (const std::size_t spoilt : {std::size_t(0), v.size() - 1}) {
    const Number kept = std::exchange(v[spoilt], std::numeric_limits<Number>::infinity());
    std::fill(qdd.begin(), qdd.end(), Number(7));
    const int status = SOLVER_solve(solver, q.data(), v.data(), tau.data(), qdd.data());
    const bool untouched = qdd == std::vector<Number>(kNv, Number(7));
    std::printf("%d %d %d %s\n", SOLVER_reason(status), SOLVER_failed_joint(status), untouched,
                SOLVER_failure(solver));
    v[spoilt] = kept;
    solve();
  }
  sleep(50);
  const double before = spent();
  sleep(500);
  std::printf("asleep: %d\n", spent() - before < 25);
  solve();
  std::printf("other answers: %d\n", other);
  SOLVER_close(solver);
  for (const Number x : first) std::printf("%.17g ", double(x));
  std::printf("\n");
}
