// SPDX-License-Identifier: MIT
// What does a million evaluations cost in C++, to compare with the same from Python? The rival of
// bench/python_evaluate.py, which starts it and lets it take its turns: for every line of input, a
// question, it prints how many seconds one run took. Alone it prints its own figures.
#include <iostream>
#include <map>
#include <memory>

#include "hodograph/frame/any_batch.hpp"
#include "hodograph/io/document.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

constexpr std::size_t count = 1'000'000;

/// Memory for results that is not written before the results are, as NumPy's.
struct Fresh {
  explicit Fresh(std::size_t size)
      : numbers(std::make_unique_for_overwrite<double[]>(size)), span(numbers.get(), size) {}
  std::unique_ptr<double[]> numbers;
  std::span<double> span;
};

double seconds_of(const std::function<void()>& run) {
  const auto begin = std::chrono::steady_clock::now();
  run();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

int main(int argc, char** argv) {
  const bool asked = argc > 1;
  const AnyPath path = bench::random_path<8>(1000, 0.3);
  if (asked) {
    PathDocument document{path};
    if (const auto fault = save_document(document, argv[1])) {
      std::cerr << fault->sentence << "\n";
      return 1;
    }
  }
  std::vector<double> xi(count), s(count);  // evenly spaced: Python has the same
  for (std::size_t i = 0; i < count; ++i) {
    const double part = static_cast<double>(i) / static_cast<double>(count);
    xi[i] = path.xi_begin() + (path.xi_end() - path.xi_begin()) * part;
    s[i] = path.arc_length() * part;
  }
  Fresh kept(17 * count);
  const auto state = [&](std::span<double> all) {
    evaluate(path, xi,
             {all.first(3 * count), all.subspan(3 * count, 9 * count),
              all.subspan(12 * count, 3 * count), all.subspan(15 * count, count),
              all.subspan(16 * count, count)});
    bench::keep(all);
  };
  const auto position = [&](std::span<double> all) {
    evaluate(path, xi, {.positions = all});
    bench::keep(all);
  };
  const auto point = [&](std::span<double> all) {
    points_at_arc_lengths(path, s, all);
    bench::keep(all);
  };
  const std::map<std::string, std::function<void()>> questions{
      {"position", [&] { position(Fresh(3 * count).span); }},
      {"position, memory kept", [&] { position(kept.span.first(3 * count)); }},
      {"state", [&] { state(Fresh(17 * count).span); }},
      {"state, memory kept", [&] { state(kept.span); }},
      {"point at arc length", [&] { point(Fresh(3 * count).span); }},
      {"point at arc length, memory kept", [&] { point(kept.span.first(3 * count)); }},
  };
  if (!asked) {
    for (const auto& [question, run] : questions) {
      std::vector<bench::Rival> one{{"C++", run, static_cast<double>(count)}};
      bench::compare(question + ", 1000000 points", one, 7);
    }
    return 0;
  }
  for (std::string question; std::getline(std::cin, question);) {
    std::cout << seconds_of(questions.at(question)) << std::endl;
  }
}
