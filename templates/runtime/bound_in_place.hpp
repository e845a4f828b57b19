// The bound of the error of the last evaluation.
[[maybe_unused]] inline double error_bound(const Workspace& w) {
  return bound_of(static_cast<double>(w.certificate[0]), static_cast<double>(w.certificate[1]));
}
