// SPDX-License-Identifier: MIT
// Generated C against the library: compiled by the system's C compiler, loaded, and called.
#include "hodograph/control/code_generation.hpp"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/curve/curvature_derivatives.hpp"
#include "hodograph/foundation/taylor.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "tests/io/temporary_directory.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

enum Status { ok = 0, outside = 1, standstill = 2, inflection = 3, unknown_order = 4 };

/// Generated code, compiled without a warning and loaded.
class Compiled {
 public:
  explicit Compiled(const GeneratedCode& code, const std::string& level = "-O1") {
    write(code.header_name, code.header);
    write(code.source_name, code.source);
    const std::string library = folder_.path("code.so");
    const std::string command =
        "cc -std=c99 -Wall -Wextra -pedantic -Werror -ffp-contract=off -shared -fPIC " + level +
        " -o '" + library + "' '" + folder_.path(code.source_name) + "' -lm";
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
    handle_ = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_NE(handle_, nullptr) << dlerror();
  }
  Compiled(const Compiled&) = delete;
  Compiled& operator=(const Compiled&) = delete;
  ~Compiled() {
    if (handle_ != nullptr) dlclose(handle_);
  }
  template <class Function>
  Function* function(const std::string& name) const {
    void* const symbol = handle_ == nullptr ? nullptr : dlsym(handle_, name.c_str());
    EXPECT_NE(symbol, nullptr) << name;
    return reinterpret_cast<Function*>(symbol);
  }

 private:
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path(name)) << text;
  }
  TemporaryDirectory folder_;
  void* handle_ = nullptr;
};

using Evaluation = int(double, int, double*);

Compiled compiled(const AnyPath& path, const CodeOptions& options) {
  return Compiled(generate_code(path, options).value());
}

void append(std::vector<double>& all, double x) { all.push_back(x); }
template <class V>
  requires requires { V::dimension; }
void append(std::vector<double>& all, const V& v) {
  for (std::size_t i = 0; i < V::dimension; ++i) all.push_back(v[i]);
}
void append(std::vector<double>& all, const Frame2<double>& r) {
  append(all, r.e1);
  append(all, r.e2);
}
void append(std::vector<double>& all, const Frame3<double>& r) {
  append(all, r.e1);
  append(all, r.e2);
  append(all, r.e3);
}

template <class List>
std::vector<double> flat(const List& list, std::size_t count) {
  std::vector<double> all;
  for (std::size_t i = 0; i < count; ++i) append(all, list[i]);
  return all;
}

void expect_same_bits(const Compiled& code, const std::string& name, double xi, int order,
                      const std::vector<double>& expected) {
  constexpr double untouched = 12345.0;
  std::vector<double> got(expected.size() + 1, untouched);
  ASSERT_EQ(code.function<Evaluation>(name)(xi, order, got.data()), ok) << name << " at " << xi;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(got[i]), std::bit_cast<std::uint64_t>(expected[i]))
        << name << " of order " << order << " at " << xi << ", number " << i << ": " << got[i]
        << " against " << expected[i];
  }
  EXPECT_EQ(got.back(), untouched) << name << " writes too much";
}

template <int K, class P>
void compare_at_order(const Compiled& code, const P& path, double xi) {
  using A = typename P::Algebra;
  constexpr auto count = static_cast<std::size_t>(K) + 1;
  expect_same_bits(code, "p_position", xi, K,
                   flat(path.template position_derivatives<count - 1>(xi), count));
  if constexpr (K <= 3) {
    const auto jet = path.template preimage_jet<count - 1>(xi);
    expect_same_bits(code, "p_speed", xi, K, flat(speed_derivatives(jet), count));
    std::vector<double> lengths{path.arc_length(xi)};
    for (const double sigma : speed_derivatives(jet)) lengths.push_back(sigma);
    expect_same_bits(code, "p_arc_length", xi, K + 1, lengths);
    if constexpr (K == 0) {
      expect_same_bits(code, "p_arc_length", xi, 0, {path.arc_length(xi)});
      expect_same_bits(code, "p_speed", xi, 0, {path.speed(xi)});
      expect_same_bits(code, "p_frame", xi, 0, flat(std::array{euler_rodrigues_frame(jet)}, 1));
    } else {
      expect_same_bits(code, "p_frame", xi, K, flat(euler_rodrigues_frame_derivatives(jet), count));
    }
  }
  if constexpr (K <= 2) {
    const auto jet = path.template preimage_jet<count>(xi);
    expect_same_bits(code, "p_body_rate", xi, K, flat(body_rate_per_xi(jet), count));
    if constexpr (A::dimension == 2) {
      expect_same_bits(code, "p_curvature", xi, K, flat(curvature_derivatives(jet), count));
    } else {
      expect_same_bits(code, "p_world_rate", xi, K, flat(world_rate_per_xi(jet), count));
      const auto kappa = curvature_derivatives(jet);
      ASSERT_TRUE(kappa.has_value());
      expect_same_bits(code, "p_curvature", xi, K, flat(*kappa, count));
    }
  }
}

