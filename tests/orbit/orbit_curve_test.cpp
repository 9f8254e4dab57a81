// SPDX-License-Identifier: MIT
// A periodic orbit as a curve, in both frames, against the catalogue and the equations of motion.
#include "hodograph/orbit/orbit_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hodograph/orbit/motion_series.hpp"

namespace hodograph {
namespace {

constexpr double eps = std::numeric_limits<double>::epsilon();

const PeriodicOrbit& gateway() {
  static const PeriodicOrbit orbit = lunar_gateway_nrho().value();
  return orbit;
}

OrbitCurve curve_of(OrbitFrame frame = OrbitFrame::rotating,
                    OrbitParameter parameter = OrbitParameter::time, std::size_t revolutions = 1) {
  return OrbitCurve::make(gateway(), frame, parameter, revolutions).value();
}

/// One row of a catalogue's table.
struct Row {
  double time;
  Vector3<double> position, velocity;
};

// JPL three-body periodic orbit catalogue, Earth-Moon halo L2, normalised units, 389703 km and
// 382981 s: twenty rows of the orbit with apolune height -0.18551533506611556.
const std::vector<Row> catalogue_rows{
    {0.05373219666677577,
     {1.0271050899076946, -0.006140009205631968, -0.18481330482746303},
     {-0.007745169884451014, -0.11381355228163179, 0.026145022911501708}},
    {0.17086065327793537,
     {1.0252139530388549, -0.019165223202884774, -0.1783805071008661},
     {-0.02450291165936934, -0.1074586174557688, 0.08399848067567124}},
    {0.27989170514963463,
     {1.0217076196753883, -0.03026387662377412, -0.16617452859394946},
     {-0.0397316123280412, -0.09498283378807916, 0.14052427768963702}},
    {0.39670363082314725,
     {1.0161482888472866, -0.0401665783430775, -0.14594872941911616},
     {-0.0552803826276057, -0.07278383232995099, 0.20724124660667997}},
    {0.5096883552881881,
     {1.0091121284970068, -0.046583953771606505, -0.11833734819381111},
     {-0.06898000391824712, -0.03787983842135479, 0.28456188877864436}},
    {0.6200360538790062,
     {1.0008642913004782, -0.04773291334267339, -0.08154878156061096},
     {-0.07995849914396873, 0.024607450224177548, 0.3900714166071005}},
    {0.7301836888384123,
     {0.9916825985626885, -0.036920877600672454, -0.028694299392266545},
     {-0.08506925450498222, 0.22810608222400425, 0.6066293657718391}},
    {0.7341138679028354,
     {0.9913484416747111, -0.03598816969641981, -0.026283349841163692},
     {-0.08496998888865384, 0.2468937731564311, 0.6203901467366515}},
    {0.783205232535178,
     {0.9874623033880428, -0.009955716667572202, 0.008251055611329959},
     {-0.051541537219545366, 1.1985662256747278, 0.591003546145527}},
    {0.7890072062965643,
     {0.9872640879247317, -0.0021410448799789434, 0.010570768073499189},
     {-0.012736905377821683, 1.4616548737091442, 0.15220475112276513}},
    {0.7908477155289708,
     {0.9872554314052965, 0.0005696659165749227, 0.010674310341163503},
     {0.003412593328775197, 1.4758410501759962, -0.0408572756026746}},
    {0.7939621283748344,
     {0.987307360980658, 0.005070215891346069, 0.010056072711938832},
     {0.02916664600574652, 1.3946920316949678, -0.34530110245637996}},
    {0.8160002977309968,
     {0.9887722950511179, 0.024766614023128356, -0.0052139039200314275},
     {0.08060888893437881, 0.5459141769340043, -0.751678729180678}},
    {0.8469833972251473,
     {0.9913631795189994, 0.036030915446690945, -0.02639089753970868},
     {0.0849753327895355, 0.24601767681354839, -0.6197663674290864}},
    {0.9589765750814097,
     {1.0007113251724005, 0.04768436787432592, -0.08080104618170557},
     {0.08011514050315996, 0.026198277443609756, -0.39241273707484947}},
    {1.0714175192841475,
     {1.0091246845505661, 0.04657705109875618, -0.11838914025647096},
     {0.06895948485035876, -0.03795219291807592, -0.2844202954341658}},
    {1.185829267039129,
     {1.016237073050948, 0.04004915451379478, -0.14628140192508948},
     {0.05507391913603685, -0.07316771751074254, -0.20625451575660417}},
    {1.2981728805648791,
     {1.0215934572508891, 0.030534851112081, -0.16577053650469162},
     {0.040123471264726984, -0.09455947774654262, -0.1420636444473911}},
    {1.4137366824650601,
     {1.0253030081494778, 0.018769910816222955, -0.1786856830591141},
     {0.02398200893122232, -0.10776328875448997, -0.0821513864147869}},
    {1.5224897650979297,
     {1.0270670817696752, 0.006674853994052738, -0.18468498315478032},
     {0.008422069572765959, -0.11368811816105893, -0.028438560091916934}},
};

// What the catalogue's table is held to (LU). Its velocities carry the same error, and where the
// orbit is fast that of the times: a shift of the time by as much changes the velocity by that
// times the acceleration.
constexpr double catalogue_error = 1e-11;

void expect_row(const OrbitCurve& curve, const Row& row) {
  const auto jet = curve(row.time);
  EXPECT_LE(largest_component(jet[0] - row.position), catalogue_error) << row.time;
  EXPECT_LE(largest_component(jet[1] - row.velocity),
            catalogue_error * (1.0 + largest_component(jet[2])))
      << row.time;
}

/// The rows of the catalogue's whole table, where its file is named; it is not part of this
/// repository.
std::vector<Row> named_table() {
  std::vector<Row> rows;
  const char* name = std::getenv("HODOGRAPH_NRHO_CSV");
  if (name == nullptr) return rows;
  std::ifstream file(name);
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) {
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream numbers(line);
    Row row{};
    numbers >> row.time >> row.position.x >> row.position.y >> row.position.z >> row.velocity.x >>
        row.velocity.y >> row.velocity.z;
    EXPECT_TRUE(numbers) << line;
    rows.push_back(row);
  }
  EXPECT_EQ(rows.size(), 926U) << name;
  return rows;
}

TEST(OrbitCurve, AgreesWithTheCatalogue) {
  ASSERT_EQ(catalogue_rows.size(), 20U);
  const OrbitCurve curve = curve_of();
  for (const Row& row : catalogue_rows) expect_row(curve, row);
  for (const Row& row : named_table()) expect_row(curve, row);
}

// Summing a series of falling terms: the terms' own rounding, three roundings for each of the first
// few, and as many again for every factor that a derivative brings.
constexpr double series_error = 16 * eps;

TEST(OrbitCurve, IsThePropagatedMotion) {
  const OrbitCurve curve = curve_of();
  for (int i = 0; i <= 60; ++i) {
    const double time = curve.end() * i / 60;
    const auto motion = propagate(earth_moon_system, gateway().initial, time);
    ASSERT_TRUE(motion);
    const auto exact = motion_derivatives(earth_moon_system, motion->state);
    const auto jet = curve(time);
    for (std::size_t r = 0; r < 5; ++r) {
      Vector3<double> difference;
      double size = 0.0;
      for (std::size_t k = 0; k < 3; ++k) {
        difference[k] = static_cast<double>(jet[r][k] - exact[r][k]);
        size = std::max(size, std::abs(jet[r][k]));
      }
      EXPECT_LE(largest_component(difference), series_error * size) << time << ' ' << r;
    }
  }
}

TEST(OrbitCurve, IsSmoothWhereSeriesMeet) {
  // Steps far finer than the series': Taylor's formula from one sample to the next leaves
  // h^(5-r)/(5-r)! times a fifth derivative, which changes by less than a factor 2 on the way.
  const OrbitCurve curve = curve_of();
  constexpr int samples = 1 << 16;
  const double h = curve.end() / samples;
  auto before = curve(0.0);
  double fifth_before = 0.0;
  for (int i = 1; i <= samples; ++i) {
    const auto after = curve(i * h);
    const double fifth = largest_component(after[4] - before[4]) / h;
    for (std::size_t r = 0; r < 4; ++r) {
      Vector3<double> predicted = before[r];
      double power = 1.0;
      for (std::size_t k = r + 1; k < 5; ++k) {
        power *= h / static_cast<double>(k - r);
        predicted += power * before[k];
      }
      const double remainder =
          2.0 * std::max(fifth, fifth_before) * power * h / static_cast<double>(5 - r);
      // The parameter i h itself is rounded, which moves each derivative by the next.
      const double rounding = series_error * largest_component(after[r]) +
                              eps * curve.end() * largest_component(after[r + 1]);
      ASSERT_LE(largest_component(after[r] - predicted), 2.0 * rounding + remainder)
          << "derivative " << r << " between samples " << i - 1 << " and " << i;
    }
    // The fourth derivative has no such formula; the state tells it.
    const auto own = motion_derivatives(earth_moon_system, OrbitState<double>{after[0], after[1]});
    const double nearest = norm(offset_from_smaller(earth_moon_system, after[0]));
    // An error of the position is a relative error of the distance, and snap is a sum of powers of
    // its reciprocal up to the seventh.
    const double amplification = 8.0 + 7.0 / nearest;
    ASSERT_LE(largest_component(own[4] - after[4]),
              series_error * amplification * (1.0 + largest_component(after[4])))
        << i;
    before = after;
    fifth_before = fifth;
  }
}

TEST(OrbitCurve, ClosesAndRepeats) {
  const OrbitCurve four = curve_of(OrbitFrame::rotating, OrbitParameter::time, 4);
  const OrbitCurve turns = curve_of(OrbitFrame::rotating, OrbitParameter::revolutions, 4);
  EXPECT_EQ(turns.end(), 4.0);
  EXPECT_EQ(four.end(), static_cast<double>(4.0L * gateway().period));
  const double period = static_cast<double>(gateway().period);
  for (int i = 0; i < 64; ++i) {
    const double part = i / 64.0;  // exact
    const auto first = turns(part);
    EXPECT_EQ(turns(part + 3.0), first);
    EXPECT_EQ(turns(part - 1.0), first);
    const auto timed = four(part * period);
    double factor = 1.0;
    for (std::size_t r = 0; r < 5; ++r) {
      // part * period is rounded, which moves derivative r by derivative r + 1.
      const double shift = r < 4 ? eps * period * largest_component(timed[r + 1])
                                 : eps * period * largest_component(timed[4]) * 1000.0;
      EXPECT_LE(largest_component(first[r] - factor * timed[r]),
                factor * (series_error * largest_component(timed[r]) + shift));
      factor *= period;
    }
  }
  EXPECT_EQ(turns(0.0), turns(4.0));
  // Mirror symmetry about y = 0.
  const auto there = turns(0.375), back = turns(0.625);
  EXPECT_EQ(there[0].x, back[0].x);
  EXPECT_EQ(there[0].y, -back[0].y);
  EXPECT_EQ(there[1].y, back[1].y);
  EXPECT_EQ(there[3].z, -back[3].z);
}

TEST(OrbitCurve, ObeysGravityInTheInertialFrame) {
  // X'' = -(1-μ) X/|X|³ - μ (X - M)/|X - M|³ - μ M, with the Moon M on its circle and the Earth,
  // the origin, accelerated towards it.
  const double mu = earth_moon_system.mass_ratio;
  const OrbitCurve curve = curve_of(OrbitFrame::earth_centred_inertial, OrbitParameter::time, 4);
  for (int i = 0; i <= 1000; ++i) {
    const double time = curve.end() * i / 1000;
    const auto jet = curve(time);
    const Vector3<double> moon{std::cos(time), std::sin(time), 0.0};
    const Vector3<double> from_moon = jet[0] - moon;
    const double r1 = norm(jet[0]), r2 = norm(from_moon);
    const Vector3<double> gravity =
        -((1.0 - mu) / (r1 * r1 * r1)) * jet[0] - (mu / (r2 * r2 * r2)) * from_moon - mu * moon;
    // Positions of size 1 are rounded; the Moon's pull feels that over its distance, threefold.
    const double bound = 16.0 * eps * (1.0 + 3.0 * mu / (r2 * r2 * r2)) +
                         series_error * (largest_component(gravity) + 4.0 * norm(jet[1]));
    EXPECT_LE(largest_component(jet[2] - gravity), bound) << time;
  }
}

TEST(OrbitCurve, InertialAndRotatingAgreeThroughTheFrame) {
  const OrbitCurve rotating = curve_of(OrbitFrame::rotating, OrbitParameter::time, 4);
  const OrbitCurve inertial = curve_of(OrbitFrame::earth_centred_inertial, OrbitParameter::time, 4);
  for (int i = 0; i <= 100; ++i) {
    const double time = inertial.end() * i / 100;
    const auto back = from_earth_centred_inertial(earth_moon_system, inertial(time), time);
    const auto jet = rotating(time);
    double size = 1.0;
    for (std::size_t r = 0; r < 5; ++r) {
      size = std::max(size, largest_component(jet[r]));
      EXPECT_LE(largest_component(back[r] - jet[r]), 4.0 * series_error * size) << r;
    }
  }
  // After one revolution the inertial curve is not closed: the Moon has gone on.
  const double period = static_cast<double>(gateway().period);
  EXPECT_GT(norm(inertial(period)[0] - inertial(0.0)[0]), 1.0);
}

TEST(OrbitCurve, RefusalsSayWhy) {
  const auto sentence = [](const Result<OrbitCurve>& r) {
    return r ? std::string("accepted") : r.fault().sentence;
  };
  EXPECT_EQ(sentence(OrbitCurve::make(gateway(), OrbitFrame::rotating, OrbitParameter::time, 0)),
            "the number of revolutions is 0; it must be at least 1");
  PeriodicOrbit orbit = gateway();
  orbit.period = 0.0L;
  EXPECT_EQ(sentence(OrbitCurve::make(orbit)),
            "the orbit's period is 0; it must be positive and finite");
  orbit = gateway();
  orbit.period = 1.5L;
  const auto open = OrbitCurve::make(orbit);
  EXPECT_NE(sentence(open).find("the orbit misses a perpendicular crossing of y = 0 half a period "
                                "later by "),
            std::string::npos)
      << sentence(open);
  EXPECT_EQ(open.fault().code, FaultCode::not_continuous);
  orbit = gateway();
  orbit.initial.velocity.x = 0.25L;
  EXPECT_NE(sentence(OrbitCurve::make(orbit))
                .find("the orbit misses a perpendicular crossing of y = 0 at its start by 0.25; "),
            std::string::npos);
  orbit.initial.position.z = HUGE_VALL;
  EXPECT_EQ(sentence(OrbitCurve::make(orbit)),
            "the initial state's position z is inf; all six components must be finite");
}

}  // namespace
}  // namespace hodograph
