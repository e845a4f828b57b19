// The bound of the error of one of the states of a group.
ADAGEN_INLINE double bound_of_state(const Group& group, int state) {
  const auto& squares = group.w.certificate;
  return bound_of(static_cast<double>(squares[0][state]), static_cast<double>(squares[1][state]));
}
