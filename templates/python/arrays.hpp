// Arrays of Python's as rows of numbers.

namespace python {

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

bool same_rows(const Rows& q, const Rows& other, const char* name) {
  if (other.dimensions == q.dimensions && other.count == q.count) return true;
  PyErr_Format(PyExc_ValueError, "%s holds %zd states in %d dimensions, q %zd in %d", name,
               static_cast<Py_ssize_t>(other.count), other.dimensions,
               static_cast<Py_ssize_t>(q.count), q.dimensions);
  return false;
}

}  // namespace python
