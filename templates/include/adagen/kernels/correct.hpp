// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <cstddef>

#include "../refine.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "memory.hpp"

namespace {

// A correction: only the residuals of the equations of motion act on links.
inline void begin_answer(Workspace& w) {
  w.again = false;
  for (auto& f : w.refinement.f) f.setZero();
}
inline void begin_correction(Workspace& w, const RefinedProcess& own) {
  w.again = true;
  w.v = w.refinement.still.data();
  for (const int link : own.links) {
    const Vec6& rho = w.refinement.rho[static_cast<std::size_t>(link)];
    const Matrix<Value> R = matrix_at(w.of(link - 1, kAxes));
    put_at(w.of(link - 1, kTorque), -(R * Vector<Value>{rho[0], rho[1], rho[2]}));
    put_at(w.of(link - 1, kForce), -(R * Vector<Value>{rho[3], rho[4], rho[5]}));
  }
}

}  // namespace
