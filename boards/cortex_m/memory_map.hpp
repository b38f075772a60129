// memory_map.hpp - what the linker script laid out: the arena, and the stack with its high-water mark.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace halfspace::cortex_m {

// All RAM that variables and stack leave; aligned to 8 bytes.
[[nodiscard]] std::span<std::byte> arena();

// The stack is painted before main; the deepest word that lost its paint says how much was used.
void paint_stack();
[[nodiscard]] std::size_t stack_used();
[[nodiscard]] std::size_t stack_size();

}  // namespace halfspace::cortex_m
