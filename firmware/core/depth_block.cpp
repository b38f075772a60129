#include "firmware/core/depth_block.hpp"

#include <algorithm>

#include "firmware/core/isqrt.hpp"
#include "firmware/core/quick_root.hpp"
#include "firmware/core/radical_plane.hpp"
#include "firmware/core/root_surface.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t largest_dot = 32767;
constexpr std::int32_t least_rows = 8;      // of a proof
constexpr std::int32_t most_rows = 256;     // of a block
constexpr std::int32_t column_rows = 16;    // of a proof by columns
constexpr std::int32_t least_column = 8;    // dots
constexpr std::int32_t column_margin = 16;  // dots that its run may move by
constexpr std::int64_t most_dots = largest_depth >> depth_fraction;

int bits_of(std::int32_t length) { return static_cast<int>(std::bit_width(static_cast<std::uint32_t>(length))); }

}  // namespace

DepthRange root_over(const DepthBlock& k, const BlockPart& p) {
  DepthRange d{INT64_MAX, INT64_MIN};  // of the corners
  for (const std::int32_t s : {p.s0, p.s1}) {
    const std::int64_t start = k.d + part(k.dy + k.dyy * s, s, k.y_bits);
    const std::int64_t slope = k.dx + k.dxy * s;
    const std::int64_t left = start + part(slope + k.dxx * p.t0, p.t0, k.x_bits);
    const std::int64_t right = start + part(slope + k.dxx * p.t1, p.t1, k.x_bits);
    d = {std::min({d.low, left, right}), std::max({d.high, left, right})};
  }
  const std::int32_t w = p.t1 - p.t0;
  const std::int32_t h = p.s1 - p.s0;
  const std::int64_t bulge_x = part(k.dxx * w, w, k.x_bits) >> 2;
  const std::int64_t bulge_y = part(k.dyy * h, h, k.y_bits) >> 2;
  const std::int64_t error = 2 * k.shallow;
  const std::int64_t low = d.low - std::max<std::int64_t>(bulge_x, 0) - std::max<std::int64_t>(bulge_y, 0) - error;
  const std::int64_t high = d.high - std::min<std::int64_t>(bulge_x, 0) - std::min<std::int64_t>(bulge_y, 0) + error;
  const auto root = [](std::int64_t v) { return v > 0 ? quick_root(static_cast<std::uint64_t>(v)) : 0; };
  return {std::max<std::int64_t>(root(low) - 3, 0), root(high) + 3};
}

namespace {

// A bound of the depth in whole dots, on the side of `sign`, from that of n.
std::int64_t depth(const ActiveFace& face, std::int64_t n, int sign) {
  const std::int64_t z = (n * face.inverse) >> face.block.shift;
  const std::int64_t error = ((z < 0 ? -z : z) >> 29) + 2;
  return ((z + sign * error) >> depth_fraction) + (sign > 0 ? 1 : 0) + face.origin_z;
}

// Of -b in units over the part, errors taken in.
DepthRange numerator(const DepthBlock& k, const BlockPart& p) {
  const std::int64_t start = k.b + k.bx * p.t0 + k.by * p.s0;
  const std::int64_t x = k.bx * (p.t1 - p.t0);
  const std::int64_t y = k.by * (p.s1 - p.s0);
  const std::int64_t least = start + std::min<std::int64_t>(x, 0) + std::min<std::int64_t>(y, 0);
  const std::int64_t greatest = start + std::max<std::int64_t>(x, 0) + std::max<std::int64_t>(y, 0);
  return {-(greatest >> 16) - 3, -(least >> 16) + 2};
}

// Of the depth in whole dots over a part of the face's block.
DepthRange depth_on(const ActiveFace& face, const BlockPart& p) {
  DepthRange n = numerator(face.block, p);
  if (face.kind == FaceKind::root) {
    const DepthRange r = root_over(face.block, p);
    n.low += face.sheet < 0 ? -r.high : r.low;
    n.high += face.sheet < 0 ? -r.low : r.high;
  }
  return {depth(face, n.low, -1), depth(face, n.high, 1)};
}

class Maker {
 public:
  Maker(const ActiveFace& face, DepthBlock& block)
      : f_(face),
        k_(block),
        w_(block.x1 - block.x0),
        h_(block.y1 - block.y0),
        x_(block.x0 - face.origin_x),
        y_(block.y0 - face.origin_y) {
    k_.x_bits = static_cast<std::int8_t>(bits_of(w_));
    k_.y_bits = static_cast<std::int8_t>(bits_of(h_));
  }

