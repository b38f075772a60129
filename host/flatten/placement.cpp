#include "host/flatten/placement.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <unordered_map>
#include <utility>
#include <variant>

#include "host/flatten/transform.hpp"

namespace halfspace {
namespace {

// How many bodies a group places, counted without placing them and no further than one past the limit.
class BodyCensus {
 public:
  BodyCensus(const Scene& scene, Diagnostics& diagnostics) : diagnostics_(diagnostics) {
    for (const Group& group : scene.definitions) definitions_[group.id] = &group;
    count(scene.top, 0);
  }

  [[nodiscard]] const Group& definition(const std::string& id) const { return *definitions_.at(id); }
  [[nodiscard]] bool is_empty(const std::string& id) const { return count_of(definition(id)) == 0; }
  [[nodiscard]] std::uint64_t count_of(const Group& group) const { return counts_.at(&group); }

 private:
  std::uint64_t count(const Group& group, int depth) {
    if (const auto known = counts_.find(&group); known != counts_.end()) return known->second;
    std::uint64_t total = 0;
    for (const Placement& placement : group.placements) {
      const std::uint64_t before = total;
      total += std::visit([&](const auto& p) { return count_of(p, depth); }, placement);
      if (total <= placed_body_limit) continue;
      if (before <= placed_body_limit) report_excess(placement);
      total = placed_body_limit + 1;
    }
    return counts_[&group] = total;
  }

  static std::uint64_t count_of(const BodyStatement& /*body*/, int /*depth*/) { return 1; }
  std::uint64_t count_of(const InstanceStatement& instance, int depth) {
    return count_below(instance.definition, instance.position, depth);
  }
  std::uint64_t count_of(const ArrayStatement& array, int depth) {
    return array.count * count_below(array.definition, array.position, depth);
  }

  std::uint64_t count_below(const std::string& id, const SourcePosition& position, int depth) {
    if (depth == placement_depth_limit) {
      if (!std::exchange(too_deep_, true)) {
        diagnostics_.push_back({Severity::limit, position,
                                "definitions are nested more than " + std::to_string(placement_depth_limit) +
                                    " deep; place '" + id + "' nearer the top"});
      }
      return 0;
    }
    return count(definition(id), depth + 1);
  }

  // Once, at the innermost statement: everything that holds it is over the limit for the same reason.
  void report_excess(const Placement& placement) {
    if (std::exchange(too_many_, true)) return;
    std::visit(
        [&](const auto& p) {
          diagnostics_.push_back({Severity::limit, p.position,
                                  "'" + p.id + "' brings the picture to more than " +
                                      std::to_string(placed_body_limit) + " bodies; place fewer copies"});
        },
        placement);
  }

  Diagnostics& diagnostics_;
  std::unordered_map<std::string, const Group*> definitions_;
  std::unordered_map<const Group*, std::uint64_t> counts_;
  bool too_deep_ = false;
  bool too_many_ = false;
};

template <std::size_t n>
RealHalfSpace real_half_space(HalfSpaceKind kind, const std::array<Number, n>& coefficients) {
  RealHalfSpace h{kind, {}};
  std::transform(coefficients.begin(), coefficients.end(), h.c.begin(),
                 [](const Number& number) { return decimal_to_real(number.text); });
  return normalised(h);
}

// What a group's statements say, read once for all copies.
struct GroupShapes {
  std::vector<PlacedHalfSpace> half_spaces;
  std::vector<std::vector<HalfSpaceUse>> uses;  // of `half_spaces`, by the bodies in their order
};

// A quadric without squares is a plane.
RealHalfSpace plane_of(const RealHalfSpace& quadric) {
  const auto& c = quadric.c;
  return normalised({HalfSpaceKind::plane, {2 * c[6], 2 * c[7], 2 * c[8], c[9]}});
}

GroupShapes shapes_of(const Group& group) {
  GroupShapes shapes;
  std::unordered_map<std::string, std::size_t> indices;
  const auto append = [&](const PlacedHalfSpace& h) {
    indices[h.name] = shapes.half_spaces.size();
    shapes.half_spaces.push_back(h);
  };
  for (const PlaneStatement& s : group.planes) {
    append({real_half_space(HalfSpaceKind::plane, s.coefficients), 0, s.transparent, s.id, s.position});
  }
  const std::vector<Kinship> kinships = kinships_of(group.quadrics);
  for (std::size_t i = 0; i < kinships.size(); ++i) {
    const QuadricStatement& s = group.quadrics[i];
    const RealHalfSpace shape = real_half_space(HalfSpaceKind::quadric, s.coefficients);
    if (kinships[i].squares == 0) {
      append({plane_of(shape), 0, s.transparent, s.id, s.position});
      continue;
    }
    append({shape, 0, s.transparent, s.id, s.position, kinships[i]});
    shapes.half_spaces.back().kin.ratio = *std::find_if(shape.c.begin(), shape.c.end(), [](Real v) { return v != 0; });
  }
  for (const Placement& placement : group.placements) {
    const auto* const body = std::get_if<BodyStatement>(&placement);
    if (body == nullptr) continue;
    auto& uses = shapes.uses.emplace_back();
    for (const HalfSpaceReference& h : body->half_spaces) uses.push_back({indices.at(h.id), h.complement});
  }
  return shapes;
}

// Definitions nest a thousand deep, and a matrix on the stack at each would need megabytes of it.
using HeapMatrix = std::unique_ptr<const Matrix4>;

[[gnu::noinline]] HeapMatrix heap_product(const Matrix4& a, const Matrix4& b) {
  return std::make_unique<const Matrix4>(product(a, b));
}
// nullptr: there is none.
template <class Transforms>
[[gnu::noinline]] HeapMatrix heap_inverse_below(const Matrix4& parent, const Transforms& transforms) {
  const auto inverse = inverse_of(transforms);
  return inverse ? std::make_unique<const Matrix4>(product(parent, *inverse)) : nullptr;
}
template <class Transforms>
[[gnu::noinline]] HeapMatrix heap_inverse(const Transforms& transforms) {
  const auto inverse = inverse_of(transforms);
  return inverse ? std::make_unique<const Matrix4>(*inverse) : nullptr;
}

class Walk {
 public:
  Walk(const BodyCensus& census, Diagnostics& diagnostics) : census_(census), diagnostics_(diagnostics) {}