template <class P>
void compare(const P& path, test::Random& random, const std::string& level) {
  const Compiled code(generate_code(path, {"p"}).value(), level);
  std::vector<double> places = path.knots();
  constexpr int random_places = 20;
  for (int i = 0; i < random_places; ++i) {
    places.push_back(random.uniform(path.xi_begin(), path.xi_end()));
  }
  for (const double xi : places) {
    compare_at_order<0>(code, path, xi);
    compare_at_order<1>(code, path, xi);
    compare_at_order<2>(code, path, xi);
    compare_at_order<3>(code, path, xi);
    compare_at_order<4>(code, path, xi);
  }
  EXPECT_EQ(code.function<double()>("p_xi_begin")(), path.xi_begin());
  EXPECT_EQ(code.function<double()>("p_xi_end")(), path.xi_end());
  EXPECT_EQ(code.function<double()>("p_length")(), path.arc_length());
}

TEST(CodeGeneration, PlanarCodeAgreesWithTheLibraryBitForBit) {
  test::Random random("planar code");
  compare(test::random_path<PlanarPath<0>>(random, 1), random, "-O0");
  compare(test::random_path<PlanarPath<2>>(random, 3), random, "-O2");
  compare(test::random_path<PlanarPath<5>>(random, 4), random, "-O3");
}

TEST(CodeGeneration, SpatialCodeAgreesWithTheLibraryBitForBit) {
  test::Random random("spatial code");
  compare(test::random_path<SpatialPath<1>>(random, 2), random, "-O0");
  compare(test::random_path<SpatialPath<4>>(random, 5), random, "-O2");
  compare(test::random_path<SpatialPath<12>>(random, 2), random, "-O3");
}

// What the C code computes is checked against the library; this checks the one part of it that
// nothing else does.
TEST(CodeGeneration, DerivativesOfTheCurvatureAreThoseOfItsTaylorSeries) {
  test::Random random("curvature derivatives");
  using T = Taylor<long double, 2>;
  // The series is in long double; a hundred terms of a few units are rounded here.
  constexpr double close = 1000.0 * std::numeric_limits<double>::epsilon();
  const auto check = [&](const auto& path) {
    const double xi = random.uniform(path.xi_begin(), path.xi_end());
    const auto series = test::converted<T>(path);
    const T x = T::variable(static_cast<long double>(xi));
    const auto at = series.locate(x);
    const auto kappa = curvature(series.segment(at.segment).template preimage_jet<1>(at.u));
    const auto jet = path.template preimage_jet<3>(xi);
    std::array<double, 3> found{};
    if constexpr (requires { curvature_derivatives(jet).value(); }) {
      found = curvature_derivatives(jet).value();
    } else {
      found = curvature_derivatives(jet);
    }
    for (std::size_t r = 0; r < found.size(); ++r) {
      const double expected = static_cast<double>(kappa.derivative(r));
      EXPECT_NEAR(found[r], expected, close * std::max(1.0, std::abs(expected))) << r;
    }
  };
  for (int i = 0; i < 20; ++i) {
    check(test::random_path<PlanarPath<4>>(random, 1));
    check(test::random_path<SpatialPath<4>>(random, 1));
  }
}

TEST(CodeGeneration, NothingIsWrittenOutsideTheKnotsOrForUnknownOrders) {
  test::Random random("code outside");
  const auto path = test::random_path<SpatialPath<4>>(random, 3);
  const Compiled code = compiled(path, {"p"});
  constexpr double untouched = 12345.0;
  const double below = std::nextafter(path.xi_begin(), -HUGE_VAL);
  const double above = std::nextafter(path.xi_end(), HUGE_VAL);
  for (const std::string name :
       {"position", "arc_length", "speed", "frame", "body_rate", "world_rate", "curvature"}) {
    auto* const function = code.function<Evaluation>("p_" + name);
    double result = untouched;
    for (const double xi : {below, above, -HUGE_VAL, HUGE_VAL, std::nan("")}) {
      EXPECT_EQ(function(xi, 0, &result), outside) << name << " at " << xi;
    }
    for (const int order : {-1, 5, 1000, -1000}) {
      EXPECT_EQ(function(path.xi_begin(), order, &result), unknown_order) << name;
    }
    EXPECT_EQ(result, untouched) << name;
  }
}

