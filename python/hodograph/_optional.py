# SPDX-License-Identifier: MIT
"""The names that optional components bring, each from an extension module of its own.

They are loaded when one of their names is first used: nobody pays for a library he does not use,
and a build without it still has everything else.
"""

from __future__ import annotations

import importlib
import importlib.util
from typing import Any

#: extension module: (what it needs to be built, the public names in it)
MODULES: dict[str, tuple[str, tuple[str, ...]]] = {
    "_certify": ("Arb", ()),
    "_orbit": ("Boost", (
        "HeldQuantity", "OrbitCurve", "OrbitFrame", "OrbitParameter", "PeriodicOrbit",
        "Propagation", "ThreeBodySystem", "VariationalPropagation", "continue_to_period",
        "correct_symmetric_orbit", "crossing_tolerance", "earth_moon_system",
        "from_earth_centred_inertial", "jacobi_constant", "lunar_gateway_nrho",
        "mean_synodic_month_days", "motion_derivatives", "next_plane_crossing", "propagate",
        "propagate_variations", "pseudo_potential", "pseudo_potential_gradient",
        "pseudo_potential_hessian", "smaller_primary_inertial", "synodic_9_2_nrho",
        "three_body_acceleration", "to_earth_centred_inertial")),
    "_rational": ("FLINT and Clp", (
        "ChosenPreimage", "ConeTest", "CurveKind", "CuspFreeAnswer", "DegreeSearch",
        "DualQuaternionPolynomial", "Existence", "HermiteCurves", "PartialFraction",
        "PartialFractions", "PoleStratum", "PolynomialFactor", "QuaternionPolynomial",
        "RationalCurveDecomposition", "RationalCurvePiece", "RationalDirection", "RationalFrame",
        "RationalFunction", "RationalIntegral", "RationalPhCurve", "RationalPolynomial", "RealRoot",
        "Reduction", "SearchedSpace", "SolutionSpace", "VectorFunction", "VectorPolynomial",
        "chosen_preimage", "cone_test", "count_real_roots", "cusp_free_curve", "determinant",
        "divides", "existence", "framing_motion", "gcd", "holds", "integral", "irreducible_factors",
        "is_framing", "is_nonnegative", "is_positive", "kind_of", "largest_input_degree",
        "largest_solution_degree", "parse_definitions", "partial_fractions", "preimage_between",
        "radical", "rational_direction", "real_roots", "reduction", "smallest_cusp_free", "solve",
        "square_free_factors", "trajectory")),
    "_control": ("Ipopt", (
        "AscentReference", "AscentSolved", "AscentStart", "FollowAim", "FollowIndependent",
        "FollowNode", "FollowStart", "Following", "GeneratedCode", "HorizonPlan", "OffsetLimits",
        "PoweredAscent", "PoweredObjective", "ProgressBy", "RecedingHorizon", "ReferenceJet", "ReferencePath",
        "Repropagation", "SolverIteration", "TrackingAscent", "TrackingSetting",
        "arrival_distance_km", "ascent_start", "ascent_starts", "coordinate_rates", "follow",
        "generate_code", "moon_radius_km", "most_name_letters", "offset_limits", "place_of",
        "powered_ascent", "powered_ascent_along_path", "progress_stretch", "tracking_ascent")),
    "_cad": ("OpenCASCADE", (
        "StepModel", "largest_cad_degree", "save_step", "step_of")),
}

_HOME = {name: module for module, (_, names) in MODULES.items() for name in names}

#: the public names of the components that this build has
NAMES = tuple(name for name, module in _HOME.items()
              if importlib.util.find_spec(f"hodograph.{module}") is not None)


def load(name: str) -> Any:
    """The object called ``name``, or AttributeError with what is missing."""
    module = _HOME.get(name)
    if module is None:
        raise AttributeError(f"module 'hodograph' has no attribute {name!r}")
    try:
        return getattr(importlib.import_module(f"hodograph.{module}"), name)
    except ModuleNotFoundError as error:
        raise AttributeError(
            f"hodograph.{name} needs a build with {MODULES[module][0]}; this one was made without"
        ) from error
