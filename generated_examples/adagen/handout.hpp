// adagen's runtime, the same for all robots.
#pragma once

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "channel.hpp"
#include "sample/parameters.hpp"
#include "sample/robot.hpp"
#include "sample/workspace.hpp"
#include "sizes.hpp"
#include "status.hpp"

namespace {

// States of process 0, one after the other, and where their accelerations go, and bounds of their
// errors, a number for each state; null where these are not wanted.
struct Batch {
  int count;
  const Number *q, *v, *tau;
  Number* qdd;
  double* bounds;
};

// Process 0 hands pieces of a batch to the others as they finish earlier ones, and solves pieces in
// between itself: faster processes get more, wherever they are. A process has two pieces, so that
// one is on its way while the other is solved. A piece is one message, all q, then all v, then all
// tau, then what is set at run time; an empty one is the end. The answer is the accelerations, and
// their bounds behind them where the piece asks for these.
class Handout {
 public:
  // At process 0. Returns whether all states could be solved; that a process is gone joins the
  // status, and what it owes is not a number.
  template <class Solve>
  bool hand_out(Channel& channel, int helpers, const Batch& batch, const Workspace& w, Solve solve,
                int& status) {
    bool good = true;
    pack_parameters(parameters_.data(), w);
    int next = 0;
    const auto take = [&] {
      const int first = next;
      next += piece(batch.count - first);
      return first;
    };
    while (next < batch.count && status == kFine) {
      for (int p = 1; p <= helpers; ++p) {
        Helper& helper = helpers_[static_cast<std::size_t>(p - 1)];
        while (helper.busy > 0 && is_done(helper.oldest().answered, good)) helper.drop_oldest();
        while (helper.busy < 2 && next < batch.count) {
          const int first = take();
          give(channel, helper.add(), p, batch, first, next - first, status);
        }
      }
      const int first = take();
      if (first < next) good &= solve_in_place(batch, first, next - first, solve);
    }
    lose(batch, next, batch.count - next);
    for (int p = 1; p < kProcesses; ++p) {
      Helper& helper = helpers_[static_cast<std::size_t>(p - 1)];
      for (; helper.busy > 0; helper.drop_oldest()) {
        Given& oldest = helper.oldest();
        bool answered = false;
        channel.wait(oldest.answered, p, status, [&](const MPI_Status& s) {
          good &= s.MPI_TAG == kSolved;
          answered = true;
        });
        if (!answered) lose(batch, oldest.first, oldest.count);
      }
      for (Given& given : helper.given) {
        channel.wait(given.sent, p, status);
        MPI_Isend(nullptr, 0, kMpiNumber, p, kStates, channel.comm(), &given.sent);
      }
    }
    for (int p = 1; p < kProcesses; ++p)
      for (Given& given : helpers_[static_cast<std::size_t>(p - 1)].given)
        channel.wait(given.sent, p, status);
    return good;
  }

  // At process 0, where a process has been gone for long.
  static void lose_all(const Batch& batch) { lose(batch, 0, batch.count); }

  // At process 0: the others' help is over, and so is what they do it for.
  void end(Channel& channel, int& status) {
    Number nothing = 0;
    for (int p = 1; p < kProcesses; ++p)
      for (int k = 0; k < 2; ++k) {
        MPI_Request sent;
        MPI_Isend(&nothing, kEnd, kMpiNumber, p, kStates, channel.comm(), &sent);
        channel.wait(sent, p, status);
      }
  }

  // At the others, until process 0 has nothing more; patient: however long it takes. That process
  // 0 has ended it all joins the status.
  template <class Solve, class Take>
  void help(Channel& channel, Solve solve, Take take_parameters, int& status, bool patient) {
    for (Taken& piece : taken_) ask(channel, piece);
    int ends = 0;
    for (std::size_t k = 0; ends < 2 && status == kFine; k ^= 1) {
      Taken& piece = taken_[k];
      int numbers = 0;
      bool bounded = false;
      const auto note = [&](const MPI_Status& s) {
        MPI_Get_count(&s, kMpiNumber, &numbers);
        bounded = s.MPI_TAG == kBoundedStates;
      };
      channel.wait(piece.asked, 0, status, note, patient);
      channel.wait(piece.answered, 0, status);
      if (numbers <= kEnd) {
        if (numbers == kEnd && ++ends == 2) Channel::fail(status, failure(kEnded, 0));
        if (numbers == 0) ++ends;
        continue;
      }
      const int count = (numbers - kParameterCount) / kNumbers;
      const Number* const v = piece.states.data() + count * kNq;
      take_parameters(piece.states.data() + count * kNumbers);
      double* const bounds = bounded ? piece.bounds.data() : nullptr;
      const bool good =
          solve(count, piece.states.data(), v, v + count * kNv, piece.qdd.data(), bounds);
      answers(piece.qdd.data(), bounds, count, [&](void* at, int length, MPI_Datatype type) {
        MPI_Isend(at, length, type, 0, good ? kSolved : kFailed, channel.comm(), &piece.answered);
      });
      ask(channel, piece);
    }
  }

