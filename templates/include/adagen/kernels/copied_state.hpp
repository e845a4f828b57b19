// adagen's runtime, the same for all robots.
#pragma once

#include "../sizes.hpp"
#include "../value.hpp"

namespace {

// Numbers of the state, copied to the type that is computed with; as they were given, too.
template <int count>
class Copied {
 public:
  Copied& operator=(const Number* x) {
    given_ = x;
    for (int k = 0; k < count; ++k) copy_[k] = static_cast<Value>(x[k]);
    return *this;
  }
  operator const Value*() const { return copy_; }
  const Number* given() const { return given_; }
  Value* data() { return copy_; }

 private:
  const Number* given_ = nullptr;
  Value copy_[count > 0 ? count : 1]{};
};
template <int count>
const Number* given(const Copied<count>& x) {
  return x.given();
}

// The state that an evaluation reads, and the answer that it writes.
struct State {
  Copied<kNq> q;
  Copied<kNv> v;
  Copied<kNtau> tau;
  Number* qdd = nullptr;
};

}  // namespace
