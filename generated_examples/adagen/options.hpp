// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>

#include "integrators.hpp"
#include "program_setting.hpp"
#include "trajectory.hpp"

namespace adagen {
namespace {

struct SimulationOptions {
  double seconds = 0, step = 1e-3;  // no simulation where seconds are 0
  const IntegratorInfo* integrator = &kIntegrators[3];
  long long every = 1;  // steps between the rows of the trajectory
  std::string trajectory;
};

// The options of the program.
struct Options {
  std::string states, result, trace;
  bool check = false, time = false, stretches = false, json = false, help = false, pin = true;
  int repeat = 200;
  std::uint64_t seed = 1;
  double time_limit = 30, tolerance = about.tolerance;
  std::string channel = about.channel;
  int hosts = 0;  // as many as there are
  SimulationOptions simulation;
};

enum ExitStatus : int { kDone = 0, kInputAtFault = 1, kUsage = 2, kFault = 3 };

const char* const kUsageText =
    "  --states FILE     solve the states in this file (JSON, joints by name); - is\n"
    "                    standard input (of one process)\n"
    "  --result FILE     where to write accelerations (default: standard output)\n"
    "  --check           check the answers to the given or random states: backward\n"
    "                    error by an independent inverse dynamics; right digits\n"
    "  --simulate S      integrate for S seconds from the given state (or a random\n"
    "                    one), under its torques\n"
    "  --step H          step in seconds (0.001)\n"
    "  --integrator NAME euler, semi-implicit, implicit, rk4 or rkmk4 (rk4)\n"
    "  --trajectory FILE where to write the motion: FILE.csv or FILE.npz\n"
    "  --every N         keep every Nth step (1), and the last\n"
    "  --trace FILE      write when each process did what (JSON; medians over random\n"
    "                    states)\n"
    "  --time            time an evaluation: median, minimum, 99th percentile over\n"
    "                    random states (more processes than cores: as --stretches)\n"
    "  --stretches       instead of --time: time what each process computes between\n"
    "                    messages, one process at a time, and compute the total from\n"
    "                    these times and the costs of messages\n"
    "  --repeat N        evaluations of each random state when timing (200)\n"
    "  --seed N          seed of the random states (1)\n"
    "  --tolerance X     largest backward error that passes --check\n"
    "  --channel KIND    auto, window (shared memory) or message (MPI messages)\n"
    "  --hosts N         treat the processes as if on N hosts, in equal parts: only\n"
    "                    those of one host share memory\n"
    "  --timeout S       seconds that a process waits for another (30)\n"
    "  --no-pin          do not bind processes to cores when timing\n"
    "  --json            report as JSON on standard output\n"
    "  --help            this text\n"
    "Without --states, --check, --time, --trace or --simulate it checks and times.\n"
    "Exit status: 0 done, 1 bad input or a failed check, 2 wrong usage, 3 a process\n"
    "died or did not answer.\n";

constexpr std::array<const char*, 5> kSimulationWords{"--simulate", "--step", "--integrator",
                                                      "--trajectory", "--every"};

// Takes one option of a simulation; number is not a number where the value is none of 0 or more.
// Returns an empty string, or what is wrong.
std::string parse_simulation(const std::string& word, const std::string& value, double number,
                             SimulationOptions& options) {
  if (word == "--integrator") {
    std::string names;
    for (const IntegratorInfo& info : kIntegrators) {
      if (value == info.name) return options.integrator = &info, "";
      names += (names.empty() ? "" : ", ") + std::string(info.name);
    }
    return "--integrator takes one of " + names;
  }
  if (word == "--trajectory") {
    options.trajectory = value;
    return Trajectory::is_known(value) ? "" : "--trajectory takes FILE.csv or FILE.npz";
  }
  if (word == "--every") {
    options.every = number <= 1e12 ? static_cast<long long>(number) : 0;
    const bool whole = options.every >= 1 && number == std::floor(number);
    return whole ? "" : "--every takes a whole number from 1 to 1e12";
  }
  if (!(number > 0)) return word + " takes a number of seconds above 0";
  (word == "--step" ? options.step : options.seconds) = number;
  return "";
}

// Returns why a combination of options is refused, and sets defaults.
std::string settle(bool simulation_words, Options& options) {
  if (about.batch &&
      (options.simulation.seconds > 0 || !options.trace.empty() || options.stretches))
    return "a batch solver has neither --simulate nor --trace nor --stretches";
  if (about.threads > 1 && (!options.trace.empty() || options.stretches))
    return "a solver of threads has neither --trace nor --stretches: emit it for channel window";
  // mpiexec of Open MPI 5 passes standard input on, but not its end: reading would not end.
  if (about.processes > 1 && (options.states == "-" || options.states == "/dev/stdin"))
    return "standard input is for solvers of one process: give a file of states";
  const bool others = options.check || options.time || !options.trace.empty();
  if (options.simulation.seconds > 0) {
    if (others || !options.result.empty())
      return "--simulate goes alone: without --check, --time, --trace and --result";
    return "";
  }
  if (simulation_words) return "--step, --integrator, --trajectory and --every need --simulate";
  if (!options.result.empty() && options.states.empty()) return "--result needs --states";
  if (options.json && options.result.empty() && !options.states.empty())
    return "--json needs --result FILE where there are --states: both would go to standard output";
  if (options.states.empty() && !others) options.check = options.time = true;
  return "";
}

// Returns an empty string, or what is wrong.
std::string parse(int count, char** words, Options& options) {
  bool simulation_words = false;
  for (int k = 1; k < count; ++k) {
    const std::string word = words[k];
    const auto flag = [&word](const char* name) { return word == name; };
    if (flag("--check"))
      options.check = true;
    else if (flag("--time"))
      options.time = true;
    else if (flag("--stretches"))
      options.time = options.stretches = true;
    else if (flag("--json"))
      options.json = true;
    else if (flag("--help"))
      options.help = true;
    else if (flag("--no-pin"))
      options.pin = false;
    else {
      const char* const known[] = {"--states",    "--result",  "--trace", "--repeat", "--seed",
                                   "--tolerance", "--channel", "--hosts", "--timeout"};
      const bool of_simulation =
          std::any_of(kSimulationWords.begin(), kSimulationWords.end(), flag);
      if (!of_simulation && std::none_of(std::begin(known), std::end(known), flag))
        return "unknown option " + word;
      if (k + 1 == count) return word + " needs a value";
      const std::string value = words[++k];
      char* end = nullptr;
      const double number = std::strtod(value.c_str(), &end);
      const bool numeric = !value.empty() && *end == '\0' && std::isfinite(number) && number >= 0;
      if (of_simulation) {
        simulation_words = true;
        const std::string wrong =
            parse_simulation(word, value, numeric ? number : std::nan(""), options.simulation);
        if (!wrong.empty()) return wrong;
      } else if (flag("--states"))
        options.states = value;
      else if (flag("--result"))
        options.result = value;
      else if (flag("--trace"))
        options.trace = value;
      else if (flag("--channel")) {
        options.channel = value;
        if (value != "auto" && value != "window" && value != "message")
          return "--channel takes auto, window or message";
      } else if (!numeric)
        return std::string(word).append(" takes a number of 0 or more, not \"").append(value) +
               "\"";
      else if (flag("--repeat")) {
        if (number < 1 || number > 1e6 || number != std::floor(number))
          return "--repeat takes a whole number from 1 to 1000000";
        options.repeat = static_cast<int>(number);
      } else if (flag("--seed")) {
        if (number > 0x1p53 || number != std::floor(number))
          return "--seed takes a whole number of 0 or more";
        options.seed = static_cast<std::uint64_t>(number);
      } else if (flag("--hosts")) {
        if (number < 1 || number > about.processes || number != std::floor(number))
          return "--hosts takes a whole number from 1 to " + std::to_string(about.processes) +
                 ", that of processes";
        options.hosts = static_cast<int>(number);
      } else if (flag("--tolerance"))
        options.tolerance = number;
      else if (number <= 0 || number > 1e6)
        return "--timeout takes a number of seconds above 0, at most 1000000";
      else
        options.time_limit = number;
    }
  }
  return settle(simulation_words, options);
}

}  // namespace
}  // namespace adagen
