// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace adagen {
namespace {

// The numbers of a list such as 2-3,8 that a file holds; the first is -1 where there is none.
struct CoreList {
  int first = -1;
  std::vector<int> all;

  explicit CoreList(const std::string& file) {
    std::ifstream in(file);
    std::string part;
    while (std::getline(in, part, ',')) {
      std::istringstream range(part);
      int from = 0, to = 0;
      char dash = 0;
      if (!(range >> from)) break;
      if (!(range >> dash >> to)) to = from;
      for (int core = from; core <= to; ++core) all.push_back(core);
    }
    if (!all.empty()) first = all.front();
  }
};

// Cores in the order in which processes take them, so that processes that meet share caches: one
// hardware thread of each core before the second ones; then by package, third-level and
// second-level cache. As Linux describes them; in order of their numbers where it does not.
//
// folder: where the kernel describes the cores, cpu0, cpu1 ..
inline std::vector<int> in_order_of_caches(std::vector<int> cores,
                                           const std::string& folder = "/sys/devices/system/cpu") {
  using Place = std::array<int, 5>;
  std::vector<std::pair<Place, int>> places;
  for (const int core : cores) {
    const std::string own = folder + "/cpu" + std::to_string(core);
    const CoreList threads(own + "/topology/thread_siblings_list");
    const auto before = [&](int other) {
      return other < core && std::find(cores.begin(), cores.end(), other) != cores.end();
    };
    const auto second = std::count_if(threads.all.begin(), threads.all.end(), before);
    places.push_back(
        {{static_cast<int>(second), CoreList(own + "/topology/physical_package_id").first,
          CoreList(own + "/cache/index3/shared_cpu_list").first,
          CoreList(own + "/cache/index2/shared_cpu_list").first, core},
         core});
  }
  std::sort(places.begin(), places.end());
  for (std::size_t k = 0; k < cores.size(); ++k) cores[k] = places[k].second;
  return cores;
}

}  // namespace
}  // namespace adagen