  void make() {
    const bool root = f_.kind == FaceKind::root;
    const Wide<128> slope_x = f_.c[root ? 5 : 0];
    const Wide<128> slope_y = f_.c[root ? 4 : 1];
    const Wide<128> start = slope_x.times(x_) + slope_y.times(y_) + f_.c[root ? 8 : 3];
    int unit = std::max({start.bit_length(), slope_x.bit_length() + k_.x_bits, slope_y.bit_length() + k_.y_bits}) - 28;
    if (root) unit = load_discriminant(unit);
    k_.b = scaled(start, unit - 16);
    k_.bx = scaled(slope_x, unit - 16);
    k_.by = scaled(slope_y, unit - 16);
    bound(unit);
  }

 private:
  // Six terms below 2^57 squares of units each. Returns log2 of a unit, at least `unit`.
  int load_discriminant(int unit) {
    const ScaledQuadratic& form = f_.surface.discriminant;
    const Wide<128> d = form.at(x_, y_);
    const Wide<128> dx = form.q[0].times(2 * x_) + form.q[1].times(y_) + form.q[3];
    const Wide<128> dy = form.q[2].times(2 * y_) + form.q[1].times(x_) + form.q[4];
    const int x = bits_of(w_);
    const int y = bits_of(h_);
    const int bits = std::max({d.bit_length(), dx.bit_length() + x, dy.bit_length() + y, form.q[0].bit_length() + 2 * x,
                               form.q[1].bit_length() + x + y, form.q[2].bit_length() + 2 * y});
    // A rounded D must be off by less than a square of a unit.
    const int least = form.exponent > 0 ? quadratic_error_bits / 2 : -32;
    const int half = form.exponent / 2;
    const int shift = std::max({(bits - 56) >> 1, least, unit - half});
    k_.d = scaled(d, 2 * shift);
    k_.dx = scaled(dx, 2 * shift - x);
    k_.dxx = scaled(form.q[0], 2 * shift - x);
    k_.dxy = scaled(form.q[1], 2 * shift - x);
    k_.dy = scaled(dy, 2 * shift - y);
    k_.dyy = scaled(form.q[2], 2 * shift - y);
    k_.shallow = (1 << x) + (2 << y) + 6;
    return shift + half;
  }

  void bound(int unit) {
    k_.low = INT32_MIN;
    k_.high = INT32_MAX;
    k_.error = -1;
    const int shift = f_.inverse_exponent - unit - depth_fraction;
    if (shift < 0 || f_.origin_z > most_dots || f_.origin_z < -most_dots) return;
    k_.shift = static_cast<std::int8_t>(std::min(shift, 63));
    const DepthRange z = depth_on(f_, {0, w_, 0, h_});
    if (z.low < -most_dots || z.high > most_dots) return;
    k_.low = static_cast<std::int32_t>(z.low);
    k_.high = static_cast<std::int32_t>(z.high);
    k_.error = (std::int64_t{6} * f_.inverse >> k_.shift) + 3;
    const std::int64_t shallow = isqrt(static_cast<std::uint64_t>(k_.shallow)) + 6;
    k_.shallow_error = (shallow * f_.inverse >> k_.shift) + 3;
  }

