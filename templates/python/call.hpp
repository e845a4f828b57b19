// A call's arguments, and the call.
#include <functional>

#if defined(__linux__)
#include <sched.h>
#endif

namespace python {

constexpr const char* kNames[] = {"q", "v", "tau", "out", "threads"};
constexpr int kArguments = 5;

// Puts arguments in order; those that are not given stay null.
bool arrange(PyObject* const* given, Py_ssize_t count, PyObject* names, PyObject** placed) {
  if (count >= kArguments) {
    PyErr_Format(PyExc_TypeError, "a solver takes q, v, tau, out and threads=, not %zd arguments",
                 count);
    return false;
  }
  for (Py_ssize_t k = 0; k < count; ++k) placed[k] = given[k];
  const Py_ssize_t named = names == nullptr ? 0 : PyTuple_GET_SIZE(names);
  for (Py_ssize_t k = 0; k < named; ++k) {
    PyObject* const name = PyTuple_GET_ITEM(names, k);
    int place = 0;
    while (place < kArguments && PyUnicode_CompareWithASCIIString(name, kNames[place]) != 0)
      ++place;
    if (place == kArguments || placed[place] != nullptr) {
      PyErr_Format(PyExc_TypeError, "a solver takes q, v, tau, out and threads, each once: %R",
                   name);
      return false;
    }
    placed[place] = given[count + k];
  }
  for (int k = 0; k < 3; ++k)
    if (placed[k] == nullptr) {
      PyErr_Format(PyExc_TypeError, "%s is missing: a solver takes q, v and tau", kNames[k]);
      return false;
    }
  return true;
}

// The cores that this process may use.
npy_intp cores() {
#if defined(__linux__)
  cpu_set_t own;
  if (sched_getaffinity(0, sizeof own, &own) == 0) return std::max(1, CPU_COUNT(&own));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

// How many threads share some states: as many as are asked for and have something to do, or as pay.
// Returns 0 where that is refused.
int threads_for(PyObject* given, npy_intp count) {
  const npy_intp pieces = std::max<npy_intp>(1, (count + kPiece - 1) / kPiece);
  if (given == nullptr || given == Py_None) {
    if (kSharesThreads || count * kNv < 2 * kOfThread) return 1;
    return static_cast<int>(std::min({cores(), count * kNv / kOfThread, pieces}));
  }
  const long asked = PyLong_AsLong(given);
  if (asked == -1 && PyErr_Occurred() != nullptr) return 0;
  if (asked < 1 || asked > kMostThreads) {
    PyErr_Format(PyExc_ValueError, "threads is from 1 to %d, not %ld", kMostThreads, asked);
    return 0;
  }
  if (kSharesThreads && asked > 1) {
    PyErr_SetString(
        PyExc_ValueError,
        "threads of this solver share each state: compile with procs=1 to share states");
    return 0;
  }
  return static_cast<int>(std::min<npy_intp>(asked, pieces));
}

// Whether two rows of numbers have some in common.
bool overlap(const Number* a, npy_intp count_a, const Number* b, npy_intp count_b) {
  const std::less<> before;
  return before(a, b + count_b) && before(b, a + count_a);
}

PyObject* call(PyObject* self, PyObject* const* given, std::size_t flags, PyObject* names) {
  PyObject* placed[kArguments] = {};
  if (!arrange(given, PyVectorcall_NARGS(flags), names, placed)) return nullptr;
  Rows q, v, tau;
  if (!take(placed[0], "q", kNq, q) || !take(placed[1], "v", kNv, v) ||
      !take(placed[2], "tau", kNtau, tau) || !same_rows(q, v, "v") || !same_rows(q, tau, "tau"))
    return nullptr;
  Owned out(output(placed[3], q));
  if (out.get() == nullptr) return nullptr;
  auto* const qdd = static_cast<Number*>(PyArray_DATA(out.array()));
  const npy_intp numbers = q.count * kNqdd;
  if (overlap(qdd, numbers, q.data(), q.count * kNq) ||
      overlap(qdd, numbers, v.data(), q.count * kNv) ||
      overlap(qdd, numbers, tau.data(), q.count * kNtau)) {
    PyErr_SetString(PyExc_ValueError, "out is also what is read");
    return nullptr;
  }
  const int threads = threads_for(placed[4], q.count);
  if (threads == 0) return nullptr;
  Held& held = *reinterpret_cast<Object*>(self)->held;
  Owned bounds;
  double* of_states = nullptr;
  if constexpr (kCertified) {
    bounds.take(PyArray_SimpleNew(q.dimensions - 1, &q.count, NPY_DOUBLE));
    if (bounds.get() == nullptr) return nullptr;
    of_states = static_cast<double*>(PyArray_DATA(bounds.array()));
  }
  const Task task{q.data(), v.data(), tau.data(), qdd, q.count, q.dimensions == 2, of_states};
  Failed failed;
  const bool few = q.count * kNv < reinterpret_cast<Object*>(self)->keeps_lock_below;
  if (threads == 1 && few && held.mutex.try_lock()) {
    failed = solve(held, 1, task);
    held.mutex.unlock();
  } else {
    Py_BEGIN_ALLOW_THREADS held.mutex.lock();
    failed = solve(held, threads, task);
    held.mutex.unlock();
    Py_END_ALLOW_THREADS
  }
  if constexpr (kCertified) held.bounds.take(bounds.release());
  return failed.count == 0 ? out.release() : raise(self, failed, q, v, out.get());
}

}  // namespace python
