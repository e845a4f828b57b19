// adagen's runtime, the same for all robots.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "arithmetic.hpp"
#include "main.hpp"
#include "options.hpp"
#include "program_setting.hpp"

namespace adagen {

// Compiled for size, and with it what it alone calls: it runs once.
template <>
[[gnu::cold]] int program<ADAGEN_VERSION>(const Description<Number>& description,
                                          AnySolver<Number, MPI_Comm>& solver, int count,
                                          char** words) {
  about = description;
  Options options;
  const std::string wrong = parse(count, words, options);
  Watch().start_of_mpi(options.time_limit);
  MPI_Init(&count, &words);
  int rank = 0, size = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  int status = kDone;
  const std::string launch = "mpiexec -n " + std::to_string(about.processes);
  if (!wrong.empty() || (size != about.processes && !options.help)) {
    status = kUsage;
    if (rank == 0 && !wrong.empty())
      std::fprintf(stderr, "error: %s; see --help\n", wrong.c_str());
    else if (rank == 0)
      std::fprintf(stderr, "error: this solver is for exactly %d process%s, started with %d: %s\n",
                   about.processes, about.processes > 1 ? "es" : "", size,
                   about.processes > 1 ? ("use " + launch).c_str() : "start it without mpiexec");
  } else if (options.help) {
    if (rank == 0)
      std::printf("usage: %s%s [options]\n%s", about.processes > 1 ? (launch + " ").c_str() : "",
                  words[0], kUsageText);
  } else {
    status = std::make_unique<Program>(options, solver, rank)->run();
  }
  MPI_Finalize();
  return status;
}

}  // namespace adagen
