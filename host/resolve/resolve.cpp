#include "host/resolve/resolve.hpp"

#include <algorithm>
#include <cmath>

#include "host/resolve/exit_sheets.hpp"
#include "host/resolve/face_cells.hpp"
#include "host/resolve/quadric_meeting.hpp"

namespace halfspace {
namespace {

Extent local_extent(const IntegerBody& body, const Scissor& scissor) {
  return {scissor.x0 - body.origin[0], scissor.y0 - body.origin[1], scissor.x1 - body.origin[0],
          scissor.y1 - body.origin[1]};
}

std::string quoted(const std::string& name) { return "'" + name + "'"; }

Diagnostic meeting_error(const IntegerBody& body, const Sheets& sheets, const QuadricMeeting& meeting) {
  const auto page = [](double local, std::int64_t origin) { return std::to_string(std::llround(local) + origin); };
  return {Severity::error, body.position,
          "the quadrics " + quoted(body.half_spaces[sheets.half_space].name) + " and " +
              quoted(body.half_spaces[meeting.other].name) + " meet inside body " + quoted(body.name) + ", near dot (" +
              page(meeting.x, body.origin[0]) + ", " + page(meeting.y, body.origin[1]) +
              "); an edge between two quadrics cannot be drawn yet: keep them apart, or bound the body by planes "
              "before they meet"};
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
    const std::int32_t y0 = page_y(cell.y0);
    scene.cells.push_back({index, arcs.arc(cell.left, y0), arcs.arc(cell.right, y0), y0, page_y(cell.y1)});
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

// The sheets of the opaque half-spaces, or the error that stands in the way.
std::vector<Sheets> opaque_sheets(const IntegerBody& body, const Extent& extent, Diagnostics& diagnostics) {
  std::vector<Sheets> all;
  for (std::uint32_t i = 0; i < body.half_spaces.size(); ++i) {
    if (body.half_spaces[i].transparent) continue;
    Sheets sheets = sheets_of(body, i);
    if (sheets.shape == SheetShape::none) continue;
    if (const auto meeting = find_meeting(sheets, extent)) {
      diagnostics.push_back(meeting_error(body, sheets, *meeting));
      return {};
    }
    all.push_back(std::move(sheets));
  }
  return all;
}

void resolve_body(const IntegerScene& scene, std::uint32_t index, bool all_faces, ResolveResult& result) {
  const IntegerBody& body = scene.bodies[index];
  const Extent extent = local_extent(body, scene.scissor);
  if (extent.x0 > extent.x1 || extent.y0 > extent.y1) return;
  const bool hide = !all_faces && rays_start_outside(body);
  ArcTable arcs;
  std::vector<ResolvedHalfSpace> resolved;
  for (const Sheets& sheets : opaque_sheets(body, extent, result.diagnostics)) {
    const HiddenExits exits = hide ? hidden_exits(body, sheets) : HiddenExits{};
    resolved.push_back({sheets.half_space, face_cells(sheets, extent, exits, arcs)});
    for (const FaceCells& face : resolved.back().faces) use_arcs(body, face, arcs);
  }
  arcs.join_uses(index, result.scene.arcs);
  for (const ResolvedHalfSpace& half_space : resolved) {
    for (const FaceCells& face : half_space.faces) {
      if (face.cells.empty() && face.spans.empty()) continue;
      append_face(body, {index, half_space.half_space, face.sheet}, face, arcs, result.scene);
    }
  }
}

}  // namespace

ResolveResult resolve(const IntegerScene& scene, bool all_faces) {
  ResolveResult result;
  for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) resolve_body(scene, i, all_faces, result);
  return result;
}

}  // namespace halfspace
