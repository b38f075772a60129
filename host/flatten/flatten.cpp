#include "host/flatten/flatten.hpp"

#include <algorithm>
#include <array>
#include <deque>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>

#include "host/flatten/clan.hpp"
#include "host/flatten/extent.hpp"
#include "host/flatten/lighting.hpp"
#include "host/flatten/mating.hpp"
#include "host/flatten/meeting_extent.hpp"
#include "host/flatten/placement.hpp"
#include "host/flatten/quantise.hpp"
#include "host/flatten/ranked_squares.hpp"
#include "host/flatten/view.hpp"
#include "host/flatten/window.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t page_limit = 32767;
constexpr std::size_t most_families = std::size_t{1} << 32;  // of a group
// Bounds hold for depths this close to vrp, or to the body where it lies elsewhere. A surface reaches further only
// where it is nearly parallel to the rays. A plane is then held as deep as it goes on the page in its bodies, since it costs only a
// bit for each doubling: of a wedge whose sides are a billionth apart the rays see the edge at some 10^9 dots.
const Real depth_limit = power_of_two(20);
const Real plane_depth_limit = power_of_two(40);
// A body off the page is rounded where it is, up to here and up to depth_limit across; one that is further off or larger
// is rounded for the page, where it is not.
const Real far_limit = power_of_two(25);
// Boxes of bodies on the page may be as much too large.
const Real dot_slack = Real(1) / 4;
const Vector3 around_box{dot_slack, dot_slack, dot_slack};
// What mates within its bodies' boxes may be off by as much in those that share more with it: a clan, or a pair of planes.
const Real mating_limit = power_of_two(-10);

// Which of the surfaces a half-space has.
struct SurfaceUse {
  std::size_t surface = 0;
  bool opposite = false;  // it is written the other way round
  Real apart = 0;         // dots: from the first that has it
};

// What a placed half-space is on the page, and what becomes of it.
struct PageHalfSpace {
  RealHalfSpace shape;           // dot frame
  std::optional<Region> region;  // of the bodies that use it
  std::optional<SurfaceUse> use;
  std::optional<std::array<SurfaceUse, 2>> planes;  // of a quadric that is the product of two
  std::optional<Quantised> alone;                   // what it is rounded to if it uses no surface
  Real bound = 0;
};

// What one or more half-spaces have in common.
struct Surface {
  Region region;        // of all that have it
  RealHalfSpace shape;  // as the first of them has it, in the frame of a place
  std::size_t place = 0;
  std::size_t first = 0;  // that half-space
  bool is_moved = false;  // the shape is what a clan makes of it
  std::optional<Quantised> quantised;
};

// The bodies that use each half-space, once for each use.
class Users {
 public:
  explicit Users(const PlacedScene& scene) : first_(scene.half_spaces.size() + 1) {
    for (const PlacedBody& body : scene.bodies) {
      for (const HalfSpaceUse& use : body.uses) ++first_[use.half_space + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    bodies_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (std::uint32_t i = 0; i < scene.bodies.size(); ++i) {
      for (const HalfSpaceUse& use : scene.bodies[i].uses) bodies_[next[use.half_space]++] = i;
    }
  }

  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t half_space) const {
    return std::span(bodies_).subspan(first_[half_space], first_[half_space + 1] - first_[half_space]);
  }

 private:
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> bodies_;
};

class Flattener {
 public:
  Flattener(const Scene& scene, const FlattenOptions& options)
      : source_(scene), options_(options), width_(options.width), height_(options.height) {}

  FlattenResult run() {
    if (check_options() && settle() && fit() && localise()) build();
    return std::move(result_);
  }

 private:
  bool fail(Severity severity, const SourcePosition& position, const std::string& message) {
    result_.diagnostics.push_back({severity, position, message});
    return false;
  }

