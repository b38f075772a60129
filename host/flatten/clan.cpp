#include "host/flatten/clan.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace halfspace {
namespace {

// factor * (F + constant), F the clan's.
struct InClan {
  Real factor = 1;
  Real constant = 0;
};

class Search {
 public:
  Search(const PlacedScene& scene, SurfaceOf surface_of, std::size_t surfaces)
      : scene_(scene), surface_of_(surface_of), users_(surfaces), is_known_(surfaces, 0) {
    for (std::size_t i = 0; i < surface_of.size(); ++i) {
      if (!surface_of[i]) continue;
      users_[*surface_of[i]].push_back(i);
      families_[key_of(i)].members.push_back(i);
    }
  }

  std::vector<Clan> run() {
    std::vector<Clan> clans;
    for (std::size_t surface = 0; surface < users_.size(); ++surface) {
      if (is_known_[surface] != 0 || users_[surface].empty()) continue;
      const std::size_t first = users_[surface].front();
      if (users_[surface].size() == 1 && families_.at(key_of(first)).members.size() == 1) continue;
      Clan clan = clan_from(first);
      if (clan.surfaces.size() > 1) clans.push_back(std::move(clan));
    }
    return clans;
  }

 private:
  using Key = std::pair<std::size_t, std::size_t>;
  struct FamilyEntry {
    std::vector<std::size_t> members;  // half-spaces
    bool is_known = false;
  };

  [[nodiscard]] Key key_of(std::size_t half_space) const {
    const PlacedHalfSpace& h = scene_.half_spaces[half_space];
    return {h.place, h.kin.family};
  }

  // Breadth first over the families, each in the clan's terms.
  Clan clan_from(std::size_t first) {
    Clan clan;
    first_key_ = key_of(first);
    clan.place = first_key_.first;
    waiting_.assign(1, {&families_.at(first_key_), InClan{}});
    waiting_.front().first->is_known = true;
    for (std::size_t next = 0; next < waiting_.size(); ++next) {
      const auto [family, terms] = waiting_[next];
      for (const std::size_t i : family->members) {
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
    const std::vector<std::size_t>& users = users_[*surface_of_[i]];
    clan.surfaces.push_back(*surface_of_[i]);
    clan.members.push_back(member_for(users.front(), i, own, clan.members));
    for (const std::size_t j : users) {
      FamilyEntry& family = families_.at(key_of(j));
      if (std::exchange(family.is_known, true) || !has_news(family)) continue;
      const Kinship& other = scene_.half_spaces[j].kin;
      const Real factor = factor_of(j, i) * own.factor / other.ratio;
      waiting_.push_back({&family, {factor, own.constant - other.constant / factor}});
    }
  }

  [[nodiscard]] bool has_news(const FamilyEntry& family) const {
    return std::any_of(family.members.begin(), family.members.end(),
                       [&](std::size_t k) { return is_known_[*surface_of_[k]] == 0; });
  }

  // As its first half-space writes it: verbatim where that is of the clan's first family.
  [[nodiscard]] FamilyMember member_for(std::size_t leader, std::size_t i, const InClan& own,
                                        const std::vector<FamilyMember>& members) const {
    const PlacedHalfSpace& h = scene_.half_spaces[leader];
    if (key_of(leader) == first_key_) return {h.shape, h.kin};
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
  std::vector<std::vector<std::size_t>> users_;  // of each surface
  std::vector<char> is_known_;                   // which surfaces are in a clan
  std::map<Key, FamilyEntry> families_;
  Key first_key_;  // of the clan that is being searched
  std::vector<std::pair<FamilyEntry*, InClan>> waiting_;
};

}  // namespace

std::vector<Clan> clans_of(const PlacedScene& scene, SurfaceOf surface_of, std::size_t surfaces) {
  return Search(scene, surface_of, surfaces).run();
}

}  // namespace halfspace
