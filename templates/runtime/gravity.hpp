inline double gravity(const Workspace&, int k) { return kGravity[static_cast<std::size_t>(k)]; }
