// Follows an emitted solver of threads, here named SOLVER: a thread of it is late in a call, and
// the caller's state is gone when it comes to read that. Its memory is taken away then: who reads
// it falls.
#include <pthread.h>
#include <signal.h>
#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>

namespace {

struct Late {
  SOLVER_solver* const solver = SOLVER_open_threads(nullptr, 20);
  Number* const numbers = static_cast<Number*>(
      mmap(nullptr, 1 << 16, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0));
  Number qdd[kNv] = {};

  Late() { std::fill_n(numbers, kNq + kNv + kNtau, Number(0.3)); }
  int solve() { return SOLVER_solve(solver, numbers, numbers + kNq, numbers + kNq + kNv, qdd); }
};

}  // namespace

int main() {
  signal(SIGUSR1, [](int) { std::this_thread::sleep_for(std::chrono::milliseconds(100)); });
  Late late;
  std::printf("fine %d\n", late.solve() == 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // the others sleep now
  std::fill_n(late.qdd, kNv, Number(7));
  late.solver->channel.open(0, late.solver->team_->slots, std::chrono::milliseconds(1));
  for (auto& member : late.solver->team_->members_)
    if (member.thread.joinable()) pthread_kill(member.thread.native_handle(), SIGUSR1);
  std::this_thread::sleep_for(std::chrono::milliseconds(5));  // they are in the handler
  const int status = late.solve();
  munmap(late.numbers, 1 << 16);
  std::printf("late %d, no answer %d: %s\n", status != 0, SOLVER_reason(status) == UPPER_NO_ANSWER,
              SOLVER_failure(late.solver));
  std::this_thread::sleep_for(std::chrono::milliseconds(300));
  std::printf("later %d\n", std::count(late.qdd, late.qdd + kNv, Number(7)) == kNv);
  SOLVER_close(late.solver);
  std::printf("closed\n");
}
