inline Number gravity(const Workspace& w, int k) {
  return w.parameters[static_cast<std::size_t>(kGravityEntry + k)];
}