  const ActiveFace& f_;
  DepthBlock& k_;
  std::int32_t w_, h_;
  std::int32_t x_, y_;  // the block's first dot in the face's frame
};

// Of a face's root over the dots and lines of a proof, in the block's units.
DepthRange root_on(const ActiveFace& face, const DepthProof& over) {
  if (face.kind != FaceKind::root) return {0, 0};
  const DepthBlock& k = face.block;
  return root_over(k, {over.x0 - k.x0, over.x1 - k.x0, over.y0 - k.y0, over.y1 - k.y0});
}

DepthRange operator-(const DepthRange& a, const DepthRange& b) { return {a.low - b.high, a.high - b.low}; }

// Of f less g in 2^-16 dots.
DepthRange difference(const ActiveFace& f, const ActiveFace& g, const DepthProof& over, const DepthRange& f_root,
                      const DepthRange& g_root) {
  constexpr std::int64_t none = std::int64_t{1} << 62;
  DepthRange linear{none, -none};
  const auto linear_at = [](const ActiveFace& face, std::int32_t x, std::int32_t y) {
    const DepthBlock& k = face.block;
    const std::int64_t b = k.b + k.bx * (x - k.x0) + k.by * (y - k.y0);
    return -((b >> 16) * face.inverse >> k.shift) + face.origin_z * (std::int64_t{1} << depth_fraction);
  };
  for (const std::int32_t y : {over.y0, over.y1}) {
    for (const std::int32_t x : {over.x0, over.x1}) {
      const std::int64_t at = linear_at(f, x, y) - linear_at(g, x, y);
      linear.low = std::min(linear.low, at);
      linear.high = std::max(linear.high, at);
    }
  }
  const auto in_dots = [](const ActiveFace& face, const DepthRange& root) -> DepthRange {
    const std::int64_t low = root.low * face.inverse >> face.block.shift;
    const std::int64_t high = root.high * face.inverse >> face.block.shift;
    return face.sheet < 0 ? DepthRange{-high, -low} : DepthRange{low, high};
  };
  const DepthRange root = in_dots(f, f_root);
  const DepthRange rival = in_dots(g, g_root);
  const std::int64_t error = 2 * (f.block.error + g.block.error);
  return {linear.low + root.low - rival.high - error, linear.high + root.high - rival.low + error};
}

int sign_of(const DepthRange& v) { return v.high < 0 ? -1 : (v.low > 0 ? 1 : 0); }

// DepthProof::nearer on all its dots.
int nearer_on(const ActiveFace& f, const ActiveFace& g, const DepthProof& over) {
  return sign_of(difference(f, g, over, root_on(f, over), root_on(g, over)));
}

// Of a face's slope along the line in 2^-16 dots a dot, where it exists; a side without bound: `steep`.
// With r = sqrt(D), r' = D' / 2 r, and D' is linear. docs/core.md, "Bound of a sample".
constexpr std::int64_t steep = std::int64_t{1} << 61;

DepthRange slope_on(const ActiveFace& face, const DepthProof& over, const DepthRange& root) {
  constexpr std::int64_t most = std::int64_t{1} << 35;  // in 2^-x_bits units a dot
  constexpr int low_bits = 6;                           // of these, left out
  const DepthBlock& k = face.block;
  const int shift = k.shift + k.x_bits - low_bits;
  if (k.x_bits < low_bits) return {-steep, steep};
  const std::int64_t linear = -(k.bx * (std::int64_t{1} << k.x_bits) >> 16);
  DepthRange n{linear - 2, linear};
  if (face.kind == FaceKind::root) {
    const std::int64_t across_x = 2 * k.dxx * (over.x1 - over.x0);
    const std::int64_t across_y = k.dxy * (over.y1 - over.y0);
    const std::int64_t corner = k.dx + k.dxy * (over.y0 - k.y0) + 2 * k.dxx * (over.x0 - k.x0);
    const std::int64_t low =
        corner + std::min<std::int64_t>(across_x, 0) + std::min<std::int64_t>(across_y, 0) - 2 * k.shallow;
    const std::int64_t high =
        corner + std::max<std::int64_t>(across_x, 0) + std::max<std::int64_t>(across_y, 0) + 2 * k.shallow;
    const auto over_root = [](std::int64_t v, std::int64_t r) {
      return r > 0 ? v / (2 * r) : (v < 0 ? -steep : steep);
    };
    const std::int64_t falls = over_root(low, low < 0 ? root.low : root.high) - 1;
    const std::int64_t rises = over_root(high, high > 0 ? root.low : root.high) + 1;
    n = face.sheet < 0 ? DepthRange{n.low - rises, n.high - falls} : DepthRange{n.low + falls, n.high + rises};
  }
  const auto in_dots = [&](std::int64_t v) { return (v >> low_bits) * face.inverse >> std::min(shift, 63); };
  const std::int64_t error = (std::int64_t{face.inverse} >> std::min(shift, 63)) + 2;
  const auto error_of = [&](std::int64_t z) { return error + ((z < 0 ? -z : z) >> 29); };
  DepthRange slope{-steep, steep};
  if (n.low > -most && n.low < most) slope.low = in_dots(n.low) - error_of(in_dots(n.low));
  if (n.high > -most && n.high < most) slope.high = in_dots(n.high) + error_of(in_dots(n.high));
  return slope;
}

// DepthProof::nearer, or else DepthProof::turn, by columns as wide as it takes.
void prove_by_columns(const ActiveFace& f, const ActiveFace& g, DepthProof& over) {
  DepthProof column = over;
  std::int32_t width = (over.x1 - over.x0) / 4;
  int nearer = 0, turn = 0;
  while (column.x0 < over.x1) {
    column.x1 = static_cast<std::int16_t>(std::min<std::int32_t>(column.x0 + width, over.x1));
    const DepthRange root = root_on(f, column);
    const DepthRange rival = root_on(g, column);
    const int here = sign_of(difference(f, g, column, root, rival));
    const int way = here != 0 ? turn : sign_of(slope_on(f, column, root) - slope_on(g, column, rival));
    if (here == 0 && (way == 0 || way == -turn)) {
      if (width < 2 * least_column) return;
      width /= 2;
      continue;
    }
    nearer = here;
    turn = way;
    column.x0 = column.x1;
    width *= 2;
  }
  over.turn = static_cast<std::int8_t>(turn);
  if (turn == 0) over.nearer = static_cast<std::int8_t>(nearer);
}

// How z bends along a line: -1 convex, 1 concave, 0 straight; 2: it cannot be told.
int bend_of(const ActiveFace& face) {
  if (face.kind == FaceKind::plane) return 0;
  return face.kind == FaceKind::root && face.surface.discriminant.q[0].negative() ? face.sheet : 2;
}

// c2 of f times that of g times the distance of their middles in depth, f's less g's: a constant where the other second-order terms are
// in proportion.
Wide<256> middle_distance(const ActiveFace& f, const ActiveFace& g) {
  using Int = Wide<256>;
  const Int a(f.c[2]);
  const Int middle = Int(f.c[5]).times(f.origin_x - g.origin_x) + Int(f.c[4]).times(f.origin_y - g.origin_y) +
                     a * (Int(f.origin_z) - Int(g.origin_z)) - Int(f.c[8]);
  return middle * Int(g.c[2]) + Int(g.c[8]) * a;
}

bool are_proportional(const ActiveFace& f, const ActiveFace& g) {
  using Int = Wide<256>;
  if (std::equal(f.c.begin(), f.c.begin() + 6, g.c.begin())) return true;
  const Int a(f.c[2]);
  const Int rival_a(g.c[2]);
  for (const int i : {0, 1, 3, 4, 5}) {
    if (Int(f.c[i]) * rival_a != Int(g.c[i]) * a) return false;
  }
  return true;
}

// Of a proof, what lasts: the inner face, and the radical plane of two front sheets in proportion.
void compare(const ActiveFace& f, const ActiveFace& g, DepthProof& proof) {
  const int bend = bend_of(f);
  const int rival = bend_of(g);
  if (bend == 2 || rival == 2) return;
  if (bend <= 0 && rival >= 0) {
    proof.inner = -1;
  } else if (bend >= 0 && rival <= 0) {
    proof.inner = 1;
  } else if (are_proportional(f, g)) {
    const Wide<256> k = middle_distance(f, g);
    proof.inner = k.negative() ? -1 : 1;
    if (bend < 0) proof.radical = k.negative() ? radical_plane(f, g, -k) : radical_plane(g, f, k);
  }
}

}  // namespace

