// SPDX-License-Identifier: MIT
#include "hodograph/planning/mitred_world.hpp"

#include "mitred_index.hpp"

namespace hodograph {

Result<MitredWorld> MitredWorld::create(World world, double offset,
                                        std::optional<double> bounds_offset) {
  auto index = planning_detail::MitredIndex::create(std::move(world), offset,
                                                    bounds_offset.value_or(offset));
  if (!index) return index.fault();
  return MitredWorld(std::move(*index));
}

const World& MitredWorld::world() const { return index_->world(); }
double MitredWorld::offset() const { return index_->offset(); }
double MitredWorld::bounds_offset() const { return index_->bounds_offset(); }
std::size_t MitredWorld::corner_count() const { return index_->pieces().corners.size(); }

std::optional<Vector2<double>> MitredWorld::mitre_tip(const WorldVertex& vertex,
                                                      std::optional<double> d) const {
  const auto v = index_->find(vertex);
  if (!v || index_->kind(*v) != planning_detail::VertexKind::tip) return std::nullopt;
  const double offset = d.value_or(index_->ring_of(*v).offset);
  return offset == 0.0 ? index_->point(*v) : index_->meeting_point(*v, offset);
}

WorldPosition MitredWorld::locate(const Vector2<double>& point) const {
  return index_->locate(point, nullptr);
}

bool MitredWorld::sees(const Vector2<double>& a, const Vector2<double>& b) const {
  if (a == b) return locate(a).kind == WorldPosition::Kind::free;
  return !index_->obstruction(a, b, nullptr);
}

}  // namespace hodograph
