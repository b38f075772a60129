#include "host/resolve/resolve.hpp"

#include <algorithm>

#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/face_cells.hpp"
#include "host/resolve/hidden_bodies.hpp"
#include "host/resolve/needless_quartics.hpp"

namespace halfspace {
namespace {

DotExtent local_extent(const IntegerBody& body, const Scissor& scissor) {
  return {scissor.x0 - body.origin[0], scissor.y0 - body.origin[1], scissor.x1 - body.origin[0],
          scissor.y1 - body.origin[1]};
}

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

// Resolves one body after another, in memory that serves all of them.
class BodyResolver {
 public:
  BodyResolver(const IntegerScene& scene, bool all_faces) : scene_(scene), all_faces_(all_faces) {}

  void append(std::uint32_t index, ResolvedScene& resolved);

 private:
  void find_opaque_sheets(const IntegerBody& body, const DotExtent& extent);

  const IntegerScene& scene_;
  bool all_faces_;
  FaceFinder finder_;
  ArcTable arcs_;
  std::vector<Sheets> opaque_;  // of one body
  std::vector<BoundingCurves> bounds_;
  std::vector<FaceCells> faces_;
};

void BodyResolver::find_opaque_sheets(const IntegerBody& body, const DotExtent& extent) {
  opaque_.clear();
  opaque_.reserve(body.half_spaces.size());
  for (std::uint32_t i = 0; i < body.half_spaces.size(); ++i) {
    if (body.half_spaces[i].transparent) continue;
    Sheets& sheets = opaque_.emplace_back(body, i);
    if (sheets.shape == SheetShape::none) {
      opaque_.pop_back();
    } else {
      drop_needless_quartics(sheets, extent);
    }
  }
}

void BodyResolver::append(std::uint32_t index, ResolvedScene& resolved) {
  const IntegerBody& body = scene_.bodies[index];
  const DotExtent extent = local_extent(body, scene_.scissor);
  if (extent.x0 > extent.x1 || extent.y0 > extent.y1) return;
  const bool hide = !all_faces_ && rays_start_outside(body);
  find_opaque_sheets(body, extent);
  arcs_.start_body(body.origin[1]);
  bounds_.clear();
  faces_.clear();
  QuarticTable table(extent.y0, extent.y1);
  for (const Sheets& sheets : opaque_) {
    const HiddenExits exits = hide ? hidden_exits(body, sheets) : HiddenExits{};
    bounds_.push_back(finder_.append_faces(sheets, extent, exits, table, arcs_, faces_));
  }
  for (const FaceCells& face : faces_) use_arcs(body, face, arcs_);
  arcs_.join_uses(index, extent, resolved.arcs);
  for (const FaceCells& face : faces_) {
    if (face.cells.empty() && face.spans.empty()) continue;
    append_face(body, {index, face.half_space, face.sheet}, face, arcs_, resolved);
  }
}

}  // namespace

ResolvedScene resolve(const IntegerScene& scene, bool all_faces) {
  ResolvedScene result;
  const std::vector<bool> hidden = all_faces ? std::vector<bool>(scene.bodies.size()) : hidden_bodies(scene);
  const auto seen = static_cast<std::size_t>(std::count(hidden.begin(), hidden.end(), false));
  result.arcs.reserve(2 * seen);  // two for a ball; moving an arc is not free
  BodyResolver resolver(scene, all_faces);
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
    if (!hidden[i]) resolver.append(i, result);
  }
  return result;
}

}  // namespace halfspace
