// SPDX-License-Identifier: MIT
// Solvers from Python: their progress, Ctrl-C, and what is raised meanwhile.
#pragma once

#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/control/lunar_ascent.hpp"
#include "hodograph/control/solver.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

/// What happens at every iteration: Ctrl-C is looked for, and progress(...), if there is one, is
/// asked whether to go on (None: yes). What it raises is raised when the solver has stopped.
class Watch {
 public:
  explicit Watch(std::optional<py::function> progress) : progress_(std::move(progress)) {}

  template <class... Arguments>
  bool goes_on(const Arguments&... arguments) {
    const py::gil_scoped_acquire locked;
    try {
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
      if (!progress_) return true;
      const py::object answer = (*progress_)(arguments...);
      return answer.is_none() || py::bool_(answer);
    } catch (...) {
      raised_ = std::current_exception();
      return false;
    }
  }

  /// The result of solve(), made without the interpreter's lock.
  template <class Solve>
  auto run(const Solve& solve) {
    auto result = unlocked(solve);
    if (raised_) std::rethrow_exception(raised_);
    return std::move(result).value();
  }

 private:
  std::optional<py::function> progress_;
  std::exception_ptr raised_;
};

/// progress(SolverIteration), and progress(guess, SolverIteration).
class SolverProgress : public py::function {
  using py::function::function;
};
class AscentProgress : public py::function {
  using py::function::function;
};

/// Ipopt's own options by name: a dict of texts and numbers.
std::vector<SolverSetting> settings_of(const py::dict& settings);

void bind_reference(py::module_& m);
void bind_ascents(py::module_& m);
void bind_following(py::module_& m);
void bind_code(py::module_& m);

}  // namespace hodograph::python

template <>
struct pybind11::detail::handle_type_name<hodograph::python::SolverProgress> {
  static constexpr auto name =
      const_name("Callable[[hodograph._control.SolverIteration], Optional[bool]]");
};
template <>
struct pybind11::detail::handle_type_name<hodograph::python::AscentProgress> {
  static constexpr auto name =
      const_name("Callable[[int, hodograph._control.SolverIteration], Optional[bool]]");
};
