// A correction: the ground does not accelerate.
inline void begin_answer(Workspace& w) { w.ground = ground(w); }
inline void begin_correction(Workspace& w, const RefinedProcess&) { w.ground.setZero(); }
