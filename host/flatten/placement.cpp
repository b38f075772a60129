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
  [[nodiscard]] bool is_empty(const std::string& id) const { return counts_.at(&definition(id)) == 0; }

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

// Keeps the coefficients of a group's statements, whose decimals are read once for all copies.
using GroupShapes = std::unordered_map<std::string, PlacedHalfSpace>;

// A quadric without squares is a plane.
RealHalfSpace plane_of(const RealHalfSpace& quadric) {
  const auto& c = quadric.c;
  return normalised({HalfSpaceKind::plane, {2 * c[6], 2 * c[7], 2 * c[8], c[9]}});
}

GroupShapes shapes_of(const Group& group) {
  GroupShapes shapes;
  for (const PlaneStatement& s : group.planes) {
    shapes[s.id] = {real_half_space(HalfSpaceKind::plane, s.coefficients), 0, s.transparent, s.id, s.position};
  }
  const std::vector<Kinship> kinships = kinships_of(group.quadrics);
  for (std::size_t i = 0; i < kinships.size(); ++i) {
    const QuadricStatement& s = group.quadrics[i];
    const RealHalfSpace shape = real_half_space(HalfSpaceKind::quadric, s.coefficients);
    if (kinships[i].squares == 0) {
      shapes[s.id] = {plane_of(shape), 0, s.transparent, s.id, s.position};
      continue;
    }
    shapes[s.id] = {shape, 0, s.transparent, s.id, s.position, kinships[i]};
    shapes[s.id].kin.ratio = *std::find_if(shape.c.begin(), shape.c.end(), [](Real v) { return v != 0; });
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
[[gnu::noinline]] HeapMatrix heap_inverse(const Transforms& transforms) {
  const auto inverse = inverse_of(transforms);
  return inverse ? std::make_unique<const Matrix4>(*inverse) : nullptr;
}

class Walk {
 public:
  Walk(const BodyCensus& census, Diagnostics& diagnostics) : census_(census), diagnostics_(diagnostics) {}

  void place(const Group& group, const Matrix4& inverse, const std::string& path) {
    auto shapes = shapes_.find(&group);
    if (shapes == shapes_.end()) shapes = shapes_.emplace(&group, shapes_of(group)).first;
    PlacedGroup placed{group, shapes->second, inverse, path, {}, {}};
    for (const Placement& placement : group.placements) {
      std::visit([&](const auto& p) { place_one(p, placed); }, placement);
    }
  }

  PlacedScene take() { return std::move(result_); }

 private:
  struct PlacedGroup {
    const Group& group;
    const GroupShapes& shapes;
    const Matrix4& inverse;
    const std::string& path;
    std::unordered_map<std::string, std::size_t> placed;  // half-spaces that a body has used, by id
    std::optional<std::size_t> place;
  };

  void place_one(const BodyStatement& body, PlacedGroup& group) {
    PlacedBody placed{group.path + body.id, body.position, {}, &body};
    for (const HalfSpaceReference& reference : body.half_spaces) {
      placed.uses.push_back({half_space_of(reference, group), reference.complement});
    }
    result_.bodies.push_back(std::move(placed));
  }

  // Of the group that is being placed, which needs one as soon as a body uses a half-space.
  std::size_t place_of(PlacedGroup& group) {
    if (!group.place) {
      group.place = result_.places.size();
      result_.places.push_back(group.inverse);
    }
    return *group.place;
  }

  std::size_t half_space_of(const HalfSpaceReference& reference, PlacedGroup& group) {
    const auto [entry, is_new] = group.placed.emplace(reference.id, result_.half_spaces.size());
    if (is_new) {
      PlacedHalfSpace h = group.shapes.at(reference.id);
      h.place = place_of(group);
      result_.half_spaces.push_back(std::move(h));
    }
    return entry->second;
  }

  void place_one(const InstanceStatement& instance, PlacedGroup& group) {
    if (census_.is_empty(instance.definition)) return;
    const HeapMatrix own = heap_inverse(instance.transforms);
    if (!own) return report_flat(instance.id, instance.position);
    place(census_.definition(instance.definition), *heap_product(group.inverse, *own), group.path + instance.id + "/");
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

  const BodyCensus& census_;
  Diagnostics& diagnostics_;
  PlacedScene result_;
  std::unordered_map<const Group*, GroupShapes> shapes_;
};

}  // namespace

PlacedScene place_bodies(const Scene& scene, Diagnostics& diagnostics) {
  const std::size_t before = diagnostics.size();
  const BodyCensus census(scene, diagnostics);
  if (diagnostics.size() != before) return {};
  Walk walk(census, diagnostics);
  walk.place(scene.top, identity_matrix, "");
  return walk.take();
}

}  // namespace halfspace
