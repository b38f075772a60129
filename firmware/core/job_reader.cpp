#include "firmware/core/job_reader.hpp"

namespace halfspace {

bool JobReader::refill() {
  next_ = 0;
  end_ = failed_ ? 0 : source_.read(buffer_);
  if (end_ != 0 && end_ <= buffer_.size()) return true;
  failed_ = true;
  end_ = 0;
  return false;
}

std::uint64_t JobReader::varint(int max_bits) {
  std::uint64_t value = 0;
  for (int shift = 0; shift < max_bits; shift += 7) {
    const std::uint8_t b = byte();
    value |= static_cast<std::uint64_t>(b & 0x7fU) << shift;
    if ((b & 0x80U) == 0) return value;
  }
  failed_ = true;
  return 0;
}

std::uint32_t JobReader::unsigned_number() {
  const std::uint64_t value = varint(32);
  if (value > 0xffffffffU) failed_ = true;
  return static_cast<std::uint32_t>(value);
}

std::int64_t JobReader::number() {
  const std::uint64_t value = varint(64);
  return static_cast<std::int64_t>(value >> 1) ^ -static_cast<std::int64_t>(value & 1U);
}

std::int32_t JobReader::number_in(std::int32_t low, std::int32_t high) {
  const std::int64_t value = number();
  if (value < low || value > high) {
    failed_ = true;
    return low;
  }
  return static_cast<std::int32_t>(value);
}

std::int64_t JobReader::number_within(std::int64_t limit) {
  const std::int64_t value = number();
  if (value >= -limit && value <= limit) return value;
  failed_ = true;
  return 0;
}

namespace {

constexpr std::int32_t max_pool = 65534;  // a slot number is 16 bits, no_slot apart

void read_page(JobReader& in, JobHeader& h) {
  h.page.width = in.number_in(1, largest_side);
  h.page.height = in.number_in(1, largest_side);
  h.page.format = in.number_in(0, 1) == 0 ? DotFormat::bilevel : DotFormat::gray;
  h.page.levels = in.number_in(2, 256);
  h.page.background = in.number_in(0, h.page.levels - 1);
  h.screen = static_cast<Screen>(in.number_in(0, 2));
  h.x0 = in.number_in(0, h.page.width);
  h.y0 = in.number_in(0, h.page.height);
  h.x1 = in.number_in(-1, h.page.width - 1);
  h.y1 = in.number_in(-1, h.page.height - 1);
  h.bound = in.unsigned_number();
}

void read_lighting(JobReader& in, Lighting& l) {
  for (auto& row : l.matrix) {
    for (auto& m : row) m = in.number_in(-largest_matrix, largest_matrix);
  }
  for (auto& c : l.light) c = in.number_in(-largest_light, largest_light);
  l.unit = in.number_in(1, 1 << 16);
  l.ambient = in.number_in(0, l.unit);
  l.parallel = in.number_in(0, l.unit);
}

void read_needs(JobReader& in, JobNeeds& n) {
  n.faces = in.number_in(0, max_pool);
  n.arcs = in.number_in(0, max_pool);
  n.cells = in.number_in(0, max_pool);
  n.spans = in.number_in(0, max_pool);
  n.arc_bytes = in.number_in(0, 1024);
  n.exact_bits = in.number_in(0, 4096);
}

}  // namespace

bool read_header(JobReader& in, JobHeader& header) {
  for (const std::uint8_t expected : job_magic) {
    if (in.byte() != expected) return false;
  }
  read_page(in, header);
  read_lighting(in, header.lighting);
  read_needs(in, header.needs);
  return !in.failed();
}

}  // namespace halfspace
