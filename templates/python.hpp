// A Python type around the solver, to which adagen.Solver adds names: called with q, v, tau and
// out, it solves one state or many. Compiled behind the source of a solver for one process.
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_1_23_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>
#include <structmember.h>
#if defined(__linux__)
#include <sched.h>
#endif

#include <atomic>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

namespace python {

constexpr int kType = std::is_same_v<Number, double> ? NPY_DOUBLE : NPY_FLOAT;
// Accelerations from which on the interpreter is left to other threads: to give it away and get it
// back takes longer than to compute fewer.
constexpr npy_intp kMany = 1000;

// Accelerations for which another thread of our own pays.
constexpr npy_intp kOfThread = kBatch ? 200'000 : 50'000;
// States that a thread takes at once, at least: as many as fill a batch's registers.
constexpr npy_intp kPiece = 64;

// What could not be solved: how many states, and the first of them.
struct Failed {
  npy_intp count = 0, first = 0;
  int status = kFine;
  void note(npy_intp state, int what, npy_intp states = 1) {
    if (count == 0 || state < first) first = state, status = what;
    count += states;
  }
  void note(const Failed& other) {
    if (other.count > 0) note(other.first, other.status, other.count);
  }
};

struct Held {
  Solver solver;
  // Of further threads, which share many states; what each could not solve.
  std::vector<std::unique_ptr<Solver>> others;
  std::vector<std::thread> team;
  std::vector<Failed> failed;
  std::mutex mutex;  // threads of Python take turns
};
constexpr int kMostThreads = 1024;
constexpr bool kSharesThreads = kProcesses > 1;  // whether threads share each state already
constexpr double kTimeLimit = 30;                // s that threads of the solver wait for each other

// Starts the threads of a solver that has some; returns what is wrong, or an empty string.
template <class AnySolver>
auto start(AnySolver& solver, int) -> decltype(solver.open(nullptr, kTimeLimit)) {
  return solver.open(nullptr, kTimeLimit);
}
template <class AnySolver>
Text start(AnySolver&, long) {
  return {};
}

struct Object {
  PyObject_HEAD vectorcallfunc call;
  Held* held;
};

// A reference that is given up in the end.
class Owned {
 public:
  explicit Owned(PyObject* object = nullptr) : object_(object) {}
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;
  ~Owned() { Py_XDECREF(object_); }
  PyObject* get() const { return object_; }
  PyArrayObject* array() const { return reinterpret_cast<PyArrayObject*>(object_); }
  void take(PyObject* object) {
    Py_XDECREF(object_);
    object_ = object;
  }
  PyObject* release() { return std::exchange(object_, nullptr); }

