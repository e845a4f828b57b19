// adagen's runtime, the same for all robots.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "json.hpp"
#include "program_setting.hpp"
#include "slave.hpp"

namespace adagen {
namespace {

// Reads a states file (JSON) and writes a result file, joints by name.
struct States {
  int count = 0;
  std::vector<Number> q, v, tau;  // one state after the other
  std::vector<double> gravity;    // where it is set; else none
};

class StatesReader : private JsonReader {
 public:
  explicit StatesReader(std::string text) : JsonReader(std::move(text)) {}

  // Returns an empty string, or what is wrong, as "LINE: message".
  std::string read(States& states) {
    try {
      parse(states);
      return "";
    } catch (const std::runtime_error& error) {
      return std::to_string(
                 1 + std::count(text_.begin(), text_.begin() + static_cast<long>(at_), '\n')) +
             ": error: " + error.what();
    }
  }

 private:
  static std::size_t as_size(int n) { return static_cast<std::size_t>(n); }

  void parse(States& states) {
    std::vector<bool> seen(static_cast<std::size_t>(about.joints.count));
    std::vector<std::vector<double>> forces(static_cast<std::size_t>(about.outer_forces.count));
    bool joints = false;
    object([&](const std::string& key) {
      if (key == "joints") {
        joints = true;
        object([&](const std::string& name) { read_joint(name, seen, states); });
      } else if (key == "forces" && about.outer_forces.count > 0) {
        object([&](const std::string& name) { read_force(name, forces); });
      } else if (key == "floating") {
        if (boolean() != about.floating)
          refuse(std::string("\"floating\": this solver's base is ") +
                 (about.floating ? "floating" : "fixed") + "; generate it anew");
      } else if (key == "gravity") {
        const std::vector<double> given = numbers();
        if (given.size() != 3) refuse("\"gravity\" is not three numbers");
        if (about.sets_gravity)
          states.gravity = given;
        else if (!std::equal(given.begin(), given.end(), about.gravity))
          refuse("\"gravity\": another gravity is compiled into this solver; generate it anew");
      } else {
        refuse("unknown member " + quoted(key.c_str()));
      }
    });
    white();
    if (at_ != text_.size()) refuse("text behind the end");
    if (!joints) refuse("\"joints\" is missing");
    for (int j = 0; j < about.joints.count; ++j)
      if (!seen[j] && about.joints[j].source < 0)
        refuse("joint " + quoted(about.joints[j].name) + " is missing");
    fill_slaved(states);
    for (int k = 0; k < about.outer_forces.count; ++k) fill_force(k, forces[as_size(k)], states);
  }

  void read_joint(const std::string& name, std::vector<bool>& seen, States& states) {
    int j = 0;
    while (j < about.joints.count && name != about.joints[j].name) ++j;
    if (j == about.joints.count) refuse("unknown joint " + quoted(name.c_str()));
    const std::string joint = "joint " + quoted(name.c_str());
    if (seen[j]) refuse(joint + " comes twice");
    seen[j] = true;
    std::array<bool, 3> found{};
    const char* const input = about.joints[j].prescribed ? "qdd" : "tau";
    object([&](const std::string& key) {
      if (key == "type" || (key == "qdd" && key != input))
        return skip();  // as in a file of true answers
      const char* const fields[] = {"q", "v", input};
      const auto field = std::find(std::begin(fields), std::end(fields), key);
      if (field == std::end(fields)) refuse(joint + ": unknown member " + quoted(key.c_str()));
      bool& there = found[static_cast<std::size_t>(field - std::begin(fields))];
      if (there) refuse(joint + ": " + key + " comes twice");
      there = true;
      where_ = joint + ": " + key + ": ";
      read_field(about.joints[j], key, states);
      where_.clear();
    });
    if (!found[0] || !found[1] || !found[2]) refuse(joint + " needs q, v and " + input);
  }

