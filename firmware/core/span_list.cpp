#include "firmware/core/span_list.hpp"

#include <algorithm>

#include "firmware/core/radical_plane.hpp"

namespace halfspace {

void SpanList::clear(std::int32_t y) {
  y_ = y;
  used_ = 0;
  first_ = free_ = last_ = hint_ = no_slot;
}

// Appends after last_, joining with it when the same face goes on. The span at hint_ must keep its end.
bool SpanList::add(std::uint16_t face, std::int32_t x0, std::int32_t x1) {
  if (last_ != hint_ && pool_[last_].face == face && pool_[last_].x1 + 1 == x0) {
    pool_[last_].x1 = static_cast<std::int16_t>(x1);
    return true;
  }
  std::uint16_t slot = free_;
  if (slot != no_slot) {
    free_ = pool_[slot].next;
  } else if (used_ < static_cast<std::int32_t>(pool_.size()) && used_ < no_slot) {
    slot = static_cast<std::uint16_t>(used_++);
  } else {
    return false;
  }
  std::uint16_t& link = last_ == no_slot ? first_ : pool_[last_].next;
  pool_[slot] = {static_cast<std::int16_t>(x0), static_cast<std::int16_t>(x1), face, link};
  link = slot;
  last_ = slot;
  return true;
}

// Takes out the span after last_.
void SpanList::remove(std::uint16_t slot) {
  (last_ == no_slot ? first_ : pool_[last_].next) = pool_[slot].next;
  pool_[slot].next = free_;
  free_ = slot;
}

// What is known of a face and the old one on dots x0 .. x1, all covered by the old one until now.
DepthProof& SpanList::known_order(std::uint16_t face, std::uint16_t old_face, std::int32_t x0, std::int32_t x1) {
  ActiveFace& f = faces_[face];
  const ActiveFace& g = faces_[old_face];
  if (f.kind != FaceKind::rational && g.kind != FaceKind::rational) return proven_order(f, g, y_, x0, x1);
  return unproven_ = {};
}

// The nearer of both, piece by piece.
bool SpanList::contest(DepthProof& proof, std::uint16_t face, std::uint16_t old_face, std::int32_t x0,
                       std::int32_t x1) {
  if (proof.nearer < 0) return add(face, x0, x1);
  if (proof.radical.fraction != RadicalPlane::missing) {
    const std::uint16_t inner = proof.inner < 0 ? face : old_face;
    const std::uint16_t outer = proof.inner < 0 ? old_face : face;
    InnerDots dots;
    if (find_inner_dots(faces_[inner], proof, y_, x0, x1, dots)) {
      if (dots.from > dots.to) return add(outer, x0, x1);
      return (dots.from == x0 || add(outer, x0, dots.from - 1)) && add(inner, dots.from, dots.to) &&
             (dots.to == x1 || add(outer, dots.to + 1, x1));
    }
  }
  if (proof.turn != 0) {
    const std::int32_t turn = find_turn(faces_[face], faces_[old_face], proof, y_, x0, x1, counters_);
    const std::uint16_t before = proof.turn > 0 ? face : old_face;
    const std::uint16_t behind = proof.turn > 0 ? old_face : face;
    if (turn >= 0) return (turn == x0 || add(before, x0, turn - 1)) && (turn > x1 || add(behind, turn, x1));
  }
  DepthOrder order(faces_[face], faces_[old_face], proof, y_, x0, x1, exact_, counters_);
  while (!order.done()) {
    const DepthOrder::Piece piece = order.next();
    if (!add(piece.first ? face : old_face, x0, piece.end)) return false;
    x0 = piece.end + 1;
  }
  return true;
}

bool SpanList::insert(std::uint16_t face, std::int32_t x0, std::int32_t x1) {
  ++counters_.face_inserts;
  const Span* const pool = pool_.data();
  const ActiveFace* const faces = faces_.data();
  std::uint16_t current = hint_ == no_slot ? first_ : pool[hint_].next;
  while (current != no_slot && pool[current].x1 < x0) {
    hint_ = current;
    current = pool[current].next;
  }
  last_ = hint_;
  const DepthBlock& block = bounded(faces_[face], y_, x0, x1, counters_);
  while (x0 <= x1) {
    // Spans that lie in front altogether stay as they are.
    while (current != no_slot && pool[current].x0 <= x0 && faces[pool[current].face].block.high < block.low) {
      last_ = current;
      x0 = pool[current].x1 + 1;
      if (x0 > x1) return true;
      current = pool[current].next;
    }
    if (current == no_slot || pool[current].x0 > x1) return add(face, x0, x1);
    const Span old = pool[current];
    if (x0 < old.x0) {
      if (!add(face, x0, old.x0 - 1)) return false;
      x0 = old.x0;
      continue;
    }
    const std::int32_t end = std::min<std::int32_t>(x1, old.x1);
    const bool nearer = block.high < faces[old.face].block.low;
    DepthProof* const proof = nearer ? nullptr : &known_order(face, old.face, x0, end);
    if (!nearer && proof->nearer > 0) {
      last_ = current;
      x0 = end + 1;
      current = old.next;
      continue;
    }
    // Take the old span out and put back, in order: what lies before, the contested dots, what lies behind.
    remove(current);
    if (old.x0 < x0 && !add(old.face, old.x0, x0 - 1)) return false;
    if (!(nearer ? add(face, x0, end) : contest(*proof, face, old.face, x0, end))) return false;
    if (end < old.x1) return add(old.face, end + 1, old.x1);
    x0 = end + 1;
    current = old.next;
  }
  return true;
}

}  // namespace halfspace
