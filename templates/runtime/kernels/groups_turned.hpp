// See inward_group in groups.hpp: the same where limbs have turned joints. What is handed to the
// trunk is in axes of the base.
template <int p, const auto& limbs>
auto inward_group_turned(Workspace& w) {
  using T = typename std::decay_t<decltype(limbs)>::T;
  Body<T> X{};
  each_row<LimbRows<limbs>, true>([&](int k, auto kind) ADAGEN_ALWAYS {
    meet_group<p>(w, limbs.at(k), X);
    if constexpr (kRefine > 0)
      keep_turned(w, limbs.at(k), turned(limbs.at(k).joint[0]) ? limbs.at(k).slot : -1, X);
    const bool own = k > 0 && turned(limbs.at(k - 1).joint[0]);
    step_turned<false>(w, limbs.at(k), kind, own ? limbs.at(k - 1).slot : -1, X);
  });
  return X;
}
