// adagen's runtime, the same for all robots.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <initializer_list>

#include "description.hpp"

namespace adagen {
namespace {

// Replaces the MPI calls of the program, for one process without MPI. The launcher's environment
// says how many were started, so that none of several goes on by itself.
using MPI_Comm = OneProcess;
using MPI_Datatype = std::size_t;  // its size
using MPI_Request = int;
struct MPI_Status {};
constexpr MPI_Comm MPI_COMM_WORLD{};
constexpr MPI_Datatype MPI_BYTE = 1, MPI_INT = sizeof(int), MPI_DOUBLE = sizeof(double),
                       MPI_LONG_LONG = sizeof(long long);
constexpr int MPI_MAX = 0, MPI_MIN = 0, MPI_SUM = 0, MPI_BOR = 0, MPI_COMM_TYPE_SHARED = 0,
              MPI_INFO_NULL = 0;
constexpr std::nullptr_t MPI_IN_PLACE = nullptr, MPI_STATUS_IGNORE = nullptr;

int of_launcher(std::initializer_list<const char*> names, int alone) {
  for (const char* const name : names)
    if (const char* const value = std::getenv(name))
      return static_cast<int>(std::strtol(value, nullptr, 10));
  return alone;
}

inline void MPI_Init(int*, char***) {}
inline void MPI_Finalize() {}
inline void MPI_Comm_rank(MPI_Comm, int* rank) {
  *rank = of_launcher({"OMPI_COMM_WORLD_RANK", "PMI_RANK"}, 0);
}
inline void MPI_Comm_size(MPI_Comm, int* size) {
  *size = of_launcher({"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}, 1);
}
inline void MPI_Comm_split_type(MPI_Comm, int, int, int, MPI_Comm*) {}
inline void MPI_Comm_free(MPI_Comm*) {}
[[noreturn]] inline void MPI_Abort(MPI_Comm, int status) { std::_Exit(status); }
inline void MPI_Ibarrier(MPI_Comm, MPI_Request*) {}
inline void MPI_Test(MPI_Request*, int* done, std::nullptr_t) { *done = 1; }
inline void MPI_Bcast(void*, int, MPI_Datatype, int, MPI_Comm) {}
inline void MPI_Allreduce(const void* from, void* to, int count, MPI_Datatype size, int, MPI_Comm) {
  if (from != nullptr) std::memcpy(to, from, static_cast<std::size_t>(count) * size);
}
inline void MPI_Reduce(const void*, void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Send(const void*, int, MPI_Datatype, int, int, MPI_Comm) {}
inline void MPI_Recv(void*, int, MPI_Datatype, int, int, MPI_Comm, std::nullptr_t) {}
inline void MPI_Probe(int, int, MPI_Comm, MPI_Status*) {}
inline void MPI_Get_count(const MPI_Status*, MPI_Datatype, int*) {}

}  // namespace
}  // namespace adagen