 private:
  PyObject* object_;
};

// One argument as rows of numbers.
struct Rows {
  Owned held;
  int dimensions = 0;
  npy_intp count = 1;
  const Number* data() const { return static_cast<const Number*>(PyArray_DATA(held.array())); }
};

bool refuse_shape(const char* name, PyArrayObject* array, int width) {
  Owned shape(PyObject_GetAttrString(reinterpret_cast<PyObject*>(array), "shape"));
  if (shape.get() != nullptr)
    PyErr_Format(PyExc_ValueError, "%s has shape %S, not (%d,) for one state or (S, %d) for S",
                 name, shape.get(), width, width);
  return false;
}

// Anything that is no array of the solver's numbers, row behind row, becomes one.
PyObject* converted(PyObject* given) {
  Owned any(PyArray_FROM_O(given));
  if (any.get() == nullptr) return nullptr;
  PyArray_Descr* const type = PyArray_DescrFromType(kType);
  if (!PyArray_CanCastArrayTo(any.array(), type, NPY_SAME_KIND_CASTING)) {
    PyErr_Format(PyExc_TypeError, "%S are no real numbers", PyArray_DESCR(any.array()));
    Py_DECREF(type);
    return nullptr;
  }
  return PyArray_FromArray(any.array(), type, NPY_ARRAY_CARRAY_RO | NPY_ARRAY_FORCECAST);
}

bool take(PyObject* given, const char* name, int width, Rows& rows) {
  const bool ready = PyArray_Check(given) &&
                     PyArray_TYPE(reinterpret_cast<PyArrayObject*>(given)) == kType &&
                     PyArray_ISCARRAY_RO(reinterpret_cast<PyArrayObject*>(given));
  if (ready) Py_INCREF(given);
  rows.held.take(ready ? given : converted(given));
  if (rows.held.get() == nullptr) return false;
  PyArrayObject* const array = rows.held.array();
  rows.dimensions = PyArray_NDIM(array);
  if (rows.dimensions < 1 || rows.dimensions > 2 ||
      PyArray_DIM(array, rows.dimensions - 1) != width)
    return refuse_shape(name, array, width);
  rows.count = rows.dimensions == 2 ? PyArray_DIM(array, 0) : 1;
  return true;
}

// Where accelerations go: a new array, or the one that was given.
PyObject* output(PyObject* given, const Rows& q) {
  npy_intp shape[2] = {kNqdd, kNqdd};
  if (q.dimensions == 2) shape[0] = q.count;
  if (given == nullptr || given == Py_None) {
    PyObject* const made = PyArray_SimpleNew(q.dimensions, shape, kType);
    if (made == nullptr || kGivesAll) return made;
    auto* const first = static_cast<Number*>(PyArray_DATA(reinterpret_cast<PyArrayObject*>(made)));
    std::fill_n(first, PyArray_SIZE(reinterpret_cast<PyArrayObject*>(made)),
                std::numeric_limits<Number>::quiet_NaN());  // of joints that nobody asks for
    return made;
  }
  auto* const array = reinterpret_cast<PyArrayObject*>(given);
  if (!PyArray_Check(given) || PyArray_TYPE(array) != kType || !PyArray_ISCARRAY(array) ||
      PyArray_NDIM(array) != q.dimensions ||
      !PyArray_CompareLists(PyArray_DIMS(array), shape, q.dimensions)) {
    PyErr_Format(
        PyExc_ValueError,
        kNqdd == kNv
            ? "out must be an array of %s, written row behind row, in the shape of v"
            : "out must be an array of %s, written row behind row, nqdd numbers for each state",
        kType == NPY_DOUBLE ? "float64" : "float32");
    return nullptr;
  }
  Py_INCREF(given);
  return given;
}

// What is solved, and where that goes. Accelerations of states that cannot be solved are not
// numbers where there are many.
struct Task {
  const Number *q, *v, *tau;
  Number* qdd;
  npy_intp count;
  bool many;

