// active_list.hpp - the slots of what crosses the current line: those awake in front, those that rest (curtain.hpp) at the back.
//
//     [ awake, in order ->      |  free  |      <- at rest ]
//
// Owner   The words are lent, one for each slot there is; each slot is in the list once at most, so it cannot overflow.
// Cost    What rests costs a line nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace halfspace {

class ActiveList {
 public:
  explicit ActiveList(std::span<std::uint16_t> words) : words_(words) {}

  [[nodiscard]] std::span<std::uint16_t> awake() { return words_.first(awake_); }
  [[nodiscard]] std::span<const std::uint16_t> resting() const { return words_.last(resting_); }
  [[nodiscard]] std::size_t size() const { return awake_ + resting_; }

  void add(std::uint16_t slot) { words_[awake_++] = slot; }

  // Those awake that leave; the others keep their order.
  template <class Leaves>
  void remove(const Leaves& leaves) {
    std::size_t kept = 0;
    for (const std::uint16_t slot : awake()) {
      if (!leaves(slot)) words_[kept++] = slot;
    }
    awake_ = kept;
  }
  // Lays those of the awake, from the one at `first` on, to rest that may; the order of these is lost.
  template <class Rests>
  void rest(std::size_t first, const Rests& rests) {
    for (std::size_t i = first; i < awake_;) {
      const std::uint16_t slot = words_[i];
      if (!rests(slot)) {
        ++i;
        continue;
      }
      words_[i] = words_[--awake_];
      words_[words_.size() - ++resting_] = slot;
    }
  }
  void wake_all() {
    for (const std::uint16_t slot : resting()) add(slot);
    resting_ = 0;
  }
  // False: it does not rest.
  bool wake(std::uint16_t slot) {
    const std::span<std::uint16_t> all = words_.last(resting_);
    const auto found = std::find(all.begin(), all.end(), slot);
    if (found == all.end()) return false;
    *found = all.front();
    --resting_;
    add(slot);
    return true;
  }

 private:
  std::span<std::uint16_t> words_;
  std::size_t awake_ = 0, resting_ = 0;
};

}  // namespace halfspace
