// adagen's runtime, the same for all robots.
#pragma once

#include <array>
#include <cstddef>
#include <type_traits>

#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../value.hpp"
#include "algebra.hpp"
#include "blocks.hpp"
#include "columns.hpp"
#include "inward.hpp"
#include "inward_columns.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "outward.hpp"
#include "strips.hpp"

namespace {

// A run that is longer than what the second-level cache holds, tile by tile: the first pass finds
// where the strips of each tile start from and keeps nothing else, the second one, from the last
// tile on, passes a tile outwards and sweeps it inwards. All tiles take the same blocks of memory
// in turn.

// Joints first .. last, the last tile being shorter.
template <int first, int last>
struct Tiles {
  static constexpr int kCount = (last - first + kTile) / kTile;
  static constexpr int kEnd = first + kTile - 1, kLastFirst = first + (kCount - 1) * kTile;
  static_assert(kTile % kPerBlock == 0 && slot_of(first) == 0 && kCount > 1);

  // Calls todo for a tile: with the joints of one that is alike, and how many lie before it.
  template <class ToDo>
  ADAGEN_INLINE static void at(int tile, const ToDo& todo) {
    if (tile + 1 < kCount)
      todo(std::integral_constant<int, first>{}, std::integral_constant<int, kEnd>{}, tile * kTile);
    else
      todo(std::integral_constant<int, kLastFirst>{}, std::integral_constant<int, last>{}, 0);
  }
};

// Angles and turns of a tile.
template <int first, int last>
ADAGEN_NOINLINE void turn_tile(Workspace& w, int beyond) {
  using Run = Strips<first, last>;
  take_angles_in_strips<first, last>(w, beyond);
  turn<Run::kPlace, Run::kPlace + Run::kRows>(w, Run::kBlock - Run::kPlace + beyond / kPerBlock);
}

// How the links move that the strips of each tile start from.
template <int first, int last>
using Starts = std::array<Frame<Lanes>, Tiles<first, last>::kCount>;

template <int first, int last>
ADAGEN_NOINLINE void pass_tiles(Workspace& w, Starts<first, last>& starts) {
  using All = Tiles<first, last>;
  Frame<Value> at = frame_near<first>(w);
  for (int tile = 0; tile < All::kCount; ++tile)
    All::at(tile, [&](auto begin, auto end, int beyond) ADAGEN_ALWAYS {
      turn_tile<begin, end>(w, beyond);
      starts[static_cast<std::size_t>(tile)] = starts_of_strips<Strips<begin, end>>(w, beyond, at);
    });
}

// Outwards along a tile, and its links.
template <int first, int last>
ADAGEN_NOINLINE void outward_tile(Workspace& w, int beyond, const Frame<Lanes>& starts) {
  using Run = Strips<first, last>;
  constexpr int begin = Run::kPlace, end = begin + Run::kRows;
  const int before = Run::kBlock - Run::kPlace + beyond / kPerBlock;
  along_strips<Run>(w, beyond, starts);
  set_up_links<begin, end>(w, before);
  if constexpr (kInColumns) set_up_columns<begin, end>(w, before);
}

// Inward sweep of a tile: by columns where registers hold them. A body is carried along, with the
// part still to be subtracted.
struct Carried {
  Columns X;
  Due due;
};
template <int first, int last>
ADAGEN_NOINLINE void inward_tile(Workspace& w, int beyond, Carried& at) {
  Carried own = at;
  add_bare_link(w, last + 1 + beyond, own.X);
  for (int j = last + beyond; j >= first + beyond; --j)
    eliminate<false, false>(w, j, own.X, own.due, [&](Columns& near) ADAGEN_ALWAYS {
      if (j > first + beyond) add_bare_link(w, j, near);
    });
  at = own;
}
template <int first, int last>
ADAGEN_NOINLINE void inward_tile(Workspace& w, int beyond, Body<Value>& X) {
  for (int j = last + beyond; j >= first + beyond; --j) {
    add_bare_link(w, single(j), X);
    step_inward<false>(w, single(j), JointKind::kRevolute, X, [](const Body<Value>&) {});
  }
}

// Both sweeps of joints first .. last, all hinges, which hang on the ground by themselves.
template <int first, int last>
void sweep_tiles(Workspace& w, const Starts<first, last>& starts) {
  using All = Tiles<first, last>;
  std::conditional_t<kInColumns, Carried, Body<Value>> X{};
  for (int tile = All::kCount - 1; tile >= 0; --tile)
    All::at(tile, [&](auto begin, auto end, int beyond) ADAGEN_ALWAYS {
      turn_tile<begin, end>(w, beyond);
      outward_tile<begin, end>(w, beyond, starts[static_cast<std::size_t>(tile)]);
      inward_tile<begin, end>(w, beyond, X);
    });
}

}  // namespace
