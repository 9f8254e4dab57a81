// SPDX-License-Identifier: MIT
// Finds and loads the module that writes STEP.
#include "cli/step_module/step_module.hpp"

#if HODOGRAPH_HAS_CAD
#include <dlfcn.h>

#include <filesystem>
#include <vector>
#endif

namespace hodograph::cli {

#if HODOGRAPH_HAS_CAD
StepAnswer write_step(const Sweep& sweep, const StepRequest& request) {
  // Beside the program in a build folder, in the library folder of the same prefix otherwise.
  std::error_code ignored;
  const auto program = std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
  const std::vector<std::filesystem::path> places = {
      program / "hodograph-step.so",
      program / ".." / HODOGRAPH_MODULE_DIRECTORY / "hodograph-step.so",
      std::filesystem::path(HODOGRAPH_MODULE_DIRECTORY) / "hodograph-step.so"};
  std::string why = "it is not beside the program";
  for (const auto& place : places) {
    if (!std::filesystem::exists(place, ignored)) continue;
    void* const module = dlopen(place.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (module == nullptr) {
      why = dlerror();
      continue;
    }
    if (const auto write = reinterpret_cast<WriteStep>(dlsym(module, write_step_name))) {
      StepAnswer answer;
      write(sweep, request, answer);
      if (answer.fault) throw Error(*answer.fault);
      return answer;
    }
    why = "it is of another version";
  }
  throw Error(Fault{FaultCode::unsupported,
                    "the module that writes STEP (hodograph-step.so) cannot be loaded: " + why,
                    std::nullopt, "format", std::nullopt, std::nullopt});
}
#else
StepAnswer write_step(const Sweep&, const StepRequest&) {
  throw Error(Fault{FaultCode::unsupported,
                    "this program was built without OpenCASCADE and does not write STEP; build it "
                    "with -DHODOGRAPH_WITH_CAD=ON, or write stl, obj or glb",
                    std::nullopt, "format", std::nullopt, std::nullopt});
}
#endif

}  // namespace hodograph::cli
