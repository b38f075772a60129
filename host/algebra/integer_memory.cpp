#include "host/algebra/integer_memory.hpp"

#include <gmp.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <utility>

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace halfspace {
namespace {

struct Waiting {
  Waiting* next;
};

constexpr std::size_t list_count = 9;
thread_local std::array<Waiting*, list_count> lists{};  // list k: of blocks of 16 k + 8 bytes

// Blocks that were never used are cut from here: side by side, as the numbers of one body are asked for together.
constexpr std::size_t stock_size = 1 << 15;
thread_local std::byte* stock = nullptr;
thread_local std::size_t stock_left = 0;

constexpr std::size_t list_for(std::size_t bytes) { return std::max<std::size_t>((bytes + 7) / 16, 1); }

void* checked(void* block) {
  if (block == nullptr) {  // GMP has no other way to fail
    std::fputs("error: out of memory\n", stderr);
    std::abort();
  }
  return block;
}

void* cut(std::size_t bytes) {
  if (stock_left < bytes) {
    stock = static_cast<std::byte*>(checked(std::malloc(stock_size)));
    stock_left = stock_size;
  }
  stock_left -= bytes;
  return std::exchange(stock, stock + bytes);
}

void* allocate(std::size_t bytes) {
  const std::size_t list = list_for(bytes);
  if (list >= list_count) return checked(std::malloc(bytes));
  Waiting* const first = lists[list];
  if (first == nullptr) return cut(16 * list + 8);
  lists[list] = first->next;
  return first;
}

void release(void* block, std::size_t bytes) {
  const std::size_t list = list_for(bytes);
  if (list >= list_count) return std::free(block);
  lists[list] = new (block) Waiting{lists[list]};
}

void* resize(void* block, std::size_t former, std::size_t bytes) {
  const std::size_t list = list_for(bytes);
  if (list == list_for(former) && list < list_count) return block;
  if (std::min(list, list_for(former)) >= list_count) return checked(std::realloc(block, bytes));
  void* const moved = allocate(bytes);
  std::memcpy(moved, block, std::min(former, bytes));
  release(block, former);
  return moved;
}

}  // namespace

void keep_memory() {
  mp_set_memory_functions(allocate, resize, release);
#if defined(__GLIBC__)
  constexpr int large = 1 << 25;  // bytes; the most that malloc may be told
  mallopt(M_MMAP_THRESHOLD, large);
  mallopt(M_TRIM_THRESHOLD, 8 * large);
#endif
}

}  // namespace halfspace