DepthProof& prove_order(ActiveFace& f, const ActiveFace& g, std::int32_t y, std::int32_t x0, std::int32_t x1) {
  DepthProof* last = nullptr;
  for (DepthProof& proof : f.proofs) {
    if (proof.rival == g.order && proof.x0 <= proof.x1) last = &proof;
  }
  if (last == nullptr) {
    f.proofs[1] = f.proofs[0];
    last = f.proofs.data();
    *last = {};
    last->rival = g.order;
    compare(f, g, *last);
  }
  DepthProof& proof = *last;
  const bool changes = x0 <= proof.crossing && proof.crossing <= x1;
  const std::int32_t margin = (x1 - x0) / 4;
  proof.x0 = std::max({static_cast<std::int16_t>(x0 - margin - 4), f.block.x0, g.block.x0});
  proof.x1 = std::min({static_cast<std::int16_t>(x1 + margin + 4), f.block.x1, g.block.x1});
  proof.y0 = static_cast<std::int16_t>(y);
  proof.y1 = std::min({static_cast<std::int16_t>(y + std::max(margin, least_rows) - 1), f.block.y1, g.block.y1});
  proof.nearer = 0;
  proof.turn = 0;
  if (f.block.error < 0 || g.block.error < 0) return proof;
  if (!changes) {
    const bool is_parted = proof.radical.fraction != RadicalPlane::missing;
    proof.nearer = static_cast<std::int8_t>(is_parted ? proof.inner * nearer_by_plane(proof.inner < 0 ? f : g, proof)
                                                      : nearer_on(f, g, proof));
  }
  if (proof.nearer != 0 || proof.inner != 0 || x1 - x0 < 32) return proof;
  DepthProof near = proof;
  near.x0 = std::max(proof.x0, static_cast<std::int16_t>(x0 - column_margin));
  near.x1 = std::min(proof.x1, static_cast<std::int16_t>(x1 + column_margin));
  near.y1 = std::min(proof.y1, static_cast<std::int16_t>(y + column_rows - 1));
  prove_by_columns(f, g, near);
  if (near.nearer != 0 || near.turn != 0) {
    proof = near;
  } else {
    proof.y1 = near.y1;
  }
  return proof;
}

