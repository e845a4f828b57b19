"""From C++ to an executable: the compiler, MPI and Eigen to use, and a cache of what was built."""

from adagen.build.cache import build_executable, cache_folder
from adagen.build.toolchain import Toolchain, find_toolchain, mpi_environment

__all__ = ["Toolchain", "build_executable", "cache_folder", "find_toolchain", "mpi_environment"]