  bool check_options() {
    const auto& o = options_;
    const std::string page = std::to_string(o.width) + " x " + std::to_string(o.height) + " dots";
    if (o.width < 1 || o.height < 1) return fail(Severity::error, {}, "a page of " + page + " has no dot");
    if (o.width > page_limit || o.height > page_limit) {
      return fail(Severity::limit, {},
                  "a page of " + page + " is larger than " + std::to_string(page_limit) + " a side");
    }
    if (o.levels < 2 || o.levels > 256) {
      return fail(Severity::error, {}, std::to_string(o.levels) + " levels; a device has 2 to 256");
    }
    if (o.aspect_numerator < 1 || o.aspect_denominator < 1) {
      return fail(Severity::error, {}, "the pixel aspect is not positive");
    }
    result_.scene.width = o.width;
    result_.scene.height = o.height;
    result_.scene.levels = o.levels;
    return true;
  }

  // The view, and every body in its frame, with the clipping planes and the eye plane.
  bool settle() {
    placed_ = place_bodies(source_, result_.diagnostics);
    const auto view = settle_view(source_, options_.view_id, result_.diagnostics);
    if (!view || is_hopeless()) return false;
    view_ = *view;
    move_places(view_to_world(view_));
    return true;
  }

  // Half-spaces are transformed from their statements every time, so that only matrices gather rounding.
  void move_places(const Matrix4& to_former_frame) {
    for (Matrix4& place : placed_.places) place = product(to_former_frame, place);
  }

  bool transform_half_spaces() {
    half_spaces_.clear();
    half_spaces_.reserve(placed_.half_spaces.size());
    for (const PlacedHalfSpace& h : placed_.half_spaces) {
      PageHalfSpace& moved = half_spaces_.emplace_back();
      moved.shape = normalised(transformed(h.shape, placed_.places[h.place]));
      if (!finite(moved.shape)) {
        return fail(Severity::error, h.position,
                    "the transforms and the view take '" + h.name +
                        "' beyond 10^4900 or below 10^-4900; use milder numbers or fewer copies");
      }
    }
    return true;
  }

  [[nodiscard]] bool is_hopeless() const {
    return std::any_of(result_.diagnostics.begin(), result_.diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity != Severity::warning; });
  }

  [[nodiscard]] std::vector<Side> sides_of(const PlacedBody& body) const {
    std::vector<Side> sides;
    for (const HalfSpaceUse& use : body.uses) {
      sides.push_back({half_spaces_[use.half_space].shape, use.complement, family_of(use.half_space)});
    }
    return sides;
  }

  // A number for all quadrics of one family; none for what is plane.
  [[nodiscard]] std::optional<std::size_t> family_of(std::size_t half_space) const {
    const PlacedHalfSpace& h = placed_.half_spaces[half_space];
    if (h.shape.kind != HalfSpaceKind::quadric || h.kin.family == no_family || plane_pair_of(h.shape, h.kin)) {
      return std::nullopt;
    }
    return h.place * most_families + h.kin.family;
  }

  // The window needs the picture's extent, which clipping planes have no effect on, unless it is given.
  bool fit() {
    std::optional<Box> extent;
    if (needs_extent(view_)) {
      if (!transform_half_spaces()) return false;
      for (const PlacedBody& body : placed_.bodies) {
        std::vector<Side> sides = sides_of(body);
        if (view_.perspective) sides.push_back({eye_plane(), false});
        const Extent own = extent_of(sides, 0, quadrics_meet(body, sides));
        if (own.unbounded) return fail_unbounded(body);
        extents_.push_back(own);
        if (!own.empty) extent = extent ? around(*extent, own.box) : own.box;
      }
    }
    if (!extent && needs_extent(view_)) {
      fail(Severity::warning, view_.position,
           "there is nothing to draw: the scene places no solid; the page stays empty");
    }
    if (extent) result_.scene.extent = {to_doubles(extent->low), to_doubles(extent->high)};
    const Device device{options_.width, options_.height, Real(options_.aspect_numerator) / options_.aspect_denominator};
    page_ = fit_window(view_, device, extent.value_or(Box{}));
    result_.scene.scissor = page_.scissor;
    const auto lighting = light_scene(source_, view_, page_, result_.diagnostics);
    if (lighting) result_.scene.lighting = *lighting;
    return lighting.has_value();
  }

  static std::array<double, 3> to_doubles(const Vector3& v) {
    return {static_cast<double>(v[0]), static_cast<double>(v[1]), static_cast<double>(v[2])};
  }