  // States from the one numbered first on.
  template <class AnySolver>
  void solve(AnySolver& solver, npy_intp first, npy_intp states, Failed& failed) const {
    if constexpr (kBatch) {
      constexpr npy_intp kMost = 1 << 20;
      const npy_intp end = first + states;
      for (npy_intp s = first; s < end; s += kMost) {
        solver.solve_batch(static_cast<int>(std::min(kMost, end - s)), q + s * kNq, v + s * kNv,
                           tau + s * kNtau, qdd + s * kNqdd);
        if (solver.failures() == 0) continue;
        failed.note(s + solver.failed_state(0), solver.failed_status(0), solver.failures());
      }
    } else {
      for (npy_intp s = first; s < first + states; ++s) {
        const int status = solver.solve(q + s * kNq, v + s * kNv, tau + s * kNtau, qdd + s * kNqdd);
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

// Raises what adagen.errors makes of a failure.
PyObject* raise(const Failed& failed, const Rows& q, PyObject* out) {
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
  Owned error(PyObject_CallFunction(make.get(), "szOnO", describe(failed.status).c_str(), joint,
                                    state.get(), static_cast<Py_ssize_t>(failed.count),
                                    many ? out : Py_None));
  if (error.get() != nullptr)
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.get())), error.get());
  return nullptr;
}

bool same_rows(const Rows& q, const Rows& other, const char* name) {
  if (other.dimensions == q.dimensions && other.count == q.count) return true;
  PyErr_Format(PyExc_ValueError, "%s holds %zd states in %d dimensions, q %zd in %d", name,
               static_cast<Py_ssize_t>(other.count), other.dimensions,
               static_cast<Py_ssize_t>(q.count), q.dimensions);
  return false;
}

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
  if (q.count > 0 && (qdd == q.data() || qdd == v.data() || qdd == tau.data())) {
    PyErr_SetString(PyExc_ValueError, "out is also what is read");
    return nullptr;
  }
  const int threads = threads_for(placed[4], q.count);
  if (threads == 0) return nullptr;
  Held& held = *reinterpret_cast<Object*>(self)->held;
  const Task task{q.data(), v.data(), tau.data(), qdd, q.count, q.dimensions == 2};
  Failed failed;
  if (threads == 1 && q.count * kNv < kMany && held.mutex.try_lock()) {
    failed = solve(held, 1, task);
    held.mutex.unlock();
  } else {
    Py_BEGIN_ALLOW_THREADS held.mutex.lock();
    failed = solve(held, threads, task);
    held.mutex.unlock();
    Py_END_ALLOW_THREADS
  }
  return failed.count == 0 ? out.release() : raise(failed, q, out.get());
}

// Sets the numbers from the one numbered first on that can be set at run time.
template <class AnySolver>
auto set_numbers(AnySolver& solver, int first, int count, const Number* x, int)
    -> decltype(set_parameters(solver, first, count, x)) {
  return set_parameters(solver, first, count, x);
}
template <class AnySolver>
int set_numbers(AnySolver&, int, int, const Number*, long) {
  return failure(kNotSet, 0);
}

// set(first, numbers): of what can be set at run time.
PyObject* set(PyObject* self, PyObject* arguments) {
  int first = 0;
  PyObject* given = nullptr;
  if (!PyArg_ParseTuple(arguments, "iO", &first, &given)) return nullptr;
  Owned any(converted(given));
  if (any.get() == nullptr) return nullptr;
  const npy_intp count = PyArray_SIZE(any.array());
  if (first < 0 || first + count > kParameterCount)
    return PyErr_Format(PyExc_ValueError, "there are no such numbers to be set at run time");
  Held& held = *reinterpret_cast<Object*>(self)->held;
  int status = kFine;
  Py_BEGIN_ALLOW_THREADS held.mutex.lock();
  status = set_numbers(held.solver, first, static_cast<int>(count),
                       static_cast<const Number*>(PyArray_DATA(any.array())), 0);
  held.mutex.unlock();
  Py_END_ALLOW_THREADS if (status == kFine) Py_RETURN_NONE;
  return PyErr_Format(PyExc_ValueError, "%s", describe(status).c_str());
}

PyMethodDef methods[] = {{"_set", set, METH_VARARGS, nullptr}, {nullptr, nullptr, 0, nullptr}};

PyObject* make(PyTypeObject* type, PyObject*, PyObject*) {
  auto* const self = reinterpret_cast<Object*>(type->tp_alloc(type, 0));
  if (self == nullptr) return nullptr;
  self->call = call;
  self->held = new (std::nothrow) Held;
  if (self->held == nullptr) {
    Py_DECREF(self);
    return PyErr_NoMemory();
  }
#ifdef ADAGEN_REPRODUCIBLE
  if (const char* const why = why_not_reproducible()) {
    Py_DECREF(self);
    return PyErr_Format(PyExc_OSError, "%s", why);
  }
#endif
  const Text wrong = start(self->held->solver, 0);
  if (wrong.empty()) return reinterpret_cast<PyObject*>(self);
  Py_DECREF(self);
  return PyErr_Format(PyExc_OSError, "%s", wrong.c_str());
}

void drop(PyObject* self) {
  PyTypeObject* const type = Py_TYPE(self);
  delete reinterpret_cast<Object*>(self)->held;
  type->tp_free(self);
  Py_DECREF(type);
}

PyMemberDef members[] = {
    {"__vectorcalloffset__", T_PYSSIZET, offsetof(Object, call), READONLY, nullptr},
    {nullptr, 0, 0, 0, nullptr}};

PyType_Slot slots[] = {{Py_tp_new, reinterpret_cast<void*>(make)},
                       {Py_tp_dealloc, reinterpret_cast<void*>(drop)},
                       {Py_tp_call, reinterpret_cast<void*>(PyVectorcall_Call)},
                       {Py_tp_members, members},
                       {Py_tp_methods, methods},
                       {0, nullptr}};

PyType_Spec spec = {"adagen_solver.Core", sizeof(Object), 0,
                    Py_TPFLAGS_DEFAULT | Py_TPFLAGS_BASETYPE | Py_TPFLAGS_HAVE_VECTORCALL, slots};

int fill(PyObject* module) {
  if (_import_array() < 0) return -1;
  Owned type(PyType_FromSpec(&spec));
  return type.get() == nullptr ? -1 : PyModule_AddObjectRef(module, "Core", type.get());
}

PyModuleDef_Slot steps[] = {{Py_mod_exec, reinterpret_cast<void*>(fill)}, {0, nullptr}};

PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "adagen_solver", nullptr, 0, nullptr, steps, nullptr, nullptr, nullptr};

}  // namespace python

PyMODINIT_FUNC PyInit_adagen_solver() { return PyModuleDef_Init(&python::definition); }
