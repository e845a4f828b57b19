// adagen's runtime, the same for all robots.
// The functions of the C interface, under names that begin with the solver's: ADAGEN_CALL(solve) is
// NAME_pP_solve. NAME_pP.h declares them, and both are compared.
#pragma once

#include <cstddef>
#include <limits>

#include "constants.hpp"
#include "sample/interface.hpp"
#include "sample/parameters.hpp"
#include "sample/robot.hpp"
#include "sample/solver.hpp"
#include "status.hpp"

#if defined(ADAGEN_SOLVER) && !defined(ADAGEN_NO_HEADER)
static_assert(ADAGEN_NAMED(NQ) == kNq && ADAGEN_NAMED(NV) == kNv && ADAGEN_NAMED(NTAU) == kNtau);
static_assert(int(ADAGEN_NAMED(FINE)) == int(kFine));
static_assert(int(ADAGEN_NAMED(NOT_FINITE)) == int(kNotFinite));
static_assert(int(ADAGEN_NAMED(ZERO_QUATERNION)) == int(kZeroQuaternion));
static_assert(int(ADAGEN_NAMED(FACTORIZATION)) == int(kFactorization));
static_assert(int(ADAGEN_NAMED(OVERFLOW)) == int(kOverflow));
static_assert(int(ADAGEN_NAMED(NO_ANSWER)) == int(kNoAnswer));
static_assert(int(ADAGEN_NAMED(ENDED)) == int(kEnded));
static_assert(int(ADAGEN_NAMED(NOT_REFINED)) == int(kNotRefined));
static_assert(int(ADAGEN_NAMED(GIMBAL_LOCK)) == int(kGimbalLock));
static_assert(int(ADAGEN_NAMED(GROWTH)) == int(kGrowth));
static_assert(int(ADAGEN_NAMED(NOT_SET)) == int(kNotSet));
static_assert(int(ADAGEN_NAMED(TOO_FEW_STEPS)) == int(kTooFewSteps));
static_assert(int(ADAGEN_NAMED(LOOP_OPEN)) == int(kLoopOpen));
static_assert(int(ADAGEN_NAMED(LOOP_TORN)) == int(kLoopTorn));
static_assert(int(ADAGEN_NAMED(LOOP_SINGULAR)) == int(kLoopSingular));
static_assert(int(ADAGEN_NAMED(LOOP_FREE)) == int(kLoopFree));
#endif

// A type of its own for each solver, so that no other source can have another of its name.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wsubobject-linkage"
#endif
struct ADAGEN_CALL(solver) : Solver {};
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

namespace {

using Handle = ::ADAGEN_CALL(solver);

}  // namespace

