[[maybe_unused]] inline void apply_parameters(Workspace&) {}
