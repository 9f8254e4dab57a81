// SPDX-License-Identifier: MIT
// Rolls, profiles, motions and sweeps in Python: kept as how they were made. What takes or returns
// one includes this file.
#pragma once

#include "hodograph/frame/roll.hpp"
#include "hodograph/surface/sweep.hpp"
#include "python/src/made.hpp"

namespace pybind11::detail {

template <>
struct type_caster<hodograph::FrameRoll> : hodograph_made_caster<hodograph::FrameRoll> {};
template <>
struct type_caster<hodograph::Profile> : hodograph_made_caster<hodograph::Profile> {};
template <>
struct type_caster<hodograph::Motion> : hodograph_made_caster<hodograph::Motion> {};
template <>
struct type_caster<hodograph::Sweep> : hodograph_made_caster<hodograph::Sweep> {};

}  // namespace pybind11::detail
