// SPDX-License-Identifier: MIT
// The members of a path document: the one list that the reader checks a text against.
#pragma once

#include <array>
#include <string_view>

namespace hodograph::io_detail {

enum class MemberKind { text, truth, whole_number, number, object, knots, segments, rows, point };

struct Member {
  std::string_view pointer;  // JSON pointer from the root
  MemberKind kind;
  bool required;  // where its parent is there
};

inline constexpr std::array document_members = {
    Member{"/format", MemberKind::text, true},
    Member{"/version", MemberKind::whole_number, true},
    Member{"/name", MemberKind::text, false},
    Member{"/units", MemberKind::object, false},
    Member{"/units/length", MemberKind::text, false},
    Member{"/units/parameter", MemberKind::text, false},
    Member{"/algebra", MemberKind::text, true},
    Member{"/preimage_degree", MemberKind::whole_number, true},
    Member{"/closed", MemberKind::truth, true},
    Member{"/knots", MemberKind::knots, true},
    Member{"/segments", MemberKind::segments, true},
    Member{"/frame", MemberKind::object, false},
    Member{"/frame/roll", MemberKind::object, true},
    Member{"/frame/roll/kind", MemberKind::text, true},
    Member{"/frame/roll/xi_begin", MemberKind::number, true},
    Member{"/frame/roll/theta_begin", MemberKind::number, true},
    Member{"/frame/roll/rate", MemberKind::number, true},
    Member{"/provenance", MemberKind::object, false},
    Member{"/provenance/program", MemberKind::text, false},
    Member{"/provenance/source", MemberKind::text, false},
    Member{"/provenance/method", MemberKind::text, false},
    Member{"/provenance/choice", MemberKind::text, false},
    Member{"/provenance/tolerance", MemberKind::number, false},
    Member{"/promises", MemberKind::object, false},
    Member{"/promises/continuity", MemberKind::object, false},
    Member{"/promises/continuity/position", MemberKind::whole_number, true},
    Member{"/promises/continuity/preimage", MemberKind::whole_number, true},
    Member{"/promises/continuity/frame", MemberKind::whole_number, true},
    Member{"/promises/continuity/angular_velocity", MemberKind::whole_number, true},
    Member{"/promises/error", MemberKind::object, false},
    Member{"/promises/error/lower", MemberKind::number, true},
    Member{"/promises/error/upper", MemberKind::number, true},
    Member{"/promises/error/certified", MemberKind::truth, true},
    Member{"/promises/error/against", MemberKind::text, false},
    Member{"/promises/arc_length", MemberKind::object, false},
    Member{"/promises/arc_length/lower", MemberKind::number, true},
    Member{"/promises/arc_length/upper", MemberKind::number, true},
    Member{"/promises/smallest_speed", MemberKind::object, false},
    Member{"/promises/smallest_speed/lower", MemberKind::number, true},
    Member{"/promises/smallest_speed/upper", MemberKind::number, true},
    Member{"/promises/largest_speed", MemberKind::object, false},
    Member{"/promises/largest_speed/lower", MemberKind::number, true},
    Member{"/promises/largest_speed/upper", MemberKind::number, true},
    Member{"/promises/curvature_bound", MemberKind::number, false},
    Member{"/promises/end", MemberKind::point, false},
    Member{"/promises/largest_curvature", MemberKind::object, false},
    Member{"/promises/largest_curvature/lower", MemberKind::number, true},
    Member{"/promises/largest_curvature/upper", MemberKind::number, true},
    Member{"/promises/clearance", MemberKind::object, false},
    Member{"/promises/clearance/world", MemberKind::text, false},
    Member{"/promises/clearance/reach", MemberKind::number, true},
    Member{"/promises/clearance/obstacles", MemberKind::rows, true},
    Member{"/promises/clearance/bounds", MemberKind::object, false},
    Member{"/promises/clearance/bounds/lower", MemberKind::number, true},
    Member{"/promises/clearance/bounds/upper", MemberKind::number, true},
    Member{"/promises/helix", MemberKind::object, false},
    Member{"/promises/helix/axis", MemberKind::object, true},
    Member{"/promises/helix/axis/x", MemberKind::number, true},
    Member{"/promises/helix/axis/y", MemberKind::number, true},
    Member{"/promises/helix/axis/z", MemberKind::number, true},
    Member{"/promises/helix/sines", MemberKind::rows, true},
};

constexpr const Member* find_member(std::string_view pointer) {
  for (const Member& member : document_members) {
    if (member.pointer == pointer) return &member;
  }
  return nullptr;
}

}  // namespace hodograph::io_detail
