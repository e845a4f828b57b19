// Nothing tells the time.
[[maybe_unused]] inline void stamp(int) {}
