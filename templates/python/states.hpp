// States solved, on one thread or shared among several, and what is raised where they cannot be.
#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <new>
#include <string>

namespace python {

// What is solved, and where that goes. Accelerations of states that cannot be solved are not
// numbers where there are many.
struct Task {
  const Number *q, *v, *tau;
  Number* qdd;
  npy_intp count;
  bool many;
  double* bounds;  // of the errors, a number for each state; null where they are not certified

  // States from the one numbered first on.
  template <class AnySolver>
  void solve(AnySolver& solver, npy_intp first, npy_intp states, Failed& failed) const {
    if constexpr (kBatch) {
      constexpr npy_intp kMost = 1 << 20;
      const npy_intp end = first + states;
      for (npy_intp s = first; s < end; s += kMost) {
        solver.solve_batch(static_cast<int>(std::min(kMost, end - s)), q + s * kNq, v + s * kNv,
                           tau + s * kNtau, qdd + s * kNqdd,
                           bounds == nullptr ? nullptr : bounds + s);
        if (solver.failures() == 0) continue;
        failed.note(s + solver.failed_state(0), solver.failed_status(0), solver.failures());
      }
    } else {
      for (npy_intp s = first; s < first + states; ++s) {
        const int status = solver.solve(q + s * kNq, v + s * kNv, tau + s * kNtau, qdd + s * kNqdd);
        if constexpr (kCertified)
          bounds[s] =
              status == kFine ? error_bound(solver.w) : std::numeric_limits<double>::quiet_NaN();
        if (status == kFine) continue;
        failed.note(s, status);
        if (many) std::fill_n(qdd + s * kNqdd, kNqdd, std::numeric_limits<Number>::quiet_NaN());
      }
    }
  }
};

// Has a solver for each thread, all with the same set at run time. Returns how many threads there
// is memory for.
int gather(Held& held, int threads) {
  held.failed.clear();
  try {
    const auto count = static_cast<std::size_t>(threads);
    while (held.others.size() + 1 < count) held.others.push_back(std::make_unique<Solver>());
    held.team.reserve(count);
    held.failed.resize(count);
  } catch (const std::bad_alloc&) {
    return 1;
  }
  std::array<Number, kParameterCount> numbers{};
  pack_parameters(numbers.data(), held.solver.workspace(0));
  for (const auto& other : held.others)
    for (int k = 0; k < Solver::kWorkspaces; ++k)
      unpack_parameters(numbers.data(), other->workspace(k));
  return threads;
}

// Threads take pieces as they finish earlier ones; each state is solved as by one thread alone.
Failed share_out(Held& held, int threads, const Task& task) {
  const npy_intp share = task.count / (8 * threads) / kPiece * kPiece;
  const npy_intp piece = std::max(share, kPiece);
  std::atomic<npy_intp> next{0};
  const auto work = [&](Solver& solver, Failed& own) {
    for (npy_intp first; (first = next.fetch_add(piece)) < task.count;)
      task.solve(solver, first, std::min(piece, task.count - first), own);
  };
  try {
    for (std::size_t k = 1; k < held.failed.size(); ++k)
      held.team.emplace_back([&, k] { work(*held.others[k - 1], held.failed[k]); });
  } catch (const std::exception&) {  // the system gives no more: those that run do it all
  }
  work(held.solver, held.failed.front());
  for (std::thread& each : held.team) each.join();
  held.team.clear();
  Failed all;
  for (const Failed& own : held.failed) all.note(own);
  return all;
}

Failed solve(Held& held, int threads, const Task& task) {
  if (threads > 1) threads = gather(held, threads);
  if (threads > 1) return share_out(held, threads, task);
  Failed failed;
  task.solve(held.solver, 0, task.count, failed);
  return failed;
}

// By how much a loop is open in a state, or how fast it opens; nothing where it is another failure.
// Returns null where that cannot be said, which is raised then.
PyObject* how_far(PyObject* self, int status, const Number* q, const Number* v) {
  const Failure kind = failure_kind(status);
  if (kind != kLoopOpen && kind != kLoopTorn) return PyUnicode_FromString("");
  const auto seen = [](const Number* numbers, npy_intp count) {
    return PyArray_SimpleNewFromData(1, &count, kType, const_cast<Number*>(numbers));
  };
  Owned place(seen(q, kNq)), speed(seen(v, kNv));
  if (place.get() == nullptr || speed.get() == nullptr) return nullptr;
  return PyObject_CallMethod(self, "_how_far", "iiOO", failure_place(status),
                             int(kind == kLoopTorn), place.get(), speed.get());
}

// Raises what adagen.errors makes of a failure.
PyObject* raise(PyObject* self, const Failed& failed, const Rows& q, const Rows& v, PyObject* out) {
  Owned far(
      how_far(self, failed.status, q.data() + failed.first * kNq, v.data() + failed.first * kNv));
  const char* const by = far.get() == nullptr ? nullptr : PyUnicode_AsUTF8(far.get());
  if (by == nullptr) return nullptr;
  Owned errors(PyImport_ImportModule("adagen.errors"));
  if (errors.get() == nullptr) return nullptr;
  Owned make(PyObject_GetAttrString(errors.get(), "SolveError"));
  if (make.get() == nullptr) return nullptr;
  const bool many = q.dimensions == 2;
  const char* const joint = is_of_joint(failure_kind(failed.status))
                                ? kJoints[failure_place(failed.status)].name
                                : nullptr;
  Owned state(many ? PyLong_FromSsize_t(failed.first) : Py_NewRef(Py_None));
  if (state.get() == nullptr) return nullptr;
  const std::string text = std::string(describe(failed.status).c_str()) + by;
  Owned error(PyObject_CallFunction(make.get(), "szOnO", text.c_str(), joint, state.get(),
                                    static_cast<Py_ssize_t>(failed.count), many ? out : Py_None));
  if (error.get() != nullptr)
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.get())), error.get());
  return nullptr;
}

}  // namespace python
