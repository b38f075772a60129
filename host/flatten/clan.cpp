#include "host/flatten/clan.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace halfspace {
namespace {

// factor * (F + constant), F the clan's.
struct InClan {
  Real factor = 1;
  Real constant = 0;
};

// The half-spaces of each group, in their order.
class Groups {
 public:
  Groups(std::span<const std::optional<std::size_t>> group_of, std::size_t count) : first_(count + 1) {
    for (const auto& group : group_of) {
      if (group) ++first_[*group + 1];
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    members_.resize(first_.back());
    std::vector<std::size_t> next = first_;
    for (std::size_t i = 0; i < group_of.size(); ++i) {
      if (group_of[i]) members_[next[*group_of[i]]++] = i;
    }
  }

  [[nodiscard]] std::span<const std::size_t> operator[](std::size_t group) const {
    return std::span(members_).subspan(first_[group], first_[group + 1] - first_[group]);
  }

 private:
  std::vector<std::size_t> first_, members_;
};

// Numbers for the families of the half-spaces that take part.
std::vector<std::optional<std::size_t>> families_of(const PlacedScene& scene, SurfaceOf surface_of) {
  struct Entry {
    std::pair<std::size_t, std::size_t> family;  // place and number
    std::size_t half_space;
  };
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < surface_of.size(); ++i) {
    const PlacedHalfSpace& h = scene.half_spaces[i];
    if (surface_of[i]) entries.push_back({{h.place, h.kin.family}, i});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.family < b.family; });
  std::vector<std::optional<std::size_t>> families(surface_of.size());
  std::size_t count = 0;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    if (k > 0 && entries[k].family != entries[k - 1].family) ++count;
    families[entries[k].half_space] = count;
  }
  return families;
}

class Search {
 public:
  Search(const PlacedScene& scene, SurfaceOf surface_of, std::size_t surfaces)
      : scene_(scene),
        surface_of_(surface_of),
        users_(surface_of, surfaces),
        is_known_(surfaces, 0),
        family_of_(families_of(scene, surface_of)),
        families_(family_of_, surface_of.size()),
        is_family_known_(surface_of.size(), 0) {}

  std::vector<Clan> run() {
    std::vector<Clan> clans;
    for (std::size_t surface = 0; surface < is_known_.size(); ++surface) {
      if (is_known_[surface] != 0 || users_[surface].empty()) continue;
      const std::size_t first = users_[surface].front();
      if (users_[surface].size() == 1 && families_[family_of(first)].size() == 1) continue;
      Clan clan = clan_from(first);
      if (clan.surfaces.size() > 1) clans.push_back(std::move(clan));
    }
    return clans;
  }

 private:
  // Of one that has a surface.
  [[nodiscard]] std::size_t family_of(std::size_t half_space) const { return *family_of_[half_space]; }

  // Breadth first over the families, each in the clan's terms.
  Clan clan_from(std::size_t first) {
    Clan clan;
    first_family_ = family_of(first);
    clan.place = scene_.half_spaces[first].place;
    waiting_.assign(1, {first_family_, InClan{}});
    is_family_known_[first_family_] = 1;
    for (std::size_t next = 0; next < waiting_.size(); ++next) {
      const auto [family, terms] = waiting_[next];
      for (const std::size_t i : families_[family]) {
        if (std::exchange(is_known_[*surface_of_[i]], 1) != 0) continue;
        add_surface(i, terms, clan);
      }
    }
    return clan;
  }

  // Half-space i is ratio (its family's F + constant), the family's F is terms.factor (F + terms.constant).
  void add_surface(std::size_t i, const InClan& terms, Clan& clan) {
    const Kinship& kin = scene_.half_spaces[i].kin;
    const InClan own{kin.ratio * terms.factor, terms.constant + kin.constant / terms.factor};
    const std::span<const std::size_t> users = users_[*surface_of_[i]];
    clan.surfaces.push_back(*surface_of_[i]);
    clan.members.push_back(member_for(users.front(), i, own, clan.members));
    for (const std::size_t j : users) {
      const std::size_t family = family_of(j);
      if (std::exchange(is_family_known_[family], 1) != 0 || !has_news(family)) continue;
      const Kinship& other = scene_.half_spaces[j].kin;
      const Real factor = factor_of(j, i) * own.factor / other.ratio;
      waiting_.push_back({family, {factor, own.constant - other.constant / factor}});
    }
  }

  [[nodiscard]] bool has_news(std::size_t family) const {
    const std::span<const std::size_t> members = families_[family];
    return std::any_of(members.begin(), members.end(), [&](std::size_t k) { return is_known_[*surface_of_[k]] == 0; });
  }

  // As its first half-space writes it: verbatim where that is of the clan's first family.
  [[nodiscard]] FamilyMember member_for(std::size_t leader, std::size_t i, const InClan& own,
                                        const std::vector<FamilyMember>& members) const {
    const PlacedHalfSpace& h = scene_.half_spaces[leader];
    if (family_of(leader) == first_family_) return {h.shape, h.kin};
    const Real factor = leader == i ? own.factor : own.factor * factor_of(leader, i);
    const FamilyMember& first = members.front();
    FamilyMember member{{HalfSpaceKind::quadric, {}}, {h.kin.family, factor, own.constant, h.kin.squares, h.kin.rank}};
    for (std::size_t k = 0; k < 9; ++k) member.shape.c[k] = factor * first.shape.c[k] / first.kin.ratio;
    member.shape.c[9] = factor * own.constant;
    return member;
  }

  // What half-space j is written with, for 1 in half-space i. Both have one surface.
  [[nodiscard]] Real factor_of(std::size_t j, std::size_t i) const {
    const auto on_page = [&](std::size_t k) {
      const PlacedHalfSpace& h = scene_.half_spaces[k];
      return transformed(h.shape, scene_.places[h.place]).c;
    };
    const auto a = on_page(j);
    const auto b = on_page(i);
    const auto pivot = std::max_element(b.begin(), b.end(), [](Real v, Real w) { return magnitude(v) < magnitude(w); });
    return a[static_cast<std::size_t>(pivot - b.begin())] / *pivot;
  }

  const PlacedScene& scene_;
  SurfaceOf surface_of_;
  Groups users_;                // of each surface
  std::vector<char> is_known_;  // which surfaces are in a clan
  std::vector<std::optional<std::size_t>> family_of_;
  Groups families_;
  std::vector<char> is_family_known_;
  std::size_t first_family_ = 0;  // of the clan that is being searched
  std::vector<std::pair<std::size_t, InClan>> waiting_;
};

}  // namespace

std::vector<Clan> clans_of(const PlacedScene& scene, SurfaceOf surface_of, std::size_t surfaces) {
  return Search(scene, surface_of, surfaces).run();
}

}  // namespace halfspace