TEST(CodeGeneration, AStandstillHasAPositionAndASpeedButNoFrame) {
  using A = Complex<double>;  // w = 1 - 2u: the speed is zero in the middle
  const PlanarPhCurve<1> curve({0.0, 0.0}, BernsteinPolynomial<A, 1>({A{1.0, 0.0}, A{-1.0, 0.0}}),
                               1.0);
  const Compiled code = compiled(PlanarPath<1>::create({0.0, 1.0}, {curve}, false).value(), {"p"});
  std::array<double, 16> result{};
  EXPECT_EQ(code.function<Evaluation>("p_position")(0.5, 2, result.data()), ok);
  EXPECT_EQ(code.function<Evaluation>("p_speed")(0.5, 0, result.data()), ok);
  EXPECT_EQ(result[0], 0.0);
  for (const std::string name : {"frame", "body_rate", "curvature"}) {
    EXPECT_EQ(code.function<Evaluation>("p_" + name)(0.5, 0, result.data()), standstill) << name;
  }
}

TEST(CodeGeneration, AStraightLineInSpaceHasACurvatureButNoDerivativesOfIt) {
  using A = Quaternion<double>;
  const SpatialPhCurve<0> curve({0.0, 0.0, 0.0}, BernsteinPolynomial<A, 0>({A{1.0, 0.0, 0.0, 0.0}}),
                                1.0);
  const Compiled code = compiled(SpatialPath<0>::create({0.0, 1.0}, {curve}, false).value(), {"p"});
  std::array<double, 3> result{1.0, 1.0, 1.0};
  EXPECT_EQ(code.function<Evaluation>("p_curvature")(0.5, 0, result.data()), ok);
  EXPECT_EQ(result[0], 0.0);
  EXPECT_EQ(code.function<Evaluation>("p_curvature")(0.5, 1, result.data()), inflection);
}

TEST(CodeGeneration, RefusesNamesThatAreNoNamesInC) {
  test::Random random("code names");
  const AnyPath path = test::random_path<PlanarPath<2>>(random, 1);
  for (const std::string name :
       {"", "2nd", "a b", "a-b", "_a", "int", "main", "class", "sin", "a\"b", "\xc3\xa4"}) {
    const auto code = generate_code(path, {name});
    ASSERT_FALSE(code.has_value()) << name;
    EXPECT_EQ(code.fault().code, FaultCode::unsupported);
    EXPECT_NE(code.fault().sentence.find("cannot name functions in C"), std::string::npos);
  }
  EXPECT_FALSE(generate_code(path, {std::string(most_name_letters + 1, 'a')}).has_value());
  EXPECT_TRUE(generate_code(path, {std::string(most_name_letters, 'a')}).has_value());
}

TEST(CodeGeneration, TheFilesAreNamedAndTheHeaderServesCxxToo) {
  test::Random random("code header");
  const GeneratedCode code =
      generate_code(test::random_path<SpatialPath<2>>(random, 1), {"orbit", true}).value();
  EXPECT_EQ(code.header_name, "orbit.h");
  EXPECT_EQ(code.source_name, "orbit.c");
  EXPECT_NE(code.header.find("extern \"C\""), std::string::npos);
  EXPECT_NE(code.source.find("#include \"orbit.h\""), std::string::npos);
  EXPECT_EQ((code.header + code.source).find_first_of("@$~"), std::string::npos);
}

// ---- the external functions ---------------------------------------------------------------------

using Whole = long long int;

/// One of them through its symbols alone, as CasADi calls it.
class External {
 public:
  External(const Compiled& code, const std::string& name) : code_(&code), name_(name) {
    symbol<void()>("_incref")();
    memory_ = symbol<int()>("_checkout")();
    inputs_ = symbol<Whole()>("_n_in")();
    results_ = symbol<Whole()>("_n_out")();
    EXPECT_EQ(symbol<int(Whole*, Whole*, Whole*, Whole*)>("_work")(&sizes_[0], &sizes_[1],
                                                                   &sizes_[2], &sizes_[3]),
              0);
    EXPECT_GE(sizes_[0], inputs_);
    EXPECT_GE(sizes_[1], results_);
  }
  External(const External&) = delete;
  External& operator=(const External&) = delete;
  ~External() {
    symbol<void(int)>("_release")(memory_);
    symbol<void()>("_decref")();
  }

