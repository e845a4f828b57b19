// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

#include "corrections.hpp"
#include "inverse_dynamics.hpp"
#include "json.hpp"
#include "loops.hpp"
#include "program_setting.hpp"
#include "slave.hpp"
#include "states.hpp"
#include "unreal.hpp"

namespace adagen {
namespace {

// What --check says of the answers: are they those of a robot that differs from the given one by
// rounding errors, and how much do such errors matter?
//
// The backward error of an answer is what is left over of a row of the equation of motion, relative
// to the size of all that is added up in that row, the largest of all rows: by so much the robot's
// constants and the state would have to change for the answer to be exact. A solver that is right
// keeps it small on every robot. What it means for an acceleration is up to the joint-space inertia
// H: what is left over moves the accelerations by H^-1 of it, which the solver itself tells if that
// is added to the torques. What can be known at all is seen from states that differ from the given
// one in their last digits.
class Verdict {
 public:
  static constexpr int kProbes = 4;  // by what is left over; then three times by last digits

  void listen(int rank, const States& states) {
    if (rank > 0) return;
    states_ = states;
    findings_.resize(static_cast<std::size_t>(states.count));
  }

  // All of what follows is process 0's.
  void note_answer(int s, const Number* qdd) {
    Finding& finding = at(s);
    std::vector<Number> all(qdd, qdd + about.nv);
    check::complete(q(s), v(s), tau(s), all);
    finding.qdd.assign(all.begin(), all.end());
    finding.left = check::left_over(q(s), v(s), tau(s), all.data());
    if (loops::any()) loops::account(q(s), v(s), all.data(), finding.left);
    for (int j = 0; j < about.joints.count; ++j) {
      const double slip = check::slip(about.joints[j], tau(s), all.data());
      if (!(slip <= finding.left.backward)) finding.left.backward = slip, finding.left.joint = j;
    }
    finding.error.assign(finding.qdd.size(), 0);
    finding.known.assign(finding.qdd.size(), 0);
  }

  // The states of a probe.
  States states_of(int probe) const {
    States states = states_;
    std::uint64_t seed = static_cast<std::uint64_t>(probe);
    for (int s = 0; s < states.count; ++s) {
      Number* const own_q = states.q.data() + static_cast<long>(s) * about.nq;
      Number* const own_v = states.v.data() + static_cast<long>(s) * about.nv;
      Number* const own_tau = states.tau.data() + static_cast<long>(s) * about.ntau;
      if (probe == 0)
        push(at(s), own_tau);
      else
        touch(seed, own_q, own_v, own_tau);
    }
    return states;
  }

  // probed: the states of the probe.
  void note_response(int probe, int s, const States& probed, const Number* qdd) {
    Finding& finding = at(s);
    if (probe == 0) finding.response = response_error(s, probed, qdd);
    const double step = probe == 0 ? scale(finding) / kPush : 1 / kTouch;
    const std::vector<bool> given = check::given();
    for (std::size_t k = 0; k < finding.qdd.size(); ++k) {
      if (!given[k]) continue;
      const double moved = (double(qdd[k]) - finding.qdd[k]) * step;
      if (probe == 0)
        finding.error[k] = std::abs(moved);
      else if (!(std::abs(moved) <= finding.known[k]))
        finding.known[k] = std::abs(moved);
    }
    finding.probed = probe + 1;
  }

  // Whether the solver is right.
  bool judge(double tolerance) {
    tolerance_ = tolerance;
    for (int s = 0; s < states_.count; ++s) {
      const Finding& finding = at(s);
      residuals_.push_back(finding.left.residual);
      backward_.push_back(finding.left.backward);
      const bool small = finding.left.backward <= tolerance, right = small || allowed(finding);
      if (s == 0 || (right_ && !right) ||
          (right_ == right && !(finding.left.backward <= at(off_).left.backward)))
        off_ = s;
      right_ = right_ && right, excused_ = excused_ || (right && !small);
      if (finding.probed < kProbes) continue;
      const Unsure own = least_known(finding);
      if (!probed_ || !(own.part <= unsure_.part)) unsure_ = own, unsure_state_ = s;
      probed_ = true;
    }
    std::sort(residuals_.begin(), residuals_.end());
    std::sort(backward_.begin(), backward_.end());
    if (!right_)
      fault_ = "solver";
    else if (excused_ || (probed_ && !(unsure_.part <= kUnsure)))
      fault_ = digits() < kNone && check::unreal_link() > 0 ? "model" : "conditioning";
    return right_;
  }

  // What is wrong with the model when a solver refuses; empty if all links are physical.
  static std::string of_model() {
    return check::unreal_link() > 0 ? "; the model is at fault: " + check::unreal() : "";
  }