  // One of q, v and tau of a joint: an entry for each state.
  void read_field(const Joint& joint, const std::string& key, States& states) {
    const bool is_q = key == "q";
    const auto size = static_cast<std::size_t>(is_q ? joint.nq : joint.nv);
    const auto start = static_cast<std::size_t>(is_q ? joint.q : joint.v);
    const std::size_t stride = as_size(is_q ? about.nq : key == "v" ? about.nv : about.ntau);
    std::vector<Number>& values = is_q ? states.q : key == "v" ? states.v : states.tau;
    int count = 0;
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != size)
        refuse("state " + std::to_string(count + 1) + " has " + std::to_string(entry.size()) +
               " numbers, not " + std::to_string(size));
      const std::size_t row = stride * static_cast<std::size_t>(count);
      if (values.size() < row + stride) values.resize(row + stride);
      for (std::size_t k = 0; k < size; ++k) {
        values[row + start + k] = static_cast<Number>(entry[k]);
        if (about.at_rest && key == "v" && entry[k] != 0)
          refuse("this solver is for states at rest: velocities are zero; generate it anew");
      }
      ++count;
    });
    if (count == 0) refuse("there is no state");
    if (states.count == 0) states.count = count;
    if (count != states.count)
      refuse(std::to_string(count) + " states, but others have " + std::to_string(states.count));
  }

  // One link's outer force: six numbers for each state.
  void read_force(const std::string& name, std::vector<std::vector<double>>& forces) {
    int k = 0;
    while (k < about.outer_forces.count && name != about.outer_forces[k].name) ++k;
    if (k == about.outer_forces.count)
      refuse("no outer force acts on link " + quoted(name.c_str()));
    where_ = "force on link " + quoted(name.c_str()) + ": ";
    std::vector<double>& own = forces[as_size(k)];
    if (!own.empty()) refuse("comes twice");
    array([&] {
      const std::vector<double> entry = numbers();
      if (entry.size() != 6) refuse("needs six numbers for each state");
      own.insert(own.end(), entry.begin(), entry.end());
    });
    where_.clear();
  }

  void fill_force(int k, const std::vector<double>& given, States& states) {
    if (given.size() != 6 * static_cast<std::size_t>(states.count))
      refuse("force on link " + quoted(about.outer_forces[k].name) + ": " +
             std::to_string(given.size() / 6) + " states, but the joints have " +
             std::to_string(states.count));
    for (std::size_t i = 0; i < given.size(); ++i)
      states.tau[i / 6 * as_size(about.ntau) + as_size(about.nv + 6 * k) + i % 6] =
          static_cast<Number>(given[i]);
  }

  static void fill_slaved(States& states) {
    for (int s = 0; s < states.count; ++s)
      slave(about.joints, states.q.data() + static_cast<long>(s) * about.nq,
            states.v.data() + static_cast<long>(s) * about.nv);
  }
};

// Numbers first .. first + size - 1 of qdd, of each state.
void write_numbers(std::FILE* file, const std::vector<Number>& qdd, int count, int first,
                   int size) {
  std::fputs("[", file);
  for (int s = 0; s < count; ++s) {
    const Number* x = qdd.data() + static_cast<long>(s) * about.nqdd + first;
    std::fputs(s == 0 ? "" : ", ", file);
    if (size > 1) std::fputs("[", file);
    for (int k = 0; k < size; ++k)
      if (x[k] == x[k])
        std::fprintf(file, "%s%.17g", k == 0 ? "" : ", ", static_cast<double>(x[k]));
      else  // of a batch, a state that failed
        std::fputs(k == 0 ? "null" : ", null", file);
    if (size > 1) std::fputs("]", file);
  }
  std::fputs("]", file);
}

// more: further members of the file, each after a comma.
bool write_result(const std::string& path, const std::vector<Number>& qdd, int count,
                  const std::string& more) {
  std::FILE* file = std::fopen(path.c_str(), "w");
  if (file == nullptr) return false;
  std::fputs("{\"joints\": {", file);
  const char* between = "";
  for (const Joint& joint : about.joints) {
    if (!joint.given) continue;
    std::fprintf(file, "%s\n%s: {\"qdd\": ", between, quoted(joint.name).c_str());
    write_numbers(file, qdd, count, joint.v, joint.nv);
    std::fputs("}", file);
    between = ",";
  }
  std::fputs("\n}", file);
  int first = about.nv;
  for (const Output& output : about.outputs) {
    std::fprintf(file, "%s\n{\"what\": %s, \"of\": %s, \"values\": ",
                 first == about.nv ? ", \"outputs\": [" : ",", quoted(output.what).c_str(),
                 quoted(output.name).c_str());
    write_numbers(file, qdd, count, first, output.size);
    std::fputs("}", file);
    first += output.size;
  }
  if (about.outputs.count > 0) std::fputs("\n]", file);
  std::fprintf(file, "%s}\n", more.c_str());
  const bool good = std::ferror(file) == 0;
  return std::fclose(file) == 0 && good;
}

}  // namespace
}  // namespace adagen
