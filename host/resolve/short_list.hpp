// short_list.hpp - a list of plain values, mostly of one or two: these lie in the list itself, and need no heap.
#pragma once

#include <array>
#include <cstddef>
#include <initializer_list>
#include <type_traits>
#include <vector>

namespace halfspace {

template <class T, std::size_t inside = 2>
class ShortList {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  ShortList() = default;
  ShortList(std::initializer_list<T> items) {
    for (const T& item : items) push_back(item);
  }

  void push_back(const T& item) {
    if (size_ < inside) {
      few_[size_] = item;
    } else {
      if (size_ == inside) many_.assign(few_.begin(), few_.end());
      many_.push_back(item);
    }
    ++size_;
  }

  [[nodiscard]] const T* begin() const { return size_ <= inside ? few_.data() : many_.data(); }
  [[nodiscard]] const T* end() const { return begin() + size_; }
  [[nodiscard]] const T& front() const { return *begin(); }

 private:
  std::array<T, inside> few_{};
  std::size_t size_ = 0;
  std::vector<T> many_;  // all of them, once they are more
};

}  // namespace halfspace
