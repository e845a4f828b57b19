// adagen's runtime, the same for all robots.
#pragma once
#if !defined(ADAGEN_SOLVER)
#define ADAGEN_SAMPLE_CUTS  // read alone, it is of a solver whose processes meet, and that refines
#endif

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

#include "../common.hpp"
#include "../constants.hpp"
#include "../sample/robot.hpp"
#include "../sizes.hpp"
#include "../spatial.hpp"
#include "../value.hpp"
#include "accelerate.hpp"
#include "algebra.hpp"
#include "carry.hpp"
#include "columns.hpp"
#include "guards.hpp"
#include "inward.hpp"
#include "lanes.hpp"
#include "links.hpp"
#include "loop_settings.hpp"
#include "memory.hpp"
#include "mobility.hpp"
#include "shuffles.hpp"
#include "strips.hpp"

#if defined(ADAGEN_SOLVER) && defined(__x86_64__) && !defined(__AVX512F__) && !defined(__clang__)
// g++ keeps vectors in memory that are wider than registers, clang++ takes several registers.
#pragma message("chain in parts: make CXX=clang++, or adagen MODEL --profile avx2, is faster here")
#endif

namespace {

// A long run of hinges that is parted (adagen/plan/parts.py), one part in each lane: a part is a
// strip (strips.hpp) without its first joint, by which it is joined to what is before it. So all
// parts are swept at once, and what each shows at both of its ends comes out lane by lane.

// The lanes whose strips have a joint in the last row.
template <class Run, std::size_t... lane>
constexpr LaneBits filled_lanes(std::index_sequence<lane...>) {
  return LaneBits{(Run::filled(static_cast<int>(lane), Run::kRows - 1) ? -1 : 0)...};
}

// Numbers that consist of lanes become zero in all lanes but some.
template <class T>
ADAGEN_INLINE void clear_others(const LaneBits& kept, T& numbers) {
  Lanes all[sizeof numbers / sizeof(Lanes)];
  std::memcpy(all, &numbers, sizeof all);
  for (Lanes& each : all) each = chosen(kept, each, Lanes{});
  std::memcpy(&numbers, all, sizeof all);
}

// The numbers of each lane, as they follow each other, are put where that lane's belong.
template <int begin = 0, std::size_t count, class To>
ADAGEN_INLINE void lay_out(const Lanes (&numbers)[count], const To& to) {
  ADAGEN_FOR (first, 0, (static_cast<int>(count) + 7) / 8) {
    const int left = static_cast<int>(count) - 8 * first, own = left < 8 ? left : 8;
    const Column none = eight<begin>(numbers[0]) - eight<begin>(numbers[0]);  // see set_up_columns
    Column square[8]{none, none, none, none, none, none, none, none};
    ADAGEN_FOR (k, 0, own) square[k] = eight<begin>(numbers[8 * first + k]);
    transpose(square);
    ADAGEN_FOR (k, 0, 8)
      std::memcpy(to(begin + k) + 8 * first, &square[k],
                  sizeof(Real) * static_cast<std::size_t>(own));
  }
  if constexpr (begin + 8 < kPerBlock) lay_out<begin + 8>(numbers, to);
}

// The torques of a row.
template <class Run, std::size_t... lane>
ADAGEN_INLINE Lanes torques(const Workspace& w, int row, std::index_sequence<lane...>) {
  return Lanes{torque(w, Run::joint(static_cast<int>(lane), row))...};
}

// Bodies beyond the joints that parts hang on by, each about its first link, without that.
template <class Run>
ADAGEN_NOINLINE Body<Lanes> inward_along_parts(Workspace& w) {
  constexpr int last = Run::kRows - 1;
  Body<Lanes> X{};
  const auto pass = [&w, &X](int row, const auto& arrive) ADAGEN_ALWAYS {
    const Joints<Lanes> joints = Run::row(row, 0);
    Eliminated<Lanes>& memory = w.memory(joints);
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    eliminate<false, false>(w, joints, X, axis, memory.r, torques<Run>(w, row, kEachLane), memory.e,
                            arrive);
  };
  const auto add_near = [&w](int row, Body<Lanes>& near)
                            ADAGEN_ALWAYS { add_bare_link(w, Run::row(row - 1, 0), near); };
  add_bare_link(w, Run::row(last, 0), X);
  pass(last, [](const Body<Lanes>&) {});
  if constexpr (Run::kLonger < kPerBlock) {  // slots that are not filled weigh, but hold no link
    constexpr LaneBits filled = filled_lanes<Run>(kEachLane);
    clear_others(filled, X);
    clear_others(filled, w.memory(Run::row(last, 0)).e);
  }
  add_near(last, X);
  for (int row = last - 1; row > 1; --row)
    pass(row, [&](Body<Lanes>& near) ADAGEN_ALWAYS { add_near(row, near); });
  pass(1, [](const Body<Lanes>&) {});
  return X;
}

// See UnitWrenches in carry.hpp: three of those on each part's last link, moments or forces.
struct ThreeWrenches {
  Vector<Lanes> n[3]{}, f[3]{};
};
template <class Run, int first>
ADAGEN_NOINLINE ThreeWrenches carry_along_parts(Workspace& w) {
  ThreeWrenches found;
  auto& [n, f] = found;
  auto& unit = first == 0 ? n : f;
  unit[0].x += 1, unit[1].y += 1, unit[2].z += 1;
  for (int row = Run::kRows - 1; row > 0; --row) {
    const Joints<Lanes> joints = Run::row(row, 0);
    const auto& [r, e] = w.memory(joints);
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    Lanes* const drives = &w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)][first];
    ADAGEN_FOR (k, 0, 3) {
      const Lanes x = dot(n[k], axis);
      drives[k] = x;
      n[k] += cross(r, f[k]);
      n[k].x -= e[0] * x, n[k].y -= e[1] * x, n[k].z -= e[2] * x;
      f[k].x -= e[3] * x, f[k].y -= e[4] * x, f[k].z -= e[5] * x;
    }
  }
  return found;
}

