// The type and the module.
#include <structmember.h>

#include <cstddef>
#include <new>

namespace python {

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

// bounds(): of the errors of the last call's answers; None where there are none.
PyObject* bounds(PyObject* self, PyObject*) {
  PyObject* const held = reinterpret_cast<Object*>(self)->held->bounds.get();
  return Py_NewRef(held == nullptr ? Py_None : held);
}

PyMethodDef methods[] = {{"_set", set, METH_VARARGS, nullptr},
                         {"_bounds", bounds, METH_NOARGS, nullptr},
                         {nullptr, nullptr, 0, nullptr}};

PyObject* make(PyTypeObject* type, PyObject*, PyObject*) {
  auto* const self = reinterpret_cast<Object*>(type->tp_alloc(type, 0));
  if (self == nullptr) return nullptr;
  self->call = call;
  self->keeps_lock_below = kMany;
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
    {"keeps_lock_below", T_PYSSIZET, offsetof(Object, keeps_lock_below), 0, nullptr},
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
