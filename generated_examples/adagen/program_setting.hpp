// adagen's runtime, the same for all robots.
#pragma once

#if defined(ADAGEN_MPI)
#include <mpi.h>
#endif

#include <cstddef>
#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <sys/time.h>
#include <unistd.h>

#include <csignal>
#endif

#include "common.hpp"
#include "description.hpp"
#if !defined(ADAGEN_MPI)
#include "one_process.hpp"
#endif

#define ADAGEN_HOT [[gnu::hot]] ADAGEN_NOINLINE  // called in each step of a simulation

namespace adagen {
namespace {

#if defined(ADAGEN_FLOAT)
using Number = float;
#else
using Number = double;
#endif

#if defined(ADAGEN_MPI)
const MPI_Datatype kMpiNumber = sizeof(Number) == sizeof(double) ? MPI_DOUBLE : MPI_FLOAT;
#else
constexpr MPI_Datatype kMpiNumber = sizeof(Number);
#endif

using Joint = adagen::Joint<Number>;
using Link = adagen::Link<Number>;
using OuterForce = adagen::OuterForce<Number>;
using Loop = adagen::Loop<Number>;
using Coupling = adagen::Coupling<Number>;
using Solver = AnySolver<Number, MPI_Comm>;

constexpr int kRandomStates = 64;

[[maybe_unused]] Description<Number> about;  // the solver, as its main has it

}  // namespace
}  // namespace adagen
