// SPDX-License-Identifier: MIT
// Finds and loads the module that writes STEP.
#include "cli/step_module/step_module.hpp"

#if HODOGRAPH_HAS_CAD
#include <dlfcn.h>

#include <filesystem>
#include <string_view>
#include <vector>
#endif

namespace hodograph::cli {

#if HODOGRAPH_HAS_CAD
namespace {

/// The folder of the program, or of the extension module of Python, that this code is part of.
std::filesystem::path own_folder() {
  std::error_code ignored;
  Dl_info here{};
  static constexpr char inside = 0;
  if (dladdr(&inside, &here) != 0 && here.dli_fname != nullptr &&
      std::string_view(here.dli_fname).find(".so") != std::string_view::npos) {
    return std::filesystem::canonical(here.dli_fname, ignored).parent_path();
  }
  return std::filesystem::canonical("/proc/self/exe", ignored).parent_path();
}

}  // namespace

StepAnswer write_step(const Sweep& sweep, const StepRequest& request) {
  // Beside the program in a build folder (two above the Python package's), in the library folder of
  // the same prefix otherwise.
  std::error_code ignored;
  const auto program = own_folder();
  const std::vector<std::filesystem::path> places = {
      program / "hodograph-step.so", program / ".." / ".." / "hodograph-step.so",
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