  void print(std::FILE* out) const {
    if (backward_.empty()) return;
    std::fprintf(out, "check  backward error: median %.1e, largest %.1e of %.0e: %s\n",
                 middle(backward_), backward_.back(), tolerance_, right_ ? "right" : "WRONG");
    const std::string where =
        "state " + std::to_string(state() + 1) + ", joint " + quoted(about.joints[joint()].name);
    if (!right_)
      std::fprintf(out, "check  the solver is at fault: %s\n", where.c_str());
    else if (probed_)
      std::fprintf(out, "check  %.1f digits of the accelerations are certain: %s\n", digits(),
                   where.c_str());
    if (right_ && excused_)
      std::fprintf(out,
                   "check  warning: the backward error exceeds its tolerance, but the last digits "
                   "of the state move the accelerations as much\n");
    else if (fault_ == "conditioning")
      std::fprintf(out,
                   "check  warning: the robot is ill-conditioned there: the last digits of its "
                   "constants and its state decide all others; another shape, or --refine, may "
                   "keep some more\n");
    if (fault_ == "model")
      std::fprintf(out, "check  warning: the model is at fault: %s\n", check::unreal().c_str());
  }

  // As a member of a JSON object, a comma before it.
  std::string json() const {
    if (backward_.empty()) return "";
    const std::string known = probed_ ? figure(unsure_.part) : "null";
    return ", \"check\": {\"residual_median\": " + figure(middle(residuals_)) +
           ", \"residual_max\": " + figure(residuals_.back()) +
           ", \"backward_error_median\": " + figure(middle(backward_)) +
           ", \"backward_error_max\": " + figure(backward_.back()) +
           ", \"tolerance\": " + figure(tolerance_) + ", \"forward_error\": " + known +
           ", \"digits\": " + (probed_ ? figure(digits()) : "null") +
           ", \"state\": " + std::to_string(state() + 1) +
           ", \"joint\": " + quoted(about.joints[joint()].name) +
           ", \"fault\": " + (fault_.empty() ? "null" : quoted(fault_.c_str())) +
           ", \"ok\": " + (right_ ? "true" : "false") + "}";
  }

 private:
  static constexpr double kPush = 1024;  // its effect on the answer is known to three digits
  static constexpr double kTouch = 64;   // units of rounding: the solver's own are small beside it
  static constexpr double kRounding = std::numeric_limits<Number>::epsilon() / 2;
  // Warns where fewer than six digits (float: two) are certain.
  static constexpr double kUnsure = sizeof(Number) == sizeof(double) ? 1e-6 : 1e-2;
  static constexpr double kNone = 0.5;  // fewer digits are none
  // An answer whose backward error is too large may be as far off as this many units of rounding of
  // the state move it; a solver's own noise looks like 1/32 of its error (two answers, kTouch). Its
  // answer to the push is exact to this part, so that the error is known.
  static constexpr double kAllowed = 8, kAnswered = 1e-3;

  struct Finding {
    check::Left left;
    std::vector<double> qdd, error, known;  // answer, how far it is off, how far it may be
    double response = 0;                    // backward error of the answer to the push
    int probed = 0;
  };

  struct Unsure {
    double part = 0;  // of the largest acceleration of the state
    int joint = 0;
  };

  Finding& at(int s) { return findings_[static_cast<std::size_t>(s)]; }
  const Finding& at(int s) const { return findings_[static_cast<std::size_t>(s)]; }
  const Number* q(int s) const { return states_.q.data() + static_cast<long>(s) * about.nq; }
  const Number* v(int s) const { return states_.v.data() + static_cast<long>(s) * about.nv; }
  const Number* tau(int s) const { return states_.tau.data() + static_cast<long>(s) * about.ntau; }

  static double scale(const Finding& finding) {
    return std::max<double>(finding.left.backward, std::numeric_limits<Number>::min());
  }

  // The residual for changed torques, with the answer to them.
  double response_error(int s, const States& pushed, const Number* qdd) const {
    const Number* const its_tau = pushed.tau.data() + static_cast<long>(s) * about.ntau;
    std::vector<Number> all(qdd, qdd + about.nv);
    check::complete(q(s), v(s), its_tau, all);
    check::Left left = check::left_over(q(s), v(s), its_tau, all.data());
    if (loops::any()) loops::account(q(s), v(s), all.data(), left);
    return left.backward;
  }

  // Whether the answer is as good as the state's own rounding lets any answer be.
  static bool allowed(const Finding& finding) {
    if (finding.probed < kProbes || !(finding.response <= kAnswered)) return false;
    const double off = least_known(finding, &Finding::error).part;
    return off <= kAllowed * least_known(finding, &Finding::known).part;
  }