  // Instances of one body are affine images of each other, on which it does not depend whether quadrics meet; unless the view's own planes
  // cut them.
  bool quadrics_meet(const PlacedBody& body, std::span<const Side> sides) {
    if (view_.perspective || view_.clipping) return quadrics_may_meet(sides);
    const auto [known, is_new] = meetings_.try_emplace(body.statement, false);
    if (is_new) known->second = quadrics_may_meet(sides);
    return known->second;
  }

  bool fail_unbounded(const PlacedBody& body) {
    return fail(Severity::error, body.position,
                "body '" + body.name +
                    "' has no end, so the picture cannot be fitted; bound it with a half-space or "
                    "give the view whw and whh");
  }

  static RealHalfSpace eye_plane() { return {HalfSpaceKind::plane, {0, 0, 1, 0}}; }

  // From here on in dots. Clipping planes and the eye plane become the last half-spaces of each body.
  bool localise() {
    append_view_planes();
    move_places(page_.dot_to_view());
    normal_rows_ = normal_rows(view_, page_);
    if (!transform_half_spaces()) return false;
    boxes_.reserve(placed_.bodies.size());
    body_boxes_.reserve(placed_.bodies.size());
    for (std::size_t i = 0; i < placed_.bodies.size(); ++i) {
      const PlacedBody& body = placed_.bodies[i];
      body_boxes_.push_back(box_of(body, extent_on_page(i)));
      boxes_.push_back(with_depth_limited(body_boxes_.back().box, depth_limit));
      for (const HalfSpaceUse& use : body.uses) {
        PageHalfSpace& h = half_spaces_[use.half_space];
        const Region region = region_in_body(h.shape, i);
        h.region = h.region ? around(*h.region, region) : region;
      }
    }
    mate();
    return quantise_all();
  }

  void append_view_planes() {
    std::vector<HalfSpaceUse> uses;
    const std::size_t view_frame = placed_.places.size();
    placed_.places.push_back(identity_matrix);
    const auto append = [&](const RealHalfSpace& shape, bool transparent, const char* name, bool complement) {
      uses.push_back({placed_.half_spaces.size(), complement});
      placed_.half_spaces.push_back({shape, view_frame, transparent, name, view_.position});
    };
    if (view_.clipping) {
      append(before_plane(view_, view_.clipping->front), false, "front clipping plane", true);
      append(before_plane(view_, view_.clipping->back), false, "back clipping plane", false);
    }
    if (view_.perspective) append(eye_plane(), true, "eye plane", false);
    for (PlacedBody& body : placed_.bodies) body.uses.insert(body.uses.end(), uses.begin(), uses.end());
  }

  // A body cut by the page with a dot around it; in local dots from `origin`.
  [[nodiscard]] std::vector<Side> with_page(std::vector<Side> sides, const Vector3& origin) const {
    const auto plane = [](std::size_t axis, Real at) {
      RealHalfSpace h{HalfSpaceKind::plane, {}};
      h.c[axis] = 1;
      h.c[3] = -at;
      return h;
    };
    sides.push_back({plane(0, -1 - origin[0]), true});
    sides.push_back({plane(0, width_ - origin[0]), false});
    sides.push_back({plane(1, -1 - origin[1]), true});
    sides.push_back({plane(1, height_ - origin[1]), false});
    return sides;
  }

  [[nodiscard]] bool is_on_page(const Box& box) const {
    return box.low[0] >= -1 && box.low[1] >= -1 && box.high[0] <= width_ && box.high[1] <= height_;
  }

  struct BodyBox {
    Box box;
    bool has_depth_end = true;  // else the box holds some of its points
  };

  // The part of the body on the page; of a body that lies off it all, and the page where even that says nothing.
  [[nodiscard]] BodyBox box_of(const PlacedBody& body, const Extent& whole) {
    const bool has_end = !whole.empty && !whole.unbounded;
    if (has_end && is_on_page(whole.box)) return {whole.box};
    const std::vector<Side> sides = sides_of(body);
    const std::vector<Side> on_page = with_page(sides, {0, 0, 0});
    const Extent part = extent_of(on_page, dot_slack, quadrics_meet(body, sides) && quadrics_may_meet(on_page));
    if (!part.empty && !part.unbounded) return {part.box};
    if (part.empty && !part.unbounded && has_end && is_near(whole.box)) return {whole.box};
    const Box endless = endless_box();
    return {part.empty ? endless : around(endless, part.box), !part.unbounded};
  }