void make_depth(ActiveFace& face) {
  if (face.kind == FaceKind::rational) return;
  const int bits = face.c[2].bit_length();
  face.inverse =
      static_cast<std::uint32_t>((std::uint64_t{1} << 61) / static_cast<std::uint64_t>(scaled(face.c[2], bits - 31)));
  face.inverse_exponent = static_cast<std::int16_t>(bits + 30);
  if (face.kind == FaceKind::root) make_discriminant(face);
}

DepthBounds depth_over(const ActiveFace& face, std::int32_t y0, std::int32_t y1, std::int32_t a, std::int32_t b) {
  const DepthBlock& k = face.block;
  if (k.error < 0) return {k.low, k.high};
  const DepthRange z = depth_on(face, {a - k.x0, b - k.x0, y0 - k.y0, y1 - k.y0});
  return {static_cast<std::int32_t>(std::max<std::int64_t>(z.low, k.low)),
          static_cast<std::int32_t>(std::min<std::int64_t>(z.high, k.high))};
}

// A limb moves by less than a dot a line but near its ends, so a quarter of a width of dots at the sides lasts for as many lines. A face
// in two runs is asked for both on every line: a block that still holds the line is widened.
void make_block(ActiveFace& face, std::int32_t y, std::int32_t a, std::int32_t b) {
  DepthBlock& k = face.block;
  if (k.y0 <= y && y <= k.y1) {
    a = std::min<std::int32_t>(a, k.x0);
    b = std::max<std::int32_t>(b, k.x1);
  }
  const std::int32_t margin = (b - a) / 4;
  const std::int32_t rows = std::clamp(margin, 3 * strip_rows, most_rows);
  k.x0 = static_cast<std::int16_t>(std::max<std::int32_t>(a - margin - 4, 0));
  k.x1 = static_cast<std::int16_t>(std::min<std::int32_t>(b + margin + 4, largest_dot));
  k.y0 = static_cast<std::int16_t>(y);
  k.y1 = static_cast<std::int16_t>(std::min<std::int32_t>(y + rows - 1, largest_dot));
  Maker(face, k).make();
}

}  // namespace halfspace
