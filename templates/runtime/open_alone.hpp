// Why the last open of a thread gave no solver.
thread_local Text open_failure;

template <class AnySolver>
AnySolver* opened() {
  auto* const solver = new (std::nothrow) AnySolver;
  open_failure.clear();
  if (solver == nullptr) open_failure += "not enough memory";
  return solver;
}
