// SPDX-License-Identifier: MIT
// What is known of rational PH curves, for programs: numbers are strings "p" or "p/q", polynomials
// lists of coefficients, the constant one first.
#include <cmath>

#include "cli/rationals.hpp"
#include "hodograph/io/dxf.hpp"

namespace hodograph::cli {
Json json_of(const RationalPolynomial& p) {
  Json list = Json::array();
  for (const Rational& c : p.coefficients()) list.push_back(to_text(c));
  return list;
}
Json json_of(const RationalVector& v) { return {to_text(v.x), to_text(v.y), to_text(v.z)}; }
Json json_of(const VectorPolynomial& v) {
  return Json::array({json_of(v.x), json_of(v.y), json_of(v.z)});
}
Json json_of(const QuaternionPolynomial& a) {
  return Json::array({json_of(a.w), json_of(a.x), json_of(a.y), json_of(a.z)});
}
Json json_of(const RealRoot& root) {
  const double value = root.to_double();
  return {{"value", std::isfinite(value) ? Json(value) : Json()},
          {"order", root.multiplicity()},
          {"exact", root.is_rational() ? Json(to_text(root.lower())) : Json()},
          {"lower", to_text(root.lower())},
          {"upper", to_text(root.upper())},
          {"factor", json_of(root.factor())}};
}

namespace {

template <class Function>
Json json_of_fraction(const Function& f) {
  return {{"numerator", cli::json_of(f.numerator())},
          {"denominator", cli::json_of(f.denominator())}};
}
Json json_of(const std::vector<RationalPolynomial>& list) {
  Json json = Json::array();
  for (const RationalPolynomial& p : list) json.push_back(cli::json_of(p));
  return json;
}
Json json_of(const std::vector<RealRoot>& roots) {
  Json json = Json::array();
  for (const RealRoot& root : roots) json.push_back(cli::json_of(root));
  return json;
}

Json json_of(const DegreeRow& row) {
  return {{"degree", row.degree},
          {"dimension", row.dimension},
          {"points", row.points},
          {"polynomial", row.polynomials},
          {"rational", row.rationals()},
          {"predicted", row.predicted.value},
          {"prediction_exact", row.predicted.exact}};
}

}  // namespace

Json json_of(const DescribedCurve& described) {
  const RationalPhCurve& curve = described.curve;
  Json json = {{"index", described.index ? Json(*described.index) : Json()},
               {"kind", std::string(name_of(curve.kind()))},
               {"r", json_of_fraction(curve.position())},
               {"lambda", json_of_fraction(curve.lambda())},
               {"speed", json_of_fraction(curve.speed())}};
  json["arc_length"] = {{"rational", described.length.obstruction.is_zero()},
                        {"function", json_of_fraction(described.length.rational)},
                        {"obstruction", json_of_fraction(described.length.obstruction)}};
  json["poles"] = json_of(described.poles);
  if (described.stationary) {
    Json& list = json["stationary_points"] = json_of(*described.stationary);
    for (std::size_t i = 0; i < list.size(); ++i) {
      list[i]["cusp"] = (*described.stationary)[i].multiplicity() % 2 != 0;
    }
  } else {
    json["stationary_points"] = Json();
  }
  json["osculating_planes"] = described.planes ? json_of_fraction(*described.planes) : Json();
  json["motion"] = {{"primal", json_of(described.motion.primal)},
                    {"dual", json_of(described.motion.dual)}};
  const auto& parts = described.decomposition;
  Json pieces = Json::array();
  for (const auto& piece : parts.pieces) {
    pieces.push_back({{"pole", json_of(piece.pole)},
                      {"lambda", json_of_fraction(piece.lambda)},
                      {"r", json_of_fraction(piece.curve)}});
  }
  json["decomposition"] = {{"pieces", std::move(pieces)},
                           {"polynomial_lambda", json_of(parts.polynomial_lambda)},
                           {"constant", json_of(parts.constant)}};
  Json& coordinates = json["coordinates"] = Json();
  for (const Rational& c : described.coordinates) coordinates.push_back(to_text(c));
  return json;
}

Json json_of(const RationalAnswer& answer) {
  const SolutionSpace& space = answer.space;
  const Reduction& reduction = space.preimage_reduction();
  const auto frame = RationalPhCurve::create(space.preimage(), VectorFunction()).value();
  const auto axes = frame.frame();
  Json json = {{"A", json_of(*answer.problem.a)},
               {"alpha", json_of(space.alpha())},
               {"degree", space.degree()},
               {"reduction",
                {{"was_reduced", reduction.was_reduced()},
                 {"A", json_of(reduction.reduced)},
                 {"factor", Json::array({json_of(reduction.re), json_of(reduction.im)})}}},
               {"indicatrix", json_of(space.indicatrix())},
               {"norm", json_of(norm_polynomial(space.preimage()))},
               {"planar", frame.is_planar()},
               {"inflections", json_of(answer.inflections)},
               {"torsion_zeros", json_of(answer.torsion_zeros)}};
  json["frame"] = {{"e1", json_of(axes.e1)},
                   {"e2", json_of(axes.e2)},
                   {"e3", json_of(axes.e3)},
                   {"angular_velocity", json_of(frame.angular_velocity())},
                   {"rotation_minimising", frame.frame_is_rotation_minimising()}};
  Json strata = Json::array();
  for (const PoleStratum& s : answer.existence.strata) {
    strata.push_back({{"order", s.order},
                      {"poles", json_of(s.poles)},
                      {"rank_two", json_of(s.rank_two)},
                      {"rank_one", json_of(s.rank_one)},
                      {"freedom", s.freedom()}});
  }
  json["existence"] = {{"exists", answer.existence.exists},
                       {"reason", answer.existence.reason},
                       {"freedom", answer.existence.freedom},
                       {"strata", std::move(strata)}};
  Json& taylor = json["taylor"] = Json::array();
  for (const TaylorRow& row : answer.taylor) {
    Json f = Json::array();
    for (const VectorPolynomial& v : row.coefficients) f.push_back(json_of(v));
    taylor.push_back({{"factor", json_of(row.factor)}, {"order", row.order}, {"f", std::move(f)}});
  }
  json["dimension"] = json_of(answer.rows.back());
  Json& rows = json["dimensions"] = Json::array();
  for (const DegreeRow& row : answer.rows) rows.push_back(json_of(row));
  json["radical"] = json_of(space.radical());
  if (answer.basis) {
    json["lambda_numerators"] = json_of(space.lambda_numerators());
    json["rational_length_numerators"] = json_of(space.rational_length_numerators());
    Json& basis = json["basis"] = Json::array();
    for (const VectorPolynomial& b : *answer.basis) {
      basis.push_back({{"B", json_of(b)},
                       {"kind", std::string(name_of(kind_of(b, space.alpha())))},
                       {"mu", json_of(mu_of(b, space.alpha(), space.indicatrix()))}});
    }
  } else {
    json["lambda_numerators"] = Json();
    json["rational_length_numerators"] = Json();
    json["basis"] = Json();
  }
  json["basis_refused"] = answer.basis ? Json() : Json(answer.basis_refused);
  Json& curves = json["curves"] = Json::array();
  for (const DescribedCurve& curve : answer.curves) curves.push_back(json_of(curve));
  json["curves_left_out"] = answer.curves_left_out;
  json["chosen"] = answer.chosen ? json_of(*answer.chosen) : Json();
  return json;
}

Json nurbs_of(const DescribedCurve& curve, double begin, double end) {
  const auto pieces = rational_bezier(curve.curve, begin, end).value();
  Json list = Json::array(), points = Json::array(), weights = Json::array(), knots = Json::array();
  const std::size_t degree = pieces.front().degree();
  double scale = 1.0;  // weights of a piece may all be multiplied by one number
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const SpatialRationalBezier& piece = pieces[i];
    Json one = {{"begin", piece.begin}, {"end", piece.end}, {"degree", piece.degree()}};
    one["control_points"] = Json::array();
    one["weights"] = piece.weights;
    for (const auto& p : piece.control_points) one["control_points"].push_back(list_of(p));
    if (i > 0) scale *= pieces[i - 1].weights.back() / piece.weights.front();
    if (!std::isnormal(scale)) {
      throw Error(Fault{FaultCode::unsupported,
                        "the weights of one NURBS curve leave the range of doubles near t = " +
                            to_text(piece.begin) + "; right would be a shorter interval",
                        std::nullopt, "interval", piece.begin, std::nullopt});
    }
    for (std::size_t k = i == 0 ? 0 : 1; k < piece.weights.size(); ++k) {
      points.push_back(one["control_points"][k]);
      weights.push_back(scale * piece.weights[k]);
    }
    for (std::size_t k = 0; k < (i == 0 ? degree + 1 : degree); ++k) knots.push_back(piece.begin);
    list.push_back(std::move(one));
  }
  for (std::size_t k = 0; k <= degree; ++k) knots.push_back(pieces.back().end);
  return {{"pieces", std::move(list)},
          {"nurbs",
           {{"degree", degree},
            {"knots", std::move(knots)},
            {"control_points", std::move(points)},
            {"weights", std::move(weights)}}}};
}

std::string dxf_of(const DescribedCurve& curve, double begin, double end) {
  const VectorFunction& r = curve.curve.position();
  const RationalFunction height(r.numerator().z, r.denominator());
  if (!height.is_polynomial() || !height.numerator().is_constant()) {
    throw Error(Fault{FaultCode::outside_domain,
                      "a drawing holds a curve in a plane z = constant, and this one has z = " +
                          to_text(height) + "; right would be --nurbs",
                      std::nullopt, "z", std::nullopt, std::nullopt});
  }
  DxfCurves curves;
  curves.layer = "curve";
  for (const SpatialRationalBezier& piece : rational_bezier(curve.curve, begin, end).value()) {
    RationalBezier flat{piece.begin, piece.end, {}, piece.weights};
    for (const auto& p : piece.control_points) flat.control_points.push_back({p.x, p.y});
    curves.pieces.push_back(std::move(flat));
  }
  return to_dxf(std::vector<DxfCurves>{std::move(curves)}).value();
}

}  // namespace hodograph::cli