 private:
  static constexpr int kNumbers = kNq + kNv + kNtau;  // of a state
  // What a message is: states, whose bounds are wanted or not, or answers.
  static constexpr int kStates = 0, kBoundedStates = 1, kSolved = 2, kFailed = 3;
  static constexpr int kEnd = 1;  // numbers in one that ends it all
  // States that fill the widest registers there are, and narrower ones: processes on other machines
  // may have others.
  static constexpr int kFull = 64 / static_cast<int>(sizeof(Number));
  // Most states of a piece: about 64 kB, which take less time to send than to solve.
  static constexpr int kMost =
      std::max(1, (1 << 16) / (kNumbers * static_cast<int>(sizeof(Number)) * kFull)) * kFull;

  // A piece at process 0, which another solves, and at that one.
  struct Given {
    MPI_Request sent = MPI_REQUEST_NULL, answered = MPI_REQUEST_NULL;
    int first = 0, count = 0;
  };
  struct Taken {
    std::array<Number, static_cast<std::size_t>(kMost) * kNumbers + kParameterCount> states;
    std::array<Number, static_cast<std::size_t>(kMost) * kNqdd> qdd;
    std::array<double, kCertified ? kMost : 0> bounds;
    MPI_Request asked = MPI_REQUEST_NULL, answered = MPI_REQUEST_NULL;
  };

  struct Helper {
    std::array<Given, 2> given;
    std::size_t next = 0;
    int busy = 0;
    Given& oldest() { return given[busy == 2 ? next : next ^ 1]; }
    void drop_oldest() { --busy; }
    Given& add() {
      ++busy;
      next ^= 1;
      return given[next ^ 1];
    }
  };

  // Pieces shrink towards the end, so that all are done at about the same time; but for the last,
  // they fill all lanes.
  static int piece(int left) {
    const int share = left / (4 * kProcesses) / kFull * kFull;
    return std::min(left, std::clamp(share, kFull, kMost));
  }

  static bool is_done(MPI_Request& answered, bool& good) {
    int done = 0;
    MPI_Status status;
    MPI_Test(&answered, &done, &status);
    if (done != 0) good &= status.MPI_TAG == kSolved;
    return done != 0;
  }

  void give(Channel& channel, Given& given, int p, const Batch& batch, int first, int count,
            int& status) {
    const long row = first;
    given.first = first, given.count = count;
    channel.wait(given.sent, p, status);
    as_one<4>({{{batch.q + row * kNq, count * kNq, kMpiNumber},
                {batch.v + row * kNv, count * kNv, kMpiNumber},
                {batch.tau + row * kNtau, count * kNtau, kMpiNumber},
                {parameters_.data(), kParameterCount, kMpiNumber}}},
              [&](void* at, int length, MPI_Datatype type) {
                const int what = batch.bounds == nullptr ? kStates : kBoundedStates;
                MPI_Isend(at, length, type, p, what, channel.comm(), &given.sent);
              });
    answers(batch.qdd + row * kNqdd, bounds_from(batch, row), count,
            [&](void* at, int length, MPI_Datatype type) {
              MPI_Irecv(at, length, type, p, MPI_ANY_TAG, channel.comm(), &given.answered);
            });
  }

  // Numbers of one type that are part of a message.
  struct Part {
    const void* at;
    int length;
    MPI_Datatype type;
  };

  // Posts parts that lie apart as one message.
  template <std::size_t N, class Post>
  static void as_one(const std::array<Part, N>& parts, Post post) {
    std::array<int, N> lengths;
    std::array<MPI_Aint, N> places;
    std::array<MPI_Datatype, N> types;
    for (std::size_t k = 0; k < N; ++k) {
      lengths[k] = parts[k].length, types[k] = parts[k].type;
      MPI_Get_address(parts[k].at, &places[k]);
    }
    MPI_Datatype rows;
    MPI_Type_create_struct(N, lengths.data(), places.data(), types.data(), &rows);
    MPI_Type_commit(&rows);
    post(MPI_BOTTOM, 1, rows);
    MPI_Type_free(&rows);
  }

  // Posts the answers to a piece, bounds among them unless they are null.
  template <class Post>
  static void answers(Number* qdd, double* bounds, int count, Post post) {
    if (bounds == nullptr)
      post(qdd, count * kNqdd, kMpiNumber);
    else
      as_one<2>({{{qdd, count * kNqdd, kMpiNumber}, {bounds, count, MPI_DOUBLE}}}, post);
  }

  static double* bounds_from(const Batch& batch, long row) {
    return batch.bounds == nullptr ? nullptr : batch.bounds + row;
  }

  // Accelerations that nobody has found: what was there before is no answer.
  static void lose(const Batch& batch, int first, int count) {
    const long row = first;
    std::fill_n(batch.qdd + row * kNqdd, static_cast<long>(std::max(0, count)) * kNqdd,
                std::numeric_limits<Number>::quiet_NaN());
  }

  template <class Solve>
  static bool solve_in_place(const Batch& batch, int first, int count, Solve solve) {
    const long row = first;
    return solve(count, batch.q + row * kNq, batch.v + row * kNv, batch.tau + row * kNtau,
                 batch.qdd + row * kNqdd, bounds_from(batch, row));
  }

  static void ask(Channel& channel, Taken& piece) {
    MPI_Irecv(piece.states.data(), static_cast<int>(piece.states.size()), kMpiNumber, 0,
              MPI_ANY_TAG, channel.comm(), &piece.asked);
  }

  std::array<Number, kParameterCount> parameters_{};
  std::array<Helper, kProcesses> helpers_;
  std::array<Taken, 2> taken_;
};

}  // namespace