// What wrenches on the parts' last links find on their way, once it is known what they do to each
// joint: the mobility of the last links, row by row of its upper triangle, and how they move.
struct Yields {
  Lanes own[21]{}, free[6]{};
};
template <class Run>
ADAGEN_NOINLINE Yields yields_of_parts(Workspace& w) {
  Yields found;
  auto& [own, free] = found;
  for (int row = Run::kRows - 1; row > 0; --row) {
    const Joints<Lanes> joints = Run::row(row, 0);
    const Lanes* const e = w.memory(joints).e;
    const auto& drives = w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)];
    int at = 0;
    ADAGEN_FOR (i, 0, 6) {
      const Lanes by = drives[static_cast<std::size_t>(i)] * e[7];
      free[i] += drives[static_cast<std::size_t>(i)] * e[6];
      ADAGEN_FOR (k, i, 6) own[at++] += by * drives[static_cast<std::size_t>(k)];
    }
  }
  return found;
}

// What the sweep inwards of a run's parts finds: the bodies at the parts' first links, without the
// joints that these hang on, and how unit wrenches on the last ones arrive there; for each part L,
// by which its last link moves as the first one does.
struct SweptParts {
  Body<Lanes> bodies;
  ThreeWrenches moments, forces;
  std::array<Mat6, kPerBlock> moved;

