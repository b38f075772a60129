// What compiler and standard headers call even in a freestanding program. Byte by byte: a Cortex-M0 faults on unaligned words, and nothing in the core copies much.
#include <cstddef>

#include "boards/microbit/semihosting.hpp"

// Without this the compiler would turn each loop into a call of the function it stands in.
#define HALFSPACE_PLAIN_LOOP __attribute__((optimize("no-tree-loop-distribute-patterns")))

extern "C" {

HALFSPACE_PLAIN_LOOP void* memcpy(void* to, const void* from, std::size_t count) {
  auto* t = static_cast<unsigned char*>(to);
  const auto* f = static_cast<const unsigned char*>(from);
  for (std::size_t i = 0; i < count; ++i) t[i] = f[i];
  return to;
}

HALFSPACE_PLAIN_LOOP void* memmove(void* to, const void* from, std::size_t count) {
  auto* t = static_cast<unsigned char*>(to);
  const auto* f = static_cast<const unsigned char*>(from);
  if (t < f) {
    for (std::size_t i = 0; i < count; ++i) t[i] = f[i];
  } else {
    for (std::size_t i = count; i > 0; --i) t[i - 1] = f[i - 1];
  }
  return to;
}

HALFSPACE_PLAIN_LOOP void* memset(void* to, int value, std::size_t count) {
  auto* t = static_cast<unsigned char*>(to);
  for (std::size_t i = 0; i < count; ++i) t[i] = static_cast<unsigned char>(value);
  return to;
}

HALFSPACE_PLAIN_LOOP int memcmp(const void* a, const void* b, std::size_t count) {
  const auto* p = static_cast<const unsigned char*>(a);
  const auto* q = static_cast<const unsigned char*>(b);
  for (std::size_t i = 0; i < count; ++i) {
    if (p[i] != q[i]) return p[i] - q[i];
  }
  return 0;
}

HALFSPACE_PLAIN_LOOP std::size_t strlen(const char* text) {
  std::size_t n = 0;
  while (text[n] != '\0') ++n;
  return n;
}

[[noreturn]] void __cxa_pure_virtual() { halfspace::microbit::exit_program(98); }
}
