// span_list.hpp - one scan line cut into visible spans, nearest faces first to last from left to right.
// Method  Intervals of faces are inserted in ascending order of their first dot; where one overlaps spans
// already
//         there, DepthOrder decides piece by piece. Ties go to the lower face order, so the result does not
//         depend on the order of insertion.
// Memory  A pool of spans lent by the caller, cleared for every line; 8 bytes a span. insert() is false when
// it is full.
#pragma once

#include <cstdint>
#include <span>

#include "firmware/core/depth.hpp"
#include "firmware/core/face.hpp"
#include "firmware/core/job_format.hpp"

namespace halfspace {

struct Span {
  std::int16_t x0, x1;  // dots, inclusive
  std::uint16_t face;   // slot
  std::uint16_t next;   // no_slot: the last one
};

class SpanList {
 public:
  SpanList(std::span<Span> pool, std::span<ActiveFace> faces, const ExactModule& exact, Counters& counters)
      : pool_(pool), faces_(faces), exact_(exact), counters_(counters) {}

  void clear(std::int32_t y);
  // Merges dots x0 .. x1 of a face. x0 must not be less than in the call before.
  [[nodiscard]] bool insert(std::uint16_t face, std::int32_t x0, std::int32_t x1);

  // Spans in use: the high-water mark of the line.
  [[nodiscard]] std::int32_t used() const { return used_; }
  [[nodiscard]] std::uint16_t first() const { return first_; }
  [[nodiscard]] const Span& at(std::uint16_t i) const { return pool_[i]; }

 private:
  bool add(std::uint16_t face, std::int32_t x0, std::int32_t x1);
  void remove(std::uint16_t slot);
  DepthProof& known_order(std::uint16_t face, std::uint16_t old_face, std::int32_t x0, std::int32_t x1);
  bool contest(DepthProof& proof, std::uint16_t face, std::uint16_t old_face, std::int32_t x0, std::int32_t x1);

  std::span<Span> pool_;
  std::span<ActiveFace> faces_;
  const ExactModule& exact_;
  Counters& counters_;
  DepthProof unproven_;  // of faces of which nothing is kept
  std::int32_t y_ = 0;
  std::int32_t used_ = 0;
  std::uint16_t first_ = no_slot;
  std::uint16_t free_ = no_slot;  // slots taken out of the list
  std::uint16_t last_ = no_slot;  // the span before the next one to be placed
  std::uint16_t hint_ = no_slot;  // every span up to this one ends before the last inserted x0
};

}  // namespace halfspace
