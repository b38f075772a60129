// What compiler and standard headers call even in a freestanding program. The core clears and copies whole words, and
// spends a quarter of its time here if that goes byte by byte; a Cortex-M0 faults on an unaligned word, so bytes remain
// for the rest.
#include <cstddef>
#include <cstdint>

#include "boards/cortex_m/semihosting.hpp"

// Without this the compiler would turn each loop into a call of the function it stands in.
#define HALFSPACE_PLAIN_LOOP __attribute__((optimize("no-tree-loop-distribute-patterns")))

namespace {

using Word [[gnu::may_alias]] = std::uint32_t;

bool on_words(const void* p) { return reinterpret_cast<std::uintptr_t>(p) % sizeof(Word) == 0; }

}  // namespace

extern "C" {

HALFSPACE_PLAIN_LOOP void* memcpy(void* to, const void* from, std::size_t count) {
  std::size_t done = 0;
  if (on_words(to) && on_words(from)) {
    for (; done + sizeof(Word) <= count; done += sizeof(Word)) {
      static_cast<Word*>(to)[done / sizeof(Word)] = static_cast<const Word*>(from)[done / sizeof(Word)];
    }
  }
  auto* t = static_cast<unsigned char*>(to);
  const auto* f = static_cast<const unsigned char*>(from);
  for (; done < count; ++done) t[done] = f[done];
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
  const auto byte = static_cast<unsigned char>(value);
  const Word word = byte * 0x01010101U;
  std::size_t done = 0;
  if (on_words(to)) {
    for (; done + sizeof(Word) <= count; done += sizeof(Word)) static_cast<Word*>(to)[done / sizeof(Word)] = word;
  }
  for (auto* t = static_cast<unsigned char*>(to); done < count; ++done) t[done] = byte;
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

[[noreturn]] void __cxa_pure_virtual() { halfspace::cortex_m::exit_program(98); }
}
