#include "boards/cortex_m/memory_map.hpp"

extern "C" std::byte arena_begin[], arena_end[];
extern "C" std::uint32_t stack_limit[], stack_top[];

namespace halfspace::cortex_m {
namespace {

constexpr std::uint32_t paint = 0x5ca1ab1e;

std::size_t bytes_between(const volatile void* low, const volatile void* high) {
  return reinterpret_cast<std::uintptr_t>(high) - reinterpret_cast<std::uintptr_t>(low);
}

}  // namespace

std::span<std::byte> arena() { return {arena_begin, bytes_between(arena_begin, arena_end)}; }

// Up to a few words below its own frame, which is the lowest in use.
void paint_stack() {
  auto* const end = static_cast<volatile std::uint32_t*>(__builtin_frame_address(0)) - 16;
  for (volatile std::uint32_t* word = stack_limit; word < end; ++word) *word = paint;
}

std::size_t stack_used() {
  const volatile std::uint32_t* word = stack_limit;
  while (word < stack_top && *word == paint) ++word;
  return bytes_between(word, stack_top);
}

std::size_t stack_size() { return bytes_between(stack_limit, stack_top); }

}  // namespace halfspace::cortex_m