extern "C" {

int ADAGEN_CALL(joint)(int k, const char** name, int* q, int* nq, int* v, int* nv) {
  if (k < 0 || k >= kJointCount) return 0;
  const JointConstants& joint = kJoints[static_cast<std::size_t>(k)];
  if (name != nullptr) *name = joint.name;
  if (q != nullptr) *q = joint.q;
  if (nq != nullptr) *nq = joint.nq;
  if (v != nullptr) *v = joint.v;
  if (nv != nullptr) *nv = joint.nv;
  return 1;
}

#if defined(ADAGEN_EMBEDDED)
static_assert(sizeof(Handle) + alignof(Handle) <= kBytes + 1);
Handle* ADAGEN_CALL(open)(void* memory, std::size_t size) {
  return opened<Handle>(memory, size, kBytes);
}
#elif defined(ADAGEN_THREADS)
Handle* ADAGEN_CALL(open_threads)(const int* cores, double time_limit) {
#if defined(ADAGEN_REPRODUCIBLE)
  if (refused()) return nullptr;
#endif
  return opened<Handle>(cores, time_limit);
}
#elif defined(ADAGEN_MPI)
Handle* ADAGEN_CALL(open)(MPI_Comm comm, const char* channel, double time_limit) {
#if defined(ADAGEN_REPRODUCIBLE)
  return opened<Handle>(comm, channel, time_limit, why_not_reproducible());
#else
  return opened<Handle>(comm, channel, time_limit, nullptr);
#endif
}
#else
Handle* ADAGEN_CALL(open)(void) {
#if defined(ADAGEN_REPRODUCIBLE)
  if (refused()) return nullptr;
#endif
  return opened<Handle>();
}
#endif

#if defined(ADAGEN_BATCH)
int ADAGEN_CALL(solve_batch)(Handle* solver, int count, const Number* q, const Number* v,
                             const Number* tau, Number* qdd) {
  return solver->solve_batch(count, q, v, tau, qdd);
}

int ADAGEN_CALL(failed_state)(Handle* solver, int k) { return solver->failed_state(k); }
#else
int ADAGEN_CALL(solve)(Handle* solver, const Number* q, const Number* v, const Number* tau,
                       Number* qdd) {
  return solver->solve(q, v, tau, qdd);
}
#endif

#if defined(ADAGEN_MPI)
#if defined(ADAGEN_BATCH)
int ADAGEN_CALL(solve_batch_at_root)(Handle* solver, int count, const Number* q, const Number* v,
                                     const Number* tau, Number* qdd) {
  return solver->solve_batch_at_root(count, q, v, tau, qdd);
}
#else
int ADAGEN_CALL(solve_at_root)(Handle* solver, const Number* q, const Number* v, const Number* tau,
                               Number* qdd) {
  return solver->solve_at_root(q, v, tau, qdd);
}
#endif

int ADAGEN_CALL(serve)(Handle* solver) { return solver->serve(); }

int ADAGEN_CALL(end)(Handle* solver) { return solver->end(); }
#endif

#if defined(ADAGEN_SETS_GRAVITY)
int ADAGEN_CALL(set_gravity)(Handle* solver, const Number* gravity) {
  return set_parameters(*solver, kGravityEntry, 3, gravity);
}
#endif

#if defined(ADAGEN_SETS_MASS)
int ADAGEN_CALL(set_mass)(Handle* solver, int link, Number mass) {
  return set_mass(*solver, link, mass);
}
#endif

#if defined(ADAGEN_SETS_CENTER)
int ADAGEN_CALL(set_center)(Handle* solver, int link, const Number* center) {
  return set_center(*solver, link, center);
}
#endif

#if defined(ADAGEN_CERTIFIED)
#if defined(ADAGEN_BATCH)
int ADAGEN_CALL(solve_batch_certified)(Handle* solver, int count, const Number* q, const Number* v,
                                       const Number* tau, Number* qdd, double* bounds) {
  return solver->solve_batch(count, q, v, tau, qdd, bounds);
}

#if defined(ADAGEN_MPI)
int ADAGEN_CALL(solve_batch_at_root_certified)(Handle* solver, int count, const Number* q,
                                               const Number* v, const Number* tau, Number* qdd,
                                               double* bounds) {
  return solver->solve_batch_at_root(count, q, v, tau, qdd, bounds);
}
#endif
#else
double ADAGEN_CALL(error_bound)(const Handle* solver) { return error_bound(solver->w); }
#endif
#endif

#if defined(ADAGEN_REFINES)
double ADAGEN_CALL(correction)(const Handle* solver, int k) {
  const Failure how = failure_kind(solver->w.status);
  const bool corrected = how == kFine || how == kNotRefined || how == kTooFewSteps;
  if (k < 0 || k >= kRefine || !corrected) return std::numeric_limits<double>::quiet_NaN();
  return solver->w.refinement.corrections[static_cast<std::size_t>(k)];
}
#endif

int ADAGEN_CALL(reason)(int status) { return failure_kind(status); }

int ADAGEN_CALL(failed_joint)(int status) {
  return is_of_joint(failure_kind(status)) ? failure_place(status) : -1;
}

const char* ADAGEN_CALL(failure)(const Handle* solver) {
#if defined(ADAGEN_EMBEDDED)
  return solver == nullptr ? kTooSmall : solver->text.c_str();
#else
  return solver == nullptr ? open_failure.c_str() : solver->text.c_str();
#endif
}

#if defined(ADAGEN_EMBEDDED)
void ADAGEN_CALL(close)(Handle*) {}
#else
void ADAGEN_CALL(close)(Handle* solver) {
  if (solver == nullptr) return;
  solver->close();
  delete solver;
}
#endif

}  // extern "C"