  Whole inputs() const { return inputs_; }
  Whole results() const { return results_; }
  std::string input_name(Whole i) const { return name_of("_name_in", i); }
  std::string result_name(Whole i) const { return name_of("_name_out", i); }

  struct Pattern {
    Whole rows = 0, columns = 0, entries = 0;
  };
  Pattern input_pattern(Whole i) const { return pattern("_sparsity_in", i); }
  Pattern result_pattern(Whole i) const { return pattern("_sparsity_out", i); }

  /// The named result, all others not asked for; nothing where the call fails.
  std::optional<std::vector<double>> operator()(const std::string& result, double xi) const {
    std::vector<const double*> arg(static_cast<std::size_t>(sizes_[0]), nullptr);
    std::vector<double*> res(static_cast<std::size_t>(sizes_[1]), nullptr);
    std::vector<double> values;
    for (Whole i = 0; i < results_; ++i) {
      if (result_name(i) != result) continue;
      values.resize(static_cast<std::size_t>(result_pattern(i).entries));
      res[static_cast<std::size_t>(i)] = values.data();
    }
    EXPECT_FALSE(values.empty()) << result;
    arg[0] = &xi;
    auto* const call = symbol<int(const double**, double**, Whole*, double*, int)>("");
    if (call(arg.data(), res.data(), nullptr, nullptr, memory_) != 0) return std::nullopt;
    return values;
  }
  /// Every result at once.
  int all(double xi) const {
    std::vector<const double*> arg(static_cast<std::size_t>(sizes_[0]), nullptr);
    std::vector<double*> res;
    std::vector<std::vector<double>> values;
    for (Whole i = 0; i < results_; ++i) {
      values.emplace_back(static_cast<std::size_t>(result_pattern(i).entries + 1));
    }
    for (auto& value : values) res.push_back(value.data());
    arg[0] = &xi;
    return symbol<int(const double**, double**, Whole*, double*, int)>("")(
        arg.data(), res.data(), nullptr, nullptr, memory_);
  }
  template <class Function>
  Function* symbol(const std::string& suffix) const {
    return code_->function<Function>(name_ + suffix);
  }

 private:
  std::string name_of(const std::string& suffix, Whole i) const {
    const char* const text = symbol<const char*(Whole)>(suffix)(i);
    return text == nullptr ? "" : text;
  }
  Pattern pattern(const std::string& suffix, Whole i) const {
    const Whole* const p = symbol<const Whole*(Whole)>(suffix)(i);
    if (p == nullptr) return {};
    const Whole rows = p[0], columns = p[1], entries = p[2 + columns];
    EXPECT_EQ(p[2], 0) << "columns begin at the first entry";
    for (Whole j = 0; j < columns; ++j) {
      EXPECT_LE(p[2 + j], p[3 + j]);
      for (Whole k = p[2 + j]; k < p[3 + j]; ++k) {
        EXPECT_GE(p[3 + columns + k], k > p[2 + j] ? p[2 + columns + k] + 1 : 0);
        EXPECT_LT(p[3 + columns + k], rows);
      }
    }
    return {rows, columns, entries};
  }

  const Compiled* code_;
  std::string name_;
  int memory_ = 0;
  Whole inputs_ = 0, results_ = 0;
  std::array<Whole, 4> sizes_{};
};

TEST(CodeGeneration, ExternalFunctionsGiveValuesAndBothDerivatives) {
  test::Random random("external functions");
  const auto path = test::random_path<SpatialPath<4>>(random, 3);
  const Compiled code = compiled(path, {"orbit", true});
  const External values(code, "orbit"), first(code, "jac_orbit"), second(code, "jac_jac_orbit");
  for (int i = 0; i < 5; ++i) {
    const double xi = random.uniform(path.xi_begin(), path.xi_end());
    const auto part = [](const auto& all, std::size_t r) { return flat(std::array{all[r]}, 1); };
    const auto position = path.position_derivatives<2>(xi);
    EXPECT_EQ(values("position", xi), part(path.position_derivatives<0>(xi), 0));
    EXPECT_EQ(first("jac_position_xi", xi), part(path.position_derivatives<1>(xi), 1));
    EXPECT_EQ(second("jac_jac_position_xi_xi", xi), part(position, 2));
    const auto frame = euler_rodrigues_frame_derivatives(path.preimage_jet<2>(xi));
    EXPECT_EQ(first("jac_frame_xi", xi),
              part(euler_rodrigues_frame_derivatives(path.preimage_jet<1>(xi)), 1));
    EXPECT_EQ(second("jac_jac_frame_xi_xi", xi), part(frame, 2));
    const auto jet = path.preimage_jet<3>(xi);
    EXPECT_EQ(second("jac_jac_body_rate_xi_xi", xi), part(body_rate_per_xi(jet), 2));
    EXPECT_EQ(second("jac_jac_world_rate_xi_xi", xi), part(world_rate_per_xi(jet), 2));
    EXPECT_EQ(second("jac_jac_curvature_xi_xi", xi), part(curvature_derivatives(jet).value(), 2));
    EXPECT_EQ(second("jac_jac_speed_xi_xi", xi),
              part(speed_derivatives(path.preimage_jet<2>(xi)), 2));
    EXPECT_EQ(second("jac_jac_arc_length_xi_xi", xi),
              part(speed_derivatives(path.preimage_jet<1>(xi)), 1));
    EXPECT_EQ(values.all(xi) + first.all(xi) + second.all(xi), 0);
  }
}

