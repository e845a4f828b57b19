// What can go wrong in an evaluation. A status travels with every message, so that all processes
// learn of a failure and none waits for an answer that cannot come. It must be exact in a float.
enum Failure : int {
  kFine = 0,
  kNotFinite = 1,       // the state of a joint is not a finite number
  kZeroQuaternion = 2,  // the orientation of a joint is a quaternion of no length, or of too much
  kFactorization = 3,   // V^-1 of a joint is not positive definite
  kOverflow = 4,        // the acceleration of a joint is not a finite number
  kGimbalLock = 8,      // joints that are joined as one do not move in as many directions
  kGrowth = 9,          // a link's mobility beside a joint is lost to its neighbours
  kSingularPose = 10,   // no failure: the evaluation is done again in another way
  kNoAnswer = 5,        // a process did not answer in time (numbered in place of a joint)
  kEnded = 6,           // no failure: process 0 has no more to evaluate
  kNotRefined = 7,      // a correction is as large as the one before: refinement does not converge
  kTooFewSteps = 11,    // refinement converges, but has not reached the digits that it owes
};

constexpr int kFailureBase = 1 << 20;
constexpr int failure(Failure kind, int joint) { return kind * kFailureBase + joint; }
constexpr Failure failure_kind(int status) { return static_cast<Failure>(status / kFailureBase); }
constexpr int failure_place(int status) { return status % kFailureBase; }

// Text as a JSON string, in one line.
std::string quoted(const char* text) {
  std::string result = "\"";
  for (; *text != '\0'; ++text) {
    const unsigned char c = static_cast<unsigned char>(*text);
    if (c == '"' || c == '\\') {
      result += '\\';
      result += *text;
    } else if (c < 0x20 || c == 0x7F) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      result += escape;
    } else {
      result += *text;
    }
  }
  return result + "\"";
}

// The names of a joint and of those before it that it is joined with: the links between them have
// neither mass nor inertia.
std::string names_of_run(int joint) {
  std::string names = quoted(kJoints[joint].name);
  for (int link = kJoints[joint].parent; link > 0; link = kJoints[link - 1].parent) {
    const LinkConstants& own = kLinks[link];
    if (own.mass > 0 || own.tensor[0] + own.tensor[4] + own.tensor[8] > 0) break;
    names = quoted(kJoints[link - 1].name) + ", " + names;
  }
  return names;
}

std::string describe(int status) {
  const int place = failure_place(status);
  const auto joint = [place] { return "joint " + quoted(kJoints[place].name) + ": "; };
  switch (failure_kind(status)) {
    case kFine:
      return "no error";
    case kNotFinite:
      return joint() + "its q, v or tau is not a finite number";
    case kZeroQuaternion:
      return joint() + "its quaternion cannot be normalised";
    case kFactorization:
      return joint() +
             "factorization failed: the inertias beside it differ too much for the scalar";
    case kGimbalLock:
      return "joints " + names_of_run(place) +
             ": gimbal lock: through links without mass, they do not move in as many directions";
    case kGrowth:
      return joint() +
             "no digits left: a link beside it is too light for its neighbours and the scalar";
    case kOverflow:
      return joint() + "its acceleration is not a finite number (overflow)";
    case kSingularPose:
      return joint() + "its mobility is singular in this pose";
    case kEnded:
      return "the evaluations are over";
    case kNotRefined:
      return "refinement does not converge: the inertias differ too much for the scalar";
    case kTooFewSteps:
      return "refinement converges too slowly: its last correction is too large; take more steps "
             "(--refine) or --scalar double";
    case kNoAnswer:
      return "process " + std::to_string(place) + " did not answer within the time limit";
  }
  return "unknown failure";
}
