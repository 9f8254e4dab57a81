// SPDX-License-Identifier: MIT
// The independent judge of our JSON Schemas: Debian's python3-jsonschema.
#pragma once

#include <cstdlib>
#include <string>

namespace hodograph::test {

/// A Python that can validate against JSON Schema 2020-12: the first on the search path, or
/// Debian's own where another one stands before it. Empty where neither can: a failure of the test,
/// for the packages of the tests bring the module.
inline std::string python_with_jsonschema() {
  for (const std::string python : {"python3", "/usr/bin/python3"}) {
    const std::string check =
        python +
        " -c 'import jsonschema as j; j.Draft202012Validator; j.RefResolver' > /dev/null 2>&1";
    if (std::system(check.c_str()) == 0) return python;
  }
  return "";
}

}  // namespace hodograph::test