  // Adds the residual, magnified, to the torques.
  static void push(const Finding& finding, Number* tau) {
    for (const Joint& joint : about.joints) {
      if (joint.prescribed || joint.source >= 0) continue;
      for (int k = joint.v; k < joint.v + joint.nv; ++k) {
        const double over = double(finding.left.over[static_cast<std::size_t>(k)]);
        tau[k] = static_cast<Number>(double(tau[k]) + kPush * (over / scale(finding)));
      }
    }
  }

  // Changes the last digits of a state; of angles and orientations those of 1.
  static void touch(std::uint64_t& seed, Number* q, Number* v, Number* tau) {
    const auto change = [&seed](Number& x, double size) {
      seed = seed * 6364136223846793005ULL + 1442695040888963407ULL;
      const double by = ((seed >> 63) != 0 ? kTouch : -kTouch) * kRounding;
      x = static_cast<Number>(double(x) + by * std::max(size, std::abs(double(x))));
    };
    for (const Joint& joint : about.joints) {
      const int angles = turns(joint, 0) ? 0 : joint.nq == 7 ? 3 : joint.nq == 3 ? 2 : joint.nq;
      for (int k = 0; k < joint.nq; ++k) change(q[joint.q + k], k < angles ? 0 : 1);
      for (int k = joint.v; k < joint.v + joint.nv; ++k) change(v[k], 0), change(tau[k], 0);
    }
    for (int k = about.nv; k < about.ntau; ++k) change(tau[k], 0);
    slave(about.joints, q, v);
  }

  // Whether entry k of a joint's motion is an angle's.
  static bool turns(const Joint& joint, int k) {
    switch (joint.kind) {
      case JointKind::kPrismatic:
        return false;
      case JointKind::kPlanar:
        return k == 2;
      case JointKind::kFloating:
        return k >= 3;
      default:
        return true;
    }
  }

  // The joint whose acceleration is least sure, beside the largest one of its unit.
  static Unsure least_known(const Finding& finding) {
    const Unsure off = least_known(finding, &Finding::error);
    const Unsure known = least_known(finding, &Finding::known);
    return known.part <= off.part ? off : known;
  }

  // The same by one of both reasons.
  static Unsure least_known(const Finding& finding, std::vector<double> Finding::* reason) {
    std::array<double, 2> largest{};
    for (int j = 0; j < about.joints.count; ++j)
      for (int k = 0; k < about.joints[j].nv; ++k) {
        double& most = largest[turns(about.joints[j], k)];
        most =
            std::max(most, std::abs(finding.qdd[static_cast<std::size_t>(about.joints[j].v + k)]));
      }
    // What is nothing beside the others, as turns are in free fall, has no digits to lose.
    const double least = 1e-6 * std::max(largest[0], largest[1]);
    Unsure found;
    for (int j = 0; j < about.joints.count; ++j)
      for (int k = 0; k < about.joints[j].nv; ++k) {
        const double own = (finding.*reason)[static_cast<std::size_t>(about.joints[j].v + k)];
        const double part = own / std::max(largest[turns(about.joints[j], k)], least);
        if (own > 0 && !(part <= found.part)) found = {part, j};
      }
    return found;
  }

  // The joint whose acceleration is farther off than anything else explains.
  static int spoilt(const Finding& finding) {
    int found = finding.left.joint;
    double most = 0;
    for (int j = 0; j < about.joints.count && finding.probed == kProbes; ++j) {
      const Joint& joint = about.joints[j];
      for (int k = joint.v; k < joint.v + joint.nv; ++k) {
        const std::size_t i = static_cast<std::size_t>(k);
        const double part = finding.error[i] / finding.known[i];
        if (part > most) most = part, found = j;
      }
    }
    return found;
  }

  static double middle(const std::vector<double>& sorted) { return sorted[sorted.size() / 2]; }

  double digits() const { return std::max(0.0, -std::log10(unsure_.part)); }
  int state() const { return right_ && probed_ ? unsure_state_ : off_; }
  int joint() const { return right_ && probed_ ? unsure_.joint : spoilt(at(off_)); }

  States states_;
  std::vector<Finding> findings_;
  std::vector<double> residuals_, backward_;  // of all states, ascending
  double tolerance_ = 0;
  bool right_ = true, probed_ = false;
  bool excused_ = false;  // some backward error is too large, and conditioning explains it
  int off_ = 0, unsure_state_ = 0;
  Unsure unsure_;
  std::string fault_;  // "" for none
};

}  // namespace
}  // namespace adagen
