// Follows an emitted solver of threads, here named SOLVER: copies of its process, which have none
// of its threads, are answered as it is, and end.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

namespace {

struct Forked {
  SOLVER_solver* const solver = SOLVER_open_threads(nullptr, 20);
  const std::vector<Number> q = std::vector<Number>(kNq, Number(0.3)),
                            v = std::vector<Number>(kNv, Number(0.2)),
                            tau = std::vector<Number>(kNtau, Number(0.1));
  std::vector<Number> first = std::vector<Number>(kNv), qdd = first;

  // How many of some calls are answered otherwise than the first one was.
  int others(int calls) {
    int count = 0;
    for (int k = 0; k < calls; ++k)
      count +=
          SOLVER_solve(solver, q.data(), v.data(), tau.data(), qdd.data()) != 0 || qdd != first;
    return count;
  }
};

// The exit status of a copy of this process, which does a task; 99 where it was ended by a signal.
template <class Task>
int copied(Task task) {
  const pid_t child = fork();
  if (child == 0) {
    alarm(10);  // of a copy that hangs
    _exit(task());
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 99;
}

}  // namespace

int main() {
  Forked own;
  SOLVER_solve(own.solver, own.q.data(), own.v.data(), own.tau.data(), own.first.data());
  const auto closes = [&] { return SOLVER_close(own.solver), 0; };
  const auto solves = [&] { return own.others(50); };
  const auto solves_and_closes = [&] { return own.others(50) + closes(); };
  const auto has_a_copy = [&] { return copied(solves_and_closes) + solves_and_closes(); };
  for (const int ms : {0, 20}) {  // the threads are awake, asleep
    std::this_thread::sleep_for(std::chrono::milliseconds(ms));
    std::printf("%d ", copied(closes));
    std::printf("%d ", copied(solves));
    std::printf("%d ", copied(solves_and_closes));
    std::printf("%d ", copied(has_a_copy));
    std::printf("%d\n", own.others(50));
  }
  SOLVER_close(own.solver);
  std::printf("%d\n", copied([] {
                SOLVER_solver* const again = SOLVER_open_threads(nullptr, 20);
                return SOLVER_close(again), again == nullptr;
              }));
}
