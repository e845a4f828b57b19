// What straight lines of lanes need.
ADAGEN_INLINE bool all(const LaneBits& good) {
  Bits result = -1;
  for (int k = 0; k < kLanes; ++k) result &= good[k];
  return result != 0;
}
ADAGEN_INLINE bool all(const LaneBits& good, const LaneBits& also) { return all(good & also); }

template <int count>
inline void take_sines_and_cosines(const Lanes* angle, Lanes* sine, Lanes* cosine) {
  for (int k = 0; k < count; ++k) sine_and_cosine(angle[k], sine[k], cosine[k]);
}