  // Where a body needs the surface.
  [[nodiscard]] Region region_in_body(const RealHalfSpace& shape, std::size_t body) const {
    const bool is_plane = shape.kind == HalfSpaceKind::plane;
    const Box box = is_plane ? box_of_plane(shape, body_boxes_[body]) : boxes_[body];
    Region region = region_of(box, larger(width_, height_));
    if (is_plane) region.target = target_for_plane(shape, local_box(region));
    return region;
  }

  // The box's, and no more than leaves each part of its normal n within 2^-14 of |n|: a form that is off by t at most is off by t / half in
  // each slope, and by t in the middle. Seen straight, where a dot of depth is as long as one of the page, that is nothing new.
  [[nodiscard]] Real target_for_plane(const RealHalfSpace& plane, const LocalBox& box) const {
    Vector3 n{};
    Real off = 0;  // for t = 1
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector4& row = normal_rows_[i];
      Real off_here = magnitude(row[3]);
      for (std::size_t j = 0; j < 3; ++j) off_here += magnitude(row[j] - row[3] * box.centre[j]) / box.half[j];
      for (std::size_t j = 0; j < 4; ++j) add_product(n[i], row[j], plane.c[j]);
      off = larger(off, off_here);
    }
    const Real size = length({plane.c[0], plane.c[1], plane.c[2]});
    const bool is_horizon = length(n) == 0;
    return is_horizon ? box.target : smaller(box.target, power_of_two(-14) * length(n) / (size * off));
  }

  // The body's box, and as far beyond depth_limit as the plane goes over the page.
  [[nodiscard]] Box box_of_plane(const RealHalfSpace& plane, const BodyBox& body) const {
    Box box = with_depth_limited(body.box, depth_limit);
    Box deep = body.box;
    if (!body.has_depth_end) {
      deep.low[2] = vrp_depth() - plane_depth_limit;
      deep.high[2] = view_.perspective ? Real(0) : plane_depth_limit;
    }
    if (deep.low[2] == box.low[2] && deep.high[2] == box.high[2]) return box;
    const auto [low, high] = depths_over_page(plane, with_depth_limited(deep, plane_depth_limit));
    box.low[2] = smaller(box.low[2], low);
    box.high[2] = larger(box.high[2], high);
    return box;
  }

  // Of a plane, where it is within the box's depths; else one of the box's ends, twice.
  [[nodiscard]] std::pair<Real, Real> depths_over_page(const RealHalfSpace& plane, const Box& box) const {
    const auto& c = plane.c;
    if (c[2] == 0) return {box.low[2], box.high[2]};
    const Real middle = -(c[0] * (width_ - 1) / 2 + c[1] * (height_ - 1) / 2 + c[3]) / c[2];
    const Real spread = (magnitude(c[0]) * (width_ + 1) + magnitude(c[1]) * (height_ + 1)) / magnitude(2 * c[2]);
    const auto within = [&box](Real z) { return larger(box.low[2], smaller(z, box.high[2])); };
    return {within(middle - spread), within(middle + spread)};
  }

  // Known from fitting the window, unless clipping planes have come since.
  [[nodiscard]] Extent extent_on_page(std::size_t body) {
    if (extents_.empty() || view_.clipping) {
      const std::vector<Side> sides = sides_of(placed_.bodies[body]);
      return extent_of(sides, dot_slack, quadrics_meet(placed_.bodies[body], sides));
    }
    Extent extent = extents_[body];
    extent.box = page_.to_dots(extent.box);
    return extent;
  }

  // And no larger than 113 bits can hold to the page's target.
  static bool is_near(const Box& box) {
    const Vector3 size = difference(box.high, box.low);
    return larger(largest(box.low), largest(box.high)) <= far_limit && larger(size[0], size[1]) <= depth_limit;
  }

  // The page, and twice its size in depth about vrp.
  [[nodiscard]] Box endless_box() const {
    const Real depth = 2 * larger(width_, height_);
    return {{-1, -1, vrp_depth() - depth}, {width_, height_, vrp_depth() + depth}};
  }

  [[nodiscard]] Real vrp_depth() const {
    return view_.perspective ? -dot(difference(view_.vrp, view_.cop), view_.into) * page_.scale_y : Real(0);
  }

  [[nodiscard]] Box with_depth_limited(Box box, Real limit) const {
    const Real near = times_power_of_two(limit, -1);  // such a box ends within the limit of all its points
    if (magnitude(box.low[2]) <= near && magnitude(box.high[2]) <= near) return box;
    const Real middle = smaller(larger(vrp_depth(), box.low[2]), box.high[2]);
    box.low[2] = larger(box.low[2], middle - limit);
    box.high[2] = smaller(box.high[2], middle + limit);
    return box;
  }

  static bool has_surface(const RealHalfSpace& shape, const Kinship& kin) {
    if (shape.kind == HalfSpaceKind::quadric) return kin.family != no_family;
    return largest({shape.c[0], shape.c[1], shape.c[2]}) != 0;
  }

  void mate() {
    const Vector3 middle{width_ / 2, height_ / 2, vrp_depth()};
    SurfaceMating mating(middle, larger(width_, height_), half_spaces_.size());
    surfaces_.reserve(half_spaces_.size());
    const Users users(placed_);
    for (std::size_t i = 0; i < half_spaces_.size(); ++i) {
      if (!half_spaces_[i].region) continue;
      const PlacedHalfSpace& own = placed_.half_spaces[i];
      const auto join = [&](const PlacedHalfSpace& source, const RealHalfSpace& on_page, const Region& region) {
        return join_surface({on_page, &source, &placed_.places[source.place]}, region, i, users.of(i), mating);
      };
      half_spaces_[i].use = join(own, half_spaces_[i].shape, *half_spaces_[i].region);
      half_spaces_[i].planes = join_plane_pair(own, users.of(i), join);
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i) surfaces_[i].region = mating.region_of(i);
  }

  // None where it has no surface.
  std::optional<SurfaceUse> join_surface(const MatingSurface& surface, const Region& region, std::size_t half_space,
                                         std::span<const std::uint32_t> users, SurfaceMating& mating) {
    const PlacedHalfSpace& source = *surface.source;
    if (!has_surface(surface.on_page, source.kin)) return std::nullopt;
    const auto match = mating.add(surface, region, users);
    if (match.leader == surfaces_.size()) surfaces_.push_back({{}, source.shape, source.place, half_space, false, {}});
    return SurfaceUse{match.leader, match.opposite, match.apart};
  }

  // A quadric that is two planes joins with each of them too, so that it touches what they do.
  template <typename Join>
  std::optional<std::array<SurfaceUse, 2>> join_plane_pair(const PlacedHalfSpace& source,
                                                           std::span<const std::uint32_t> users, const Join& join) {
    if (source.shape.kind != HalfSpaceKind::quadric) return std::nullopt;
    const auto pair = plane_pair_of(source.shape, source.kin);
    if (!pair) return std::nullopt;
    std::array<std::optional<SurfaceUse>, 2> uses;
    for (std::size_t k = 0; k < 2; ++k) {
      plane_factors_.push_back({(*pair)[k], source.place, source.transparent, source.name, source.position});
      const RealHalfSpace on_page = transformed((*pair)[k], placed_.places[source.place]);
      Region region = region_in_body(on_page, users.front());
      for (const std::uint32_t body : users) region = around(region, region_in_body(on_page, body));
      uses[k] = join(plane_factors_.back(), on_page, region);
    }
    if (!uses[0] || !uses[1]) return std::nullopt;
    const bool are_one = uses[0]->surface == uses[1]->surface;
    if (are_one != (source.kin.rank == 1)) return std::nullopt;
    return std::array{*uses[0], *uses[1]};
  }

  [[nodiscard]] std::vector<Clan> quadric_clans() const {
    std::vector<std::optional<std::size_t>> quadrics;
    for (const PageHalfSpace& h : half_spaces_) {
      const bool is_quadric = h.shape.kind == HalfSpaceKind::quadric;
      quadrics.push_back(is_quadric && h.use ? std::optional(h.use->surface) : std::nullopt);
    }
    return clans_of(placed_, quadrics, surfaces_.size());
  }

  // For the regions of all. Members that cannot be held together are left to themselves: false.
  bool quantise_clan(const Clan& clan, int least_bits) {
    Region region = surfaces_[clan.surfaces.front()].region;
    for (std::size_t k = 0; k < clan.surfaces.size(); ++k) {
      const Surface& own = surfaces_[clan.surfaces[k]];
      region = around(region, own.region);
      if (own.place == clan.place) continue;
      const auto off = quadric_distance({clan.members[k].shape, placed_.places[clan.place]},
                                        {own.shape, placed_.places[own.place]}, own.region);
      if (!off || *off > mating_limit) return false;
    }
    auto all = quantise_family(clan.members, placed_.places[clan.place], region, least_bits);
    if (!all) return false;
    for (std::size_t k = 0; k < clan.surfaces.size(); ++k) {
      Surface& surface = surfaces_[clan.surfaces[k]];
      surface.is_moved |= surface.place != clan.place || surface.shape.c != clan.members[k].shape.c;
      surface.shape = clan.members[k].shape;
      surface.place = clan.place;
      surface.quantised = std::move((*all)[k]);
    }
    return true;
  }

  // Surfaces by themselves, after the clans.
  void quantise_others() {
    for (const HalfSpaceKind kind : {HalfSpaceKind::plane, HalfSpaceKind::quadric}) {  // of which pairs are products
      for (Surface& surface : surfaces_) {
        if (surface.shape.kind == kind && !surface.quantised) surface.quantised = quantise_surface(surface, 0);
      }
    }
  }

  // A place and a class of parallel quadrics there; none where the second-order part is not rounded as a sum of squares.
  using ParallelKey = std::pair<std::size_t, std::size_t>;
  [[nodiscard]] std::optional<ParallelKey> parallels_of(const Surface& surface) const {
    const PlacedHalfSpace& first = placed_.half_spaces[surface.first];
    if (!surface.quantised || surface.quantised->bits == 0 || first.place != surface.place) return std::nullopt;
    return ParallelKey{surface.place, first.kin.parallel};
  }

  // Parallel quadrics stay parallel where their forms have one scale: that of the one which needs most.
  void align_parallels(const std::vector<Clan>& clans) {
    std::map<ParallelKey, int> most;
    for (const Surface& surface : surfaces_) {
      if (const auto key = parallels_of(surface)) most[*key] = std::max(most[*key], surface.quantised->bits);
    }
    const auto least_bits = [&](const Surface& surface) {
      const auto key = parallels_of(surface);
      return key ? most[*key] : 0;
    };
    std::vector<char> is_done(surfaces_.size(), 0);
    for (const Clan& clan : clans) {
      int bits = 0;
      for (const std::size_t i : clan.surfaces) bits = std::max(bits, least_bits(surfaces_[i]));
      if (bits > surfaces_[clan.surfaces.front()].quantised->bits) quantise_clan(clan, bits);
      for (const std::size_t i : clan.surfaces) is_done[i] = 1;
    }
    for (std::size_t i = 0; i < surfaces_.size(); ++i) {
      Surface& surface = surfaces_[i];
      const int bits = least_bits(surface);
      if (is_done[i] != 0 || bits == 0 || surface.quantised->bits >= bits) continue;
      if (auto finer = quantise_surface(surface, bits)) surface.quantised = std::move(finer);
    }
  }

  bool quantise_all() {
    std::vector<Clan> clans = quadric_clans();
    std::erase_if(clans, [this](const Clan& clan) { return !quantise_clan(clan, 0); });
    quantise_others();
    if (!view_.perspective) align_parallels(clans);  // in perspective they are not parallel on the page
    for (std::size_t i = 0; i < half_spaces_.size(); ++i) {
      const PageHalfSpace& h = half_spaces_[i];
      if (!h.region) continue;
      if (!round_half_space(i)) {
        const PlacedHalfSpace& source = placed_.half_spaces[i];
        fail(Severity::limit, source.position,
             "'" + source.name +
                 "' cannot be held to its accuracy in integers: it lies too far away for its size; bring its numbers "
                 "closer together");
      }
    }
    return !is_hopeless();
  }

  [[nodiscard]] std::optional<Quantised> quantise_surface(const Surface& surface, int least_bits) const {
    if (surface.shape.kind == HalfSpaceKind::quadric && half_spaces_[surface.first].planes) {
      if (auto product = product_of_planes(surface)) return product;
    }
    return quantise(surface.shape, placed_.places[surface.place], surface.region, least_bits);
  }

  [[nodiscard]] std::optional<Quantised> product_of_planes(const Surface& surface) const {
    const auto& uses = *half_spaces_[surface.first].planes;
    const auto pair = plane_pair_of(surface.shape, placed_.half_spaces[surface.first].kin);
    std::array<IntegerLinear, 2> forms;
    Quantised result{{HalfSpaceKind::quadric, {}}, 0};
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& plane = surfaces_[uses[k].surface].quantised;
      if (!plane) return std::nullopt;
      const IntegerForm form = seen_from(plane->form, IntegerPoint{});
      std::copy_n(form.c.begin(), 4, forms[k].begin());
      const RealHalfSpace truth = transformed((*pair)[k], placed_.places[surface.place]);
      const Real off = plane_distance(plane->form, truth, surface.region);
      if (off > plane->bound + mating_limit) return std::nullopt;
      result.bound = larger(result.bound, larger(plane->bound, off));
    }
    add_twice_product(result.form, forms[0], forms[1]);
    make_primitive(result.form);
    if (uses[0].opposite != uses[1].opposite) negate(result.form);
    return result;
  }

  // By its surface's integers, with a bound that is measured against the half-space's own truth. False: none will do.
  bool round_half_space(std::size_t half_space) {
    PageHalfSpace& h = half_spaces_[half_space];
    const PlacedHalfSpace& source = placed_.half_spaces[half_space];
    const Matrix4& place = placed_.places[source.place];
    if (!h.use) {
      h.alone = quantise(source.shape, place, *h.region);
      if (h.alone) h.bound = h.alone->bound;
      return h.alone.has_value();
    }
    const Surface& surface = surfaces_[h.use->surface];
    if (!surface.quantised) return false;
    h.bound = surface.quantised->bound;
    if (surface.first == half_space && !surface.is_moved) return true;  // the bound is its own
    if (h.shape.kind == HalfSpaceKind::plane) {
      h.bound = larger(h.bound, plane_distance(surface.quantised->form, h.shape, *h.region));
    } else if (!surface.is_moved) {
      h.bound += h.use->apart;
    } else {
      const auto off =
          quadric_distance({surface.shape, placed_.places[surface.place]}, {source.shape, place}, *h.region);
      if (!off) return false;
      h.bound += *off;
    }
    return true;
  }

  [[nodiscard]] const IntegerForm& form_of(const PageHalfSpace& h) const {
    return h.use ? surfaces_[h.use->surface].quantised->form : h.alone->form;
  }

  void build() {
    result_.scene.bodies.reserve(placed_.bodies.size());
    for (std::size_t i = 0; i < placed_.bodies.size(); ++i) {
      build_body(placed_.bodies[i], boxes_[i], result_.scene.bodies.emplace_back());
      for (const IntegerHalfSpace& h : result_.scene.bodies.back().half_spaces) {
        result_.scene.bound = std::max(result_.scene.bound, h.bound);
      }
    }
  }

  void build_body(PlacedBody& source, const Box& box, IntegerBody& body) {
    body.half_spaces.reserve(source.uses.size());
    body.name = std::move(source.name);
    body.position = source.position;
    set_origin(box, body);
    const IntegerPoint origin{mpz_class(body.origin[0]), mpz_class(body.origin[1]), mpz_class(body.origin[2])};
    std::vector<Side> sides;
    for (const HalfSpaceUse& use : source.uses) {
      const PageHalfSpace& h = half_spaces_[use.half_space];
      const PlacedHalfSpace& statement = placed_.half_spaces[use.half_space];
      // A leader written the other way round holds where its complement did.
      const bool complement = use.complement != (h.use && h.use->opposite);
      IntegerHalfSpace& local = body.half_spaces.emplace_back();
      local.kind = h.shape.kind;
      copy_seen_from(form_of(h), origin, local.c);
      local.complement = complement;
      local.transparent = statement.transparent;
      local.bound = double_above(h.bound);
      local.name = statement.name;
      local.position = statement.position;
      if (options_.boxes && source.uses.size() > 1) {
        sides.push_back({normalised(to_real(local.kind, local.c)), complement, family_of(use.half_space)});
      }
    }
    if (!options_.boxes) {
      const Scissor& scissor = page_.scissor;
      body.x0 = scissor.x0;
      body.y0 = scissor.y0;
      body.x1 = scissor.x1;
      body.y1 = scissor.y1;
    } else if (sides.empty()) {  // a surface by itself lies where the true one does, to 1/16 dot at worst
      set_dots({difference(box.low, around_box), sum(box.high, around_box)}, body);
    } else {
      set_box(sides, body);
    }
  }

  // Near the middle of the body's part on the page.
  void set_origin(const Box& box, IntegerBody& body) const {
    static const Real furthest = power_of_two(62);
    const Vector3 last{width_ - 1, height_ - 1, furthest};
    const Vector3 first{0, 0, -furthest};
    for (std::size_t i = 0; i < 3; ++i) {
      const Real middle = times_power_of_two(larger(box.low[i], first[i]) + smaller(box.high[i], last[i]), -1);
      body.origin[i] = nearest_word(smaller(larger(middle, first[i]), last[i]));
    }
  }

  // Around the silhouette of the integers themselves: where two of them meet at a small angle, the edge may lie
  // further from the true one than the surfaces do.
  void set_box(const std::vector<Side>& sides, IntegerBody& body) const {
    const Vector3 origin{Real(body.origin[0]), Real(body.origin[1]), Real(body.origin[2])};
    Extent extent = extent_of(sides, dot_slack);
    Box box{sum(extent.box.low, origin), sum(extent.box.high, origin)};
    if (extent.unbounded || !is_on_page(box)) {
      extent = extent_of(with_page(sides, origin), dot_slack);
      box = {sum(extent.box.low, origin), sum(extent.box.high, origin)};
    }
    if (extent.unbounded) box = scissor_box();
    if (!extent.empty || extent.unbounded) set_dots(box, body);
  }

  [[nodiscard]] Box scissor_box() const {
    const Scissor& scissor = page_.scissor;
    return {{Real(scissor.x0), Real(scissor.y0), 0}, {Real(scissor.x1), Real(scissor.y1), 0}};
  }

  void set_dots(const Box& box, IntegerBody& body) const {
    const Scissor& scissor = page_.scissor;
    const auto dot = [](Real v) { return static_cast<std::int32_t>(v); };
    body.x0 = std::max(scissor.x0, dot(floor_of(box.low[0])));
    body.y0 = std::max(scissor.y0, dot(floor_of(box.low[1])));
    body.x1 = std::min(scissor.x1, dot(-floor_of(-box.high[0])));
    body.y1 = std::min(scissor.y1, dot(-floor_of(-box.high[1])));
  }

  const Scene& source_;
  const FlattenOptions& options_;
  Real width_, height_;
  FlattenResult result_;
  PlacedScene placed_;
  View view_;
  PageMap page_;
  std::array<Vector4, 3> normal_rows_{};
  std::vector<PageHalfSpace> half_spaces_;
  std::deque<PlacedHalfSpace> plane_factors_;  // what plane pairs mate as
  std::vector<Surface> surfaces_;
  std::unordered_map<const BodyStatement*, bool> meetings_;  // may quadrics meet in it?
  std::vector<Extent> extents_;  // of the bodies in the view frame, if the window needed them
  std::vector<BodyBox> body_boxes_;
  std::vector<Box> boxes_;  // of the bodies, in dots, with their depths limited
};

}  // namespace

FlattenResult flatten(const Scene& scene, const FlattenOptions& options) { return Flattener(scene, options).run(); }

}  // namespace halfspace
