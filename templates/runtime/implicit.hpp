// Damping D and stiffness K of joints as they act at the end of a step: with B = h D + h^2 K,
// (H + B) a = r, where H a0 = r would be the torques' answer with springs at q + h v. From the
// evaluations of unit torques, M = (H^-1) at the joints with B: (B^-1 + M) y = a0 there, and the
// torques less y give a. One evaluation for each such degree of freedom, and two.
class PassiveTerms {
 public:
  using State = std::vector<double>;

  PassiveTerms() : extra_(kNv), base_(kNv), unit_(kNv) {
    for (const JointConstants& joint : kJoints)
      for (int k = 0; k < joint.nv; ++k)
        if (!joint.passive.prescribed && (joint.passive.damping > 0 || joint.passive.stiffness > 0))
          rows_.push_back({static_cast<std::size_t>(joint.v + k), double(joint.passive.damping),
                           double(joint.passive.stiffness)});
    matrix_.assign(rows_.size() * rows_.size(), 0);
    y_.resize(rows_.size());
  }

  // a at the end of a step of length h from (q, v).
  template <class Accelerate>
  int accelerate(double h, const State& q, const State& v, State& a, Accelerate evaluate) {
    const std::size_t n = rows_.size();
    std::fill(extra_.begin(), extra_.end(), 0.0);
    for (const Row& row : rows_) extra_[row.v] = -h * row.stiffness * v[row.v];
    if (const int failed = evaluate(q, v, extra_, base_)) return failed;
    if (n == 0) {
      a = base_;
      return kFine;
    }
    for (std::size_t k = 0; k < n; ++k) {
      const double before = extra_[rows_[k].v];
      extra_[rows_[k].v] += 1;
      if (const int failed = evaluate(q, v, extra_, unit_)) return failed;
      extra_[rows_[k].v] = before;
      for (std::size_t i = 0; i < n; ++i)
        matrix_[i * n + k] = unit_[rows_[i].v] - base_[rows_[i].v];
    }
    for (std::size_t k = 0; k < n; ++k) {
      matrix_[k * n + k] += 1 / (h * rows_[k].damping + h * h * rows_[k].stiffness);
      y_[k] = base_[rows_[k].v];
    }
    solve();
    for (std::size_t k = 0; k < n; ++k) extra_[rows_[k].v] -= y_[k];
    return evaluate(q, v, extra_, a);
  }

 private:
  struct Row {
    std::size_t v;
    double damping, stiffness;
  };

  // y <- matrix^-1 y by elimination; the matrix is symmetric and positive definite but for
  // rounding.
  ADAGEN_HOT void solve() {
    const std::size_t n = rows_.size();
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t i = k + 1; i < n; ++i) {
        const double part = matrix_[i * n + k] / matrix_[k * n + k];
        for (std::size_t j = k; j < n; ++j) matrix_[i * n + j] -= part * matrix_[k * n + j];
        y_[i] -= part * y_[k];
      }
    for (std::size_t k = n; k-- > 0;) {
      for (std::size_t j = k + 1; j < n; ++j) y_[k] -= matrix_[k * n + j] * y_[j];
      y_[k] /= matrix_[k * n + k];
    }
  }

  std::vector<Row> rows_;
  State extra_, base_, unit_, matrix_, y_;
};
