// The errors of these answers are not bounded.
ADAGEN_INLINE double bound_of_state(const Group&, int) {
  return std::numeric_limits<double>::infinity();
}
