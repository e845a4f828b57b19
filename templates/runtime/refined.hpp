// One evaluation, refined: as if it were a process's only list of steps.
inline void exchange_step(Workspace& w, Channel& channel) {
  Refinement& r = w.refinement;
  int number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.source != channel.rank()) continue;
    Real* to = channel.outgoing(message, w.status);
    for (const int k : info.entries) *to++ = r.step[k];
    for (const int j : info.forces) to = put(to, r.force[j]);
    channel.send(message, w.status);
  }
  number = kFirstExchange;
  for (const ExchangeInfo& info : kExchanges) {
    const int message = number++;
    if (info.target != channel.rank()) continue;
    const Real* from = channel.receive(message, w.status);
    for (const int k : info.entries) r.step[k] = *from++;
    for (const int j : info.forces) from = get(from, r.force[j]);
  }
}

// The joints' forces with the torques that hold slaved joints in step.
inline void collect_forces(Workspace& w, const RefinedProcess& own) {
  for (const int j : own.forces) {
    const Columns6& f = w.refinement.f[j];
    w.refinement.force[j] = f.col(0);
    for (int c = 1; c < kColumns; ++c)
      w.refinement.force[j] += f.col(c) * coupling_torque(w, c - 1);
  }
}

// Shares of the energies to process 0, and what they come to back to all.
inline double share_size(Workspace& w, Channel& channel) {
  Real e = static_cast<Real>(w.refinement.step_energy), t = static_cast<Real>(w.refinement.energy);
  int message = kFirstShare;
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      const Real* from = channel.receive(message, w.status);
      e += from[0], t += from[1];
    } else if (channel.rank() == p) {
      Real* to = channel.outgoing(message, w.status);
      to[0] = e, to[1] = t;
      channel.send(message, w.status);
    }
    ++message;
  }
  double size = std::sqrt(double(e) / double(t));
  if (!(t > 0)) size = e > 0 ? std::numeric_limits<double>::infinity() : 0;
  for (const int p : kSharing) {
    if (channel.rank() == 0) {
      *channel.outgoing(message, w.status) = static_cast<Real>(size);
      channel.send(message, w.status);
    } else if (channel.rank() == p) {
      size = double(*channel.receive(message, w.status));
    }
    ++message;
  }
  return size;
}

// A correction must be smaller than the one before (the first, than the answer), down to rounding.
inline void require_convergence(Workspace& w, int k) {
  const double size = w.refinement.corrections[k],
               before = k > 0 ? w.refinement.corrections[k - 1] : 1;
  const double rounding = 16 * double(std::numeric_limits<Real>::epsilon());
  if (!(size < rounding || size < before / 2)) fail(w, kNotRefined, 0);
}

void refined(Workspace& w, Channel& channel) {
  const RefinedProcess& own = kRefined[channel.rank()];
  if (own.own.count == 0) return;
  static constexpr std::array<Real, kNv> no_torque{};
  Refinement& r = w.refinement;
  const Real* const tau = w.tau;
  Real* const qdd = w.qdd;
  r.begin(own, w.q, w.v);
  r.step.fill(0);
  w.qdd = r.step.data();
  w.ground = kGround;
  kSolve[channel.rank()](w, channel);
  w.tau = no_torque.data();
  w.ground.setZero();
  for (int k = 0;; ++k) {
    collect_forces(w, own);
    exchange_step(w, channel);
    r.add(own);
    if (k > 0) {
      r.weigh(own);
      r.corrections[k - 1] = share_size(w, channel);
      require_convergence(w, k - 1);
    }
    if (k == kRefine) break;
    r.residual(own);
    kCorrect[channel.rank()](w, channel);
  }
  w.tau = tau;
  w.qdd = qdd;
  if (w.status != kFine) return;
  for (const int k : own.own) qdd[k] = static_cast<Real>(r.qdd[k]);
}
