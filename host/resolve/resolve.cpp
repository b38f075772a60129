#include "host/resolve/resolve.hpp"

#include <algorithm>

#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/face_cells.hpp"
#include "host/resolve/hidden_bodies.hpp"
#include "host/resolve/needless_quartics.hpp"

namespace halfspace {
namespace {

Extent local_extent(const IntegerBody& body, const Scissor& scissor) {
  return {scissor.x0 - body.origin[0], scissor.y0 - body.origin[1], scissor.x1 - body.origin[0],
          scissor.y1 - body.origin[1]};
}

struct ResolvedHalfSpace {
  std::uint32_t half_space = 0;
  std::vector<FaceCells> faces;
};

void append_face(const IntegerBody& body, const Face& face, const FaceCells& found, const ArcTable& arcs,
                 ResolvedScene& scene) {
  const auto index = static_cast<std::uint32_t>(scene.faces.size());
  const auto page_x = [&body](std::int64_t x) { return static_cast<std::int32_t>(x + body.origin[0]); };
  const auto page_y = [&body](std::int64_t y) { return static_cast<std::int32_t>(y + body.origin[1]); };
  for (const NamedCell& cell : found.cells) {
    const std::int32_t y1 = page_y(cell.y1);
    for (std::int32_t y0 = page_y(cell.y0); y0 <= y1;) {  // a cell for each pair of arcs
      const ArcTable::Piece left = arcs.piece(cell.left, y0);
      const ArcTable::Piece right = arcs.piece(cell.right, y0);
      const std::int32_t last = std::min({y1, left.y1, right.y1});
      scene.cells.push_back({index, left.arc, right.arc, y0, last});
      y0 = last + 1;
    }
  }
  for (const DotSpan& span : found.spans) {
    scene.spans.push_back({index, page_y(span.y), page_x(span.x0), page_x(span.x1)});
  }
  scene.faces.push_back(face);
}

void use_arcs(const IntegerBody& body, const FaceCells& face, ArcTable& arcs) {
  for (const NamedCell& cell : face.cells) {
    const auto y0 = static_cast<std::int32_t>(cell.y0 + body.origin[1]);
    const auto y1 = static_cast<std::int32_t>(cell.y1 + body.origin[1]);
    arcs.use(cell.left, y0, y1);
    arcs.use(cell.right, y0, y1);
  }
}

std::vector<Sheets> opaque_sheets(const IntegerBody& body, const Extent& extent) {
  std::vector<Sheets> all;
  all.reserve(body.half_spaces.size());
  for (std::uint32_t i = 0; i < body.half_spaces.size(); ++i) {
    if (body.half_spaces[i].transparent) continue;
    Sheets sheets = sheets_of(body, i);
    if (sheets.shape == SheetShape::none) continue;
    drop_needless_quartics(sheets, extent);
    all.push_back(std::move(sheets));
  }
  return all;
}

void resolve_body(const IntegerScene& scene, std::uint32_t index, bool all_faces, ResolvedScene& resolved_scene) {
  const IntegerBody& body = scene.bodies[index];
  const Extent extent = local_extent(body, scene.scissor);
  if (extent.x0 > extent.x1 || extent.y0 > extent.y1) return;
  const bool hide = !all_faces && rays_start_outside(body);
  const std::vector<Sheets> opaque = opaque_sheets(body, extent);
  ArcTable arcs(body.origin[1]);
  QuarticTable table(extent.y0, extent.y1);
  std::vector<ResolvedHalfSpace> resolved;
  for (const Sheets& sheets : opaque) {
    const HiddenExits exits = hide ? hidden_exits(body, sheets) : HiddenExits{};
    resolved.push_back({sheets.half_space, face_cells(sheets, extent, exits, table, arcs)});
    for (const FaceCells& face : resolved.back().faces) use_arcs(body, face, arcs);
  }
  arcs.join_uses(index, extent, resolved_scene.arcs);
  for (const ResolvedHalfSpace& half_space : resolved) {
    for (const FaceCells& face : half_space.faces) {
      if (face.cells.empty() && face.spans.empty()) continue;
      append_face(body, {index, half_space.half_space, face.sheet}, face, arcs, resolved_scene);
    }
  }
}

}  // namespace

ResolvedScene resolve(const IntegerScene& scene, bool all_faces) {
  ResolvedScene result;
  result.arcs.reserve(2 * scene.bodies.size());  // two for a ball; moving an arc is not free
  const std::vector<bool> hidden = all_faces ? std::vector<bool>(scene.bodies.size()) : hidden_bodies(scene);
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (!hidden[i]) resolve_body(scene, i, all_faces, result);
  }
  return result;
}

}  // namespace halfspace
