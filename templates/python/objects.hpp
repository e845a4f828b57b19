// A Python type around the solver, to which adagen.Solver adds names: called with q, v, tau and
// out, it solves one state or many. Compiled behind the source of a solver for one process, part
// after part: what the type holds.
#define PY_SSIZE_T_CLEAN
#define NPY_NO_DEPRECATED_API NPY_1_23_API_VERSION
#include <Python.h>
#include <numpy/arrayobject.h>

#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace python {

constexpr int kType = std::is_same_v<Number, double> ? NPY_DOUBLE : NPY_FLOAT;
// Accelerations from which on the interpreter is left to other threads, where nothing else is set.
// To give it away takes some 50 ns, but to get it back from a thread that computes in Python takes
// until that one's turn ends, after milliseconds: fewer accelerations are found long before.
constexpr Py_ssize_t kMany = 1000;

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

struct Held {
  Solver solver;
  // Of further threads, which share many states; what each could not solve.
  std::vector<std::unique_ptr<Solver>> others;
  std::vector<std::thread> team;
  std::vector<Failed> failed;
  std::mutex mutex;  // threads of Python take turns
  Owned bounds;      // of the errors of the last call's answers, where they are certified
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
  Py_ssize_t keeps_lock_below;
};

}  // namespace python
