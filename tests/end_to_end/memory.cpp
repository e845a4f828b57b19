// Follows an emitted solver for one process, here named SOLVER: counts what is taken from the heap
// once it is open, and bytes of the stack, where states are solved and where they are not.
#include <pthread.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <vector>

namespace {
long allocations = 0;
}

extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void* malloc(std::size_t size) { return ++allocations, __libc_malloc(size); }
void* calloc(std::size_t count, std::size_t size) {
  return ++allocations, __libc_calloc(count, size);
}
void* realloc(void* old, std::size_t size) { return ++allocations, __libc_realloc(old, size); }
void* aligned_alloc(std::size_t to, std::size_t size) {
  return ++allocations, __libc_memalign(to, size);
}
}

// A stack of a thread, filled with a pattern: what calls need of it has another one afterwards.
constexpr std::size_t kStack = 1 << 20;
alignas(4096) unsigned char painted[kStack];

template <class Work>
std::size_t used_by(const Work& work) {
  std::fill_n(painted, kStack, 0xA5);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstack(&attributes, painted, kStack);
  pthread_t thread;
  const auto call = [](void* given) -> void* {
    return (**static_cast<const Work**>(given))(), nullptr;
  };
  const Work* given = &work;
  if (pthread_create(&thread, &attributes, call, &given) != 0) std::abort();
  pthread_join(thread, nullptr);
  return kStack -
         (std::find_if(painted, painted + kStack, [](int x) { return x != 0xA5; }) - painted);
}

int main() {
  std::vector<Number> q(8 * kNq, Number(0.3)), v(8 * kNv, Number(0.2)), tau(8 * kNtau, Number(0.1)),
      qdd(8 * kNv);
  const long before = allocations;
  SOLVER_solver* const solver = OPEN;
  const long opened = allocations - before;
  int failed = 0, words = 0;
  const auto solve = [&] {
#ifdef BATCH
    failed += SOLVER_solve_batch(solver, 8, q.data(), v.data(), tau.data(), qdd.data()) != 0;
    words += SOLVER_failed_state(solver, 0) >= 0;
#else
    failed += SOLVER_solve(solver, q.data(), v.data(), tau.data(), qdd.data()) != 0;
#endif
    words += SOLVER_failure(solver)[0] != '\0';
  };
  long later = 0;
  const auto both = [&] {
    const long started = allocations;
    solve();
    v[0] = std::numeric_limits<Number>::infinity();
    solve();
    later = allocations - started;
  };
  const std::size_t stack = used_by(both) - used_by([] {});
  SOLVER_close(solver);
  std::printf("opened %d, failed %d, said %d, later %ld\n", opened > 0, failed, words > 0, later);
  std::printf("stack %zu\n", stack);
}
