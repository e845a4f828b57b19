// What goes into a message, and out of one.
template <class M>
Real* put(Real* to, const M& m) {
  Eigen::Map<M>{to} = m;
  return to + M::SizeAtCompileTime;
}

template <class M>
const Real* get(const Real* from, M& m) {
  m = Eigen::Map<const M>(from);
  return from + M::SizeAtCompileTime;
}

template <std::size_t n>
Real* put(Real* to, const std::array<Real, n>& x) {
  return std::copy(x.begin(), x.end(), to);
}

template <std::size_t n>
const Real* get(const Real* from, std::array<Real, n>& x) {
  std::copy(from, from + n, x.begin());
  return from + n;
}