// A Jacobian has the inputs of its function and then its results; one result for each pair of a
// result and an input.
TEST(CodeGeneration, JacobiansAreNamedAndShapedAsCasadiExpects) {
  test::Random random("jacobians");
  const Compiled code = compiled(test::random_path<PlanarPath<2>>(random, 2), {"road", true});
  const std::vector<std::string> names = {"road", "jac_road", "jac_jac_road"};
  for (std::size_t order = 0; order + 1 < names.size(); ++order) {
    const External function(code, names[order]), jacobian(code, names[order + 1]);
    ASSERT_EQ(jacobian.inputs(), function.inputs() + function.results());
    ASSERT_EQ(jacobian.results(), function.inputs() * function.results());
    for (Whole i = 0; i < function.inputs(); ++i) {
      EXPECT_EQ(jacobian.input_name(i), function.input_name(i));
    }
    for (Whole o = 0; o < function.results(); ++o) {
      const auto result = function.result_pattern(o);
      const auto unused = jacobian.input_pattern(function.inputs() + o);
      EXPECT_EQ(jacobian.input_name(function.inputs() + o), "out_" + function.result_name(o));
      EXPECT_EQ(unused.rows, result.rows);
      EXPECT_EQ(unused.columns, result.columns);
      EXPECT_EQ(unused.entries, 0);
      for (Whole i = 0; i < function.inputs(); ++i) {
        const Whole at = o * function.inputs() + i;
        const auto input = function.input_pattern(i), block = jacobian.result_pattern(at);
        EXPECT_EQ(jacobian.result_name(at),
                  "jac_" + function.result_name(o) + "_" + function.input_name(i));
        EXPECT_EQ(block.rows, result.rows * result.columns);
        EXPECT_EQ(block.columns, input.rows * input.columns);
        EXPECT_EQ(block.entries, input.entries == 0 ? 0 : result.entries);
      }
    }
    EXPECT_EQ(jacobian.input_name(-1) + jacobian.input_name(jacobian.inputs()), "");
    EXPECT_EQ(jacobian.result_name(-1) + jacobian.result_name(jacobian.results()), "");
    EXPECT_EQ(jacobian.input_pattern(-1).rows + jacobian.result_pattern(jacobian.results()).rows,
              0);
  }
}

TEST(CodeGeneration, ExternalFunctionsFailWhereAValueThatIsAskedForDoesNotExist) {
  using A = Quaternion<double>;
  const SpatialPhCurve<0> curve({0.0, 0.0, 0.0}, BernsteinPolynomial<A, 0>({A{1.0, 0.0, 0.0, 0.0}}),
                                1.0);
  const Compiled code =
      compiled(SpatialPath<0>::create({0.0, 1.0}, {curve}, false).value(), {"line", true});
  const External values(code, "line"), first(code, "jac_line");
  EXPECT_TRUE(values("curvature", 0.5).has_value());
  EXPECT_FALSE(values("curvature", 1.5).has_value());
  EXPECT_FALSE(values("position", std::nan("")).has_value());
  EXPECT_FALSE(first("jac_curvature_xi", 0.5).has_value());
  EXPECT_TRUE(first("jac_frame_xi", 0.5).has_value());
  EXPECT_EQ(first.all(0.5), 1);
  // An input that is not given is zero.
  std::vector<const double*> arg(1, nullptr);
  std::vector<double> x(3, 7.0);
  std::vector<double*> res(static_cast<std::size_t>(values.results()), nullptr);
  res[0] = x.data();
  EXPECT_EQ(code.function<int(const double**, double**, Whole*, double*, int)>("line")(
                arg.data(), res.data(), nullptr, nullptr, 0),
            0);
  EXPECT_EQ(x, std::vector<double>(3, 0.0));
}

}  // namespace
}  // namespace hodograph
