// SPDX-License-Identifier: MIT
// A program outside the tree: the smallest thing that uses a template and links the library.
#include <cstdio>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/foundation/version.hpp"

int main() {
  const hodograph::Quaternion<double> preimage{1, 2, 3, 4};
  const auto velocity = hodograph::hodograph_form(preimage, preimage);
  std::printf("hodograph %s\n", hodograph::version);
  std::printf("velocity %g %g %g\n", velocity.x, velocity.y, velocity.z);
  std::printf("%s\n", std::string(name_of(hodograph::FaultCode::zero_speed)).c_str());
}