  // A column of all L: what each wrench has become along one direction.
  ADAGEN_INLINE void column(int k, Lanes (&found)[6]) const {
    using V = Vector<Lanes>;
    constexpr Lanes V::* components[]{&V::x, &V::y, &V::z};
    ADAGEN_FOR (i, 0, 6) {
      const ThreeWrenches& own = i < 3 ? moments : forces;
      found[i] = (k < 3 ? own.n : own.f)[i % 3].*components[k % 3];
    }
  }
};
template <int first, int last>
ADAGEN_NOINLINE SweptParts inward_in_parts(Workspace& w) {
  using Run = Strips<first, last>;
  static_assert(sizeof(Value) == sizeof(Real));
  SweptParts swept;
  swept.bodies = inward_along_parts<Run>(w);
  add_bare_link(w, Run::row(0, 0), swept.bodies);
  swept.moments = carry_along_parts<Run, 0>(w), swept.forces = carry_along_parts<Run, 3>(w);
  ADAGEN_FOR (k, 0, 6) {
    Lanes column[6];
    swept.column(k, column);
    lay_out(column, [&swept, k](int lane) {
      return swept.moved[static_cast<std::size_t>(lane)].data() + 6 * k;
    });
  }
  return swept;
}

// See invert in mobility.hpp: the same of a body in each lane, Phi and b = -Phi p. What is returned
// is positive in lanes where each pivot exceeds what it must at least.
ADAGEN_INLINE Lanes invert(const Body<Lanes>& X, Lanes (&Phi)[6][6], Lanes (&b)[6]) {
  constexpr Real kRounding = 8 * std::numeric_limits<Real>::epsilon();
  const auto& [A, B, C, n, f] = X;
  Lanes m[6][6]{{A.xx},
                {A.xy, A.yy},
                {A.xz, A.yz, A.zz},
                {B.x.x, B.y.x, B.z.x, C.xx},
                {B.x.y, B.y.y, B.z.y, C.xy, C.yy},
                {B.x.z, B.y.z, B.z.z, C.xz, C.yz, C.zz}};
  const Lanes p[6]{n.x, n.y, n.z, f.x, f.y, f.z};
  Lanes over[6], least[6], L[6][6]{};
  LaneBits good = ~LaneBits{};
  ADAGEN_FOR (c, 0, 6) least[c] = m[c][c] * kRounding;
  ADAGEN_FOR (c, 0, 6) {
    good &= (m[c][c] > least[c]) & (m[c][c] <= std::numeric_limits<Real>::max());
    over[c] = 1 / m[c][c];
    ADAGEN_FOR (i, c + 1, 6) {
      const Lanes l = m[i][c] * over[c];
      ADAGEN_FOR (k, c + 1, i + 1) m[i][k] -= l * m[k][c];
      ADAGEN_FOR (k, 0, c) L[i][k] -= l * L[c][k];
      L[i][c] -= l;
    }
  }
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, i + 1) {
      Lanes sum = k == i ? over[i] : over[i] * L[i][k];
      ADAGEN_FOR (row, i + 1, 6) sum += L[row][i] * over[row] * L[row][k];
      Phi[i][k] = Phi[k][i] = sum;
    }
  ADAGEN_FOR (i, 0, 6) {
    b[i] = Lanes{};
    ADAGEN_FOR (k, 0, 6) b[i] -= Phi[i][k] * p[k];
  }
  return chosen(good, Lanes{} + 1, Lanes{} - 1);
}

