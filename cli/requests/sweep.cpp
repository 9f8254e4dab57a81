// SPDX-License-Identifier: MIT
// The request "sweep".
#include "cli/frames.hpp"
#include "cli/requests/handlers.hpp"
#include "cli/sweeps.hpp"

namespace hodograph::cli {
namespace {

/// The most triangles of one request: meshes are measured and written, not answered.
constexpr std::size_t most_request_triangles = 20'000'000;

void take_profile(Members profile, SweepRequest& request) {
  int given = 0;
  const auto has = [&](const char* name) { return profile.has(name) && ++given == 1; };
  if (has("circle")) request.circle = profile.number("circle");
  if (has("ellipse")) request.ellipse = profile.numbers("ellipse", 2);
  if (has("rectangle")) request.rectangle = profile.numbers("rectangle", 2);
  if (has("ribbon")) request.ribbon = profile.numbers("ribbon", 2);
  if (has("polygon")) {
    for (const auto& corner : profile.vectors("polygon", 2)) {
      request.polygon.push_back({corner[0], corner[1]});
    }
    if (request.polygon.size() < 3) profile.refuse("polygon", "a polygon needs at least 3 corners");
  }
  if (profile.has("document") || profile.has("file")) {
    ++given;
    request.curve = profile.document().path;
  }
  if (given != 1) {
    profile.refuse("circle",
                   "give one of \"circle\", \"ellipse\", \"rectangle\", \"polygon\", \"ribbon\", "
                   "\"document\" and \"file\"");
  }
  profile.require_all_known();
}

}  // namespace

Answer answer_sweep(Members& request) {
  const PathDocument document = request.document();
  SweepRequest sweep;
  std::vector<double> track;
  const bool family = request.has("along") || request.has("turn");
  if (request.has("track")) track = request.numbers("track", 2);
  if (family) {
    if (request.has("along")) {
      for (const auto& c : request.vectors("along", 3)) sweep.along.push_back({c[0], c[1], c[2]});
    }
    if (request.has("turn")) {
      for (const auto& q : request.vectors("turn", 4)) {
        sweep.turn.push_back({q[0], q[1], q[2], q[3]});
      }
    }
    if (!sweep.is_family()) request.refuse("along", "a tubular family needs coefficients");
  }
  if (static_cast<int>(family) + static_cast<int>(!track.empty()) +
          static_cast<int>(request.has("profile")) !=
      1) {
    request.refuse("profile", "give a profile, a tubular family (along, turn) or a track");
  }
  if (request.has("profile")) take_profile(request.object("profile"), sweep);
  sweep.frame =
      request.word("frame", {std::begin(sweep_frames), std::end(sweep_frames)}, sweep_frames[0]);
  sweep.gamma = request.maybe_number("gamma");
  if (request.has("choose_gamma")) {
    sweep.found_gamma = request.word("choose_gamma", {found_gammas.begin(), found_gammas.end()});
    if (sweep.gamma) {
      request.refuse("choose_gamma", "gamma is given or chosen, one of them");
    }
  }
  if (request.has("scale")) sweep.scale = request.numbers("scale");
  sweep.tolerance = request.maybe_number("tolerance");
  sweep.most_triangles = request.count("most_triangles", 1'000'000);
  request.require_at_most("most_triangles", sweep.most_triangles, most_request_triangles);
  sweep.caps = !request.truth("open_ends", false);
  sweep.allow_contact = request.truth("allow_contact", false);
  const std::string file = request.text("out", "");
  request.require_all_known();
  Answer answer;
  if (!track.empty()) {
    if (!file.empty()) request.refuse("out", "a track is in the result, not in a file");
    answer.result = json_of(made_track(document.path, sweep, track[0], track[1]));
    return answer;
  }
  const std::string format = file.empty() ? "" : sweep_format(file, "");
  const MadeSweep made = made_sweep(document.path, sweep);
  const MeasuredMesh mesh = measured_mesh(made, sweep, format);
  answer.result = json_of(made, mesh);
  if (!file.empty()) {
    const auto step = write_sweep(made, sweep, &mesh, document, file, format);
    answer.result["out"] = {{"file", file}, {"format", format}};
    if (step) {
      answer.result["out"]["faces"] = step->faces;
      answer.result["out"]["solid"] = step->solid;
    }
  }
  return answer;
}

}  // namespace hodograph::cli
