inline void fail(Workspace& w, Failure kind, int joint) {
  Channel::fail(w.status, failure(kind, joint));
}

// x - x is zero for finite x only.
inline void require_finite(Workspace& w, const Number* x, int count, int joint) {
  Number sum = 0;
  for (int k = 0; k < count; ++k) sum += x[k] - x[k];
  if (!(sum == 0)) fail(w, kNotFinite, joint);
}

[[maybe_unused]] inline void require_length(Workspace& w, Real squared, int joint) {
  if (!(squared >= std::numeric_limits<Real>::min() && squared <= std::numeric_limits<Real>::max()))
    fail(w, kZeroQuaternion, joint);
}

template <std::size_t n>
void load_torque(Workspace& w, int joint, int v, std::array<std::array<Real, kColumns>, n>& tau) {
  require_finite(w, w.tau + v, static_cast<int>(n), joint);
  for (std::size_t k = 0; k < n; ++k) {
    tau[k] = {};
    tau[k][0] = Real(w.tau[v + static_cast<int>(k)]);
  }
}

// An acceleration is given only where all went well.
template <std::size_t n>
void store_acceleration(Workspace& w, int joint, int v,
                        const std::array<std::array<Real, kColumns>, n>& qdd) {
  Real sum = 0;
  for (std::size_t k = 0; k < n; ++k) sum += qdd[k][0] - qdd[k][0];
  if (!(sum == 0)) fail(w, kOverflow, joint);
  if (w.status != kFine) return;
  for (std::size_t k = 0; k < n; ++k) w.qdd[v + static_cast<int>(k)] = qdd[k][0];
}

const Mat6 kZero = Mat6::Zero();

// The ground accelerates against gravity: all accelerations are relative to free fall.
const Columns6 kGround = [] {
  Columns6 result = Columns6::Zero();
  for (int k = 0; k < 3; ++k) result(3 + k, 0) = -Real(kGravity[static_cast<std::size_t>(k)]);
  return result;
}();

// Phi = I^-1 of a bare link at its origin, from its upper triangle row by row.
[[maybe_unused]] Mat6 symmetric(const std::array<Real, 21>& upper) {
  Mat6 result;
  std::size_t k = 0;
  for (int i = 0; i < 6; ++i)
    for (int j = i; j < 6; ++j) result(i, j) = result(j, i) = upper[k++];
  return result;
}

// One row of A qdd = 0, which keeps a slaved joint in step with its source.
[[maybe_unused]] inline void coupling_row(std::array<Real, kColumns>& row,
                                          const std::array<Real, kColumns>& slaved,
                                          const std::array<Real, kColumns>& source,
                                          double multiplier) {
  for (std::size_t k = 0; k < kColumns; ++k) row[k] = slaved[k] - Real(multiplier) * source[k];
}

// The torques that make A qdd zero: (A H^-1 A^T) torques = -A qdd, by Cholesky's factorization.
template <std::size_t m>
void solve_coupling(Workspace& w, int joint, const std::array<std::array<Real, m + 1>, m>& rows,
                    std::array<Real, m>& torques) {
  std::array<std::array<Real, m>, m> L;
  std::array<std::array<Real, 1>, m> x;
  for (std::size_t i = 0; i < m; ++i) {
    x[i][0] = -rows[i][0];
    for (std::size_t k = 0; k < m; ++k) L[i][k] = rows[i][k + 1];
  }
  if (!factorize(L)) fail(w, kFactorization, joint);
  forward_substitute(L, x);
  backward_substitute(L, x);
  for (std::size_t i = 0; i < m; ++i) torques[i] = x[i][0];
}

// Accelerations of all right-hand sides, added up with the coupling torques.
template <std::size_t n, std::size_t m>
void store_coupled(Workspace& w, int joint, int v,
                   const std::array<std::array<Real, kColumns>, n>& qdd,
                   const std::array<Real, m>& torques) {
  std::array<std::array<Real, kColumns>, n> sum{};
  for (std::size_t k = 0; k < n; ++k) {
    sum[k][0] = qdd[k][0];
    for (std::size_t c = 0; c < m; ++c) sum[k][0] += qdd[k][c + 1] * torques[c];
  }
  store_acceleration(w, joint, v, sum);
}