  PlacedScene run(const Group& top) {
    result_.bodies.reserve(census_.count_of(top));
    place(top, identity_matrix, "");
    return std::move(result_);
  }

 private:
  void place(const Group& group, const Matrix4& inverse, const std::string& path) {
    auto shapes = shapes_.find(&group);
    if (shapes == shapes_.end()) shapes = shapes_.emplace(&group, shapes_of(group)).first;
    PlacedGroup placed{shapes->second, inverse, path, placed_.size(), 0, {}};
    placed_.resize(placed_.size() + placed.shapes.half_spaces.size(), not_placed);
    for (const Placement& placement : group.placements) {
      std::visit([&](const auto& p) { place_one(p, placed); }, placement);
    }
    placed_.resize(placed.first);
  }

  struct PlacedGroup {
    const GroupShapes& shapes;
    const Matrix4& inverse;
    const std::string& path;
    std::size_t first = 0;   // of its half-spaces in placed_
    std::size_t bodies = 0;  // that were placed
    std::optional<std::size_t> place;
  };

  void place_one(const BodyStatement& body, PlacedGroup& group) {
    PlacedBody& placed = result_.bodies.emplace_back();
    placed.name = group.path + body.id;
    placed.position = body.position;
    placed.statement = &body;
    placed.uses = group.shapes.uses[group.bodies++];
    for (HalfSpaceUse& use : placed.uses) use.half_space = half_space_of(use.half_space, group);
  }

  // Of the group that is being placed, which needs one as soon as a body uses a half-space.
  std::size_t place_of(PlacedGroup& group) {
    if (!group.place) {
      group.place = result_.places.size();
      result_.places.push_back(group.inverse);
    }
    return *group.place;
  }

  std::size_t half_space_of(std::size_t shape, PlacedGroup& group) {
    std::size_t& placed = placed_[group.first + shape];
    if (placed == not_placed) {
      placed = result_.half_spaces.size();
      result_.half_spaces.push_back(group.shapes.half_spaces[shape]);
      result_.half_spaces.back().place = place_of(group);
    }
    return placed;
  }

  void place_one(const InstanceStatement& instance, PlacedGroup& group) {
    if (census_.is_empty(instance.definition)) return;
    const HeapMatrix inverse = heap_inverse_below(group.inverse, instance.transforms);
    if (!inverse) return report_flat(instance.id, instance.position);
    place(census_.definition(instance.definition), *inverse, group.path + instance.id + "/");
  }

  // (init delta^k P)^-1 = P^-1 (delta^-1)^k init^-1 for the parent's P.
  void place_one(const ArrayStatement& array, PlacedGroup& group) {
    if (census_.is_empty(array.definition)) return;
    const HeapMatrix first = heap_inverse(array.initial);
    const HeapMatrix step = heap_inverse(array.delta);
    if (!first || !step) return report_flat(array.id, array.position);
    auto before = std::make_unique<const Matrix4>(group.inverse);
    for (std::uint32_t k = 0; k < array.count; ++k) {
      place(census_.definition(array.definition), *heap_product(*before, *first),
            group.path + array.id + "[" + std::to_string(k) + "]/");
      before = heap_product(*before, *step);
    }
  }

  void report_flat(const std::string& id, const SourcePosition& position) {
    diagnostics_.push_back(
        {Severity::error, position, "'" + id + "' scales by 0, which flattens its solids; use a factor other than 0"});
  }

  static constexpr std::size_t not_placed = static_cast<std::size_t>(-1);

  const BodyCensus& census_;
  Diagnostics& diagnostics_;
  PlacedScene result_;
  std::unordered_map<const Group*, GroupShapes> shapes_;
  std::vector<std::size_t> placed_;  // half-spaces of the groups that are being placed, innermost last
};

}  // namespace

PlacedScene place_bodies(const Scene& scene, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const BodyCensus census(scene, diagnostics);
  if (diagnostics.size() != before) return {};
  return Walk(census, diagnostics).run(scene.top);
}

}  // namespace halfspace
