// SPDX-License-Identifier: MIT
// hodograph._requests: the lines of `hodograph batch`, answered inside the
// interpreter. The package's requests.py makes answer() and answer_lines() of
// it.
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include "cli/requests/answer_pool.hpp"

namespace py = pybind11;

namespace hodograph::python {
namespace {

using FaultParts = std::tuple<std::string, std::string, std::optional<std::size_t>, std::string,
                              std::optional<double>, std::optional<double>>;
using TextAndFault = std::pair<std::string, std::optional<FaultParts>>;

TextAndFault parts_of(cli::AnsweredLine answer) {
  std::optional<FaultParts> parts;
  if (answer.fault) {
    Fault& fault = *answer.fault;
    parts.emplace(std::move(fault.sentence), std::string(name_of(fault.code)), fault.index,
                  std::move(fault.quantity), fault.value, fault.bound);
  }
  return {std::move(answer.text), std::move(parts)};
}

/// An AnswerPool that one Python thread feeds and empties.
class LinePool {
 public:
  explicit LinePool(std::size_t jobs) : pool_(std::make_unique<cli::AnswerPool>(jobs)) {}
  ~LinePool() { close(); }
  LinePool(const LinePool&) = delete;
  LinePool& operator=(const LinePool&) = delete;

  bool has_room() { return pool_ && pool_->has_room(); }
  bool ready() const { return pool_ && pool_->ready(); }
  void submit(std::string text) {
    if (!pool_) throw std::runtime_error("the pool is closed");
    cli::Line line;
    line.number = ++lines_;
    line.too_long = text.size() > cli::longest_request;
    if (!line.too_long) line.text = std::move(text);
    pool_->submit(std::move(line));
  }
  void finish() {
    if (pool_) pool_->finish();
  }
  /// The oldest answer; nothing after the last one. Ctrl-C is heard.
  std::optional<TextAndFault> take() {
    constexpr std::chrono::milliseconds patience{50};
    while (pool_) {
      cli::LineAnswer one;
      cli::AnswerPool::Next next = cli::AnswerPool::Next::none_yet;
      {
        const py::gil_scoped_release unlocked;
        next = pool_->take(one, patience);
      }
      if (next == cli::AnswerPool::Next::answer) return parts_of(std::move(one.answer));
      if (next == cli::AnswerPool::Next::end) break;
      if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    }
    return std::nullopt;
  }
  /// Drops what was not begun and waits for what was. In a forked child the
  /// threads are not there: nothing is waited for, and the memory is left.
  void close() {
    if (::getpid() != owner_) {
      static_cast<void>(pool_.release());
      return;
    }
    const py::gil_scoped_release unlocked;
    pool_.reset();
  }

 private:
  std::unique_ptr<cli::AnswerPool> pool_;
  std::uint64_t lines_ = 0;
  pid_t owner_ = ::getpid();
};

}  // namespace
}  // namespace hodograph::python

PYBIND11_MODULE(_requests, m) {
  using hodograph::python::LinePool;
  namespace cli = hodograph::cli;
  m.doc() = "The lines of `hodograph batch`; see hodograph.answer.";
  m.def(
      "answered",
      [](const std::string& line) {
        cli::AnsweredLine answer;
        {
          const py::gil_scoped_release unlocked;
          const bool too_long = line.size() > cli::longest_request;
          answer = cli::answered_line(line, too_long);
        }
        return hodograph::python::parts_of(std::move(answer));
      },
      py::arg("line"), "The answer to one line, and the parts of its fault or None.");
  m.def("all_cores", &cli::all_cores, "How many threads the machine runs at a time.");
  m.attr("most_jobs") = cli::most_jobs;
  py::class_<LinePool>(m, "LinePool", py::module_local(),
                       "Threads that answer lines; answers leave in the order of the lines.")
      .def(py::init<std::size_t>(), py::arg("jobs"))
      .def("has_room", &LinePool::has_room, "Whether a line may be submitted now.")
      .def("submit", &LinePool::submit, py::arg("line"), "Takes a line in.")
      .def("ready", &LinePool::ready, "Whether take() would not wait.")
      .def("finish", &LinePool::finish, "No more lines will come.")
      .def("take", &LinePool::take,
           "The oldest answer and the parts of its fault or None; None after "
           "the last one.")
      .def("close", &LinePool::close, "Drops what was not begun and waits for what was.");
}
