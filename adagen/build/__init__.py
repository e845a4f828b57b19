"""From C++ to an executable: compiler, MPI and Eigen, and a cache of executables."""

from adagen.build.cache import build_executable, cache_folder
from adagen.build.toolchain import Toolchain, find_toolchain, mpi_environment

__all__ = ["Toolchain", "build_executable", "cache_folder", "find_toolchain", "mpi_environment"]