// Where it is put what a part shows: Phi and b of its first link and of its last one, and Phi of
// the two; nothing is where nothing is joined to the last one.
struct ShownPart {
  Mat6* near;
  Columns6* near_bias;
  Mat6 *far, *across;
  Columns6* far_bias;
};
template <int first, int last>
ADAGEN_NOINLINE void show_parts(Workspace& w, const SweptParts& swept,
                                std::array<ShownPart, kPerBlock> shown) {
  using Run = Strips<first, last>;
  Mat6 nowhere;
  Columns6 no_bias;
  for (ShownPart& each : shown)
    if (each.far == nullptr) each.far = each.across = &nowhere, each.far_bias = &no_bias;
  const auto put = [&shown](auto place, int column, const Lanes(&numbers)[6]) ADAGEN_ALWAYS {
    lay_out(numbers, [&](int lane) ADAGEN_ALWAYS {
      return (shown[static_cast<std::size_t>(lane)].*place)->data() + 6 * column;
    });
  };
  Lanes Phi[6][6], b[6];
  const Lanes good = invert(swept.bodies, Phi, b);
  if (__builtin_expect(!all_positive(good), 0)) fail_one(w, Run::row(0, 0), good);
  ADAGEN_FOR (k, 0, 6) put(&ShownPart::near, k, Phi[k]);
  put(&ShownPart::near_bias, 0, b);

  const Yields yields = yields_of_parts<Run>(w);
  Lanes L[6][6], half[6][6];  // L by columns; L Phi by rows
  ADAGEN_FOR (k, 0, 6) swept.column(k, L[k]);
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, 0, 6) {
      half[i][k] = L[0][i] * Phi[0][k];
      ADAGEN_FOR (h, 1, 6) half[i][k] += L[h][i] * Phi[h][k];
    }
  ADAGEN_FOR (k, 0, 6) put(&ShownPart::across, k, half[k]);
  int at = 0;
  ADAGEN_FOR (i, 0, 6)
    ADAGEN_FOR (k, i, 6) {
      Lanes sum = yields.own[at++];
      ADAGEN_FOR (h, 0, 6) sum += half[i][h] * L[h][k];
      Phi[i][k] = Phi[k][i] = sum;
    }
  ADAGEN_FOR (k, 0, 6) put(&ShownPart::far, k, Phi[k]);
  Lanes far_bias[6];
  ADAGEN_FOR (i, 0, 6) {
    far_bias[i] = yields.free[i];
    ADAGEN_FOR (h, 0, 6) far_bias[i] += L[h][i] * b[h];
  }
  put(&ShownPart::far_bias, 0, far_bias);
}

// The parts' joints outwards. Each takes its part of the load of its part's last link: what unit
// wrenches there did to it. The first parts have such a load; the last one may have none.
template <int first, int last, int loaded>
ADAGEN_NOINLINE void accelerate_in_parts(Workspace& w) {
  using Run = Strips<first, last>;
  Motion<Lanes> a;
  Lanes load[6]{};
  ADAGEN_FOR (lane, 0, kPerBlock) {
    const Motion<Value>& own = w.motions[static_cast<std::size_t>(Run::joint(lane, 0) + 1)];
    a.angular.x[lane] = own.angular.x, a.angular.y[lane] = own.angular.y;
    a.angular.z[lane] = own.angular.z, a.linear.x[lane] = own.linear.x;
    a.linear.y[lane] = own.linear.y, a.linear.z[lane] = own.linear.z;
    if (lane < loaded) {
      const int link = Run::joint(lane, Run::kRows - 1) + 1;
      ADAGEN_FOR (k, 0, 6) load[k][lane] = w.loads[static_cast<std::size_t>(link)][k];
    }
  }
  const auto pass = [&](int row) ADAGEN_ALWAYS {
    const Joints<Lanes> joints = Run::row(row, 0);
    const auto& [r, e] = w.memory(joints);
    const auto& x = w.drives[static_cast<std::size_t>(joints.slot / kPerBlock)];
    const Vector<Lanes> axis = axis_at<Lanes>(w.at(joints.slot, kAxes));
    const Lanes driven = ((x[0] * load[0] + x[1] * load[1]) + (x[2] * load[2] + x[3] * load[3])) +
                         (x[4] * load[4] + x[5] * load[5]);
    const Lanes found = freedom(e, a) + e[7] * driven;
    carry(a, r);
    a.angular += axis * found;
    return found;
  };
  for (int row = 1; row + 1 < Run::kRows; ++row) answer(w, Run::row(row, 0), 0, pass(row));
  constexpr int final_row = Run::kRows - 1;
  const Lanes found = pass(final_row);
  ADAGEN_FOR (lane, 0, kPerBlock)
    if (Run::filled(lane, final_row))
      answer(w, single(Run::joint(lane, final_row)), 0, found[lane]);
}

}  // namespace
