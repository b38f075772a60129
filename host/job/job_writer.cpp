#include "host/job/job_writer.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "firmware/core/memory_source.hpp"
#include "host/algebra/truncated.hpp"
#include "host/job/job_bytes.hpp"
#include "host/job/limits.hpp"
#include "host/job/plane_level.hpp"

namespace halfspace {
namespace {

constexpr std::int32_t largest_pool = 65534;

// Something that enters on a scan line and holds a slot until its last one.
struct Lifetime {
  std::int32_t y0 = 0, y1 = -1;
  std::uint32_t item = 0;
  std::uint32_t slot = 0;
};

// The items in the order of their scan lines, those of one line as they are.
template <class Item, class LineOf>
std::vector<Item> in_order_of_lines(const std::vector<Item>& items, LineOf line_of) {
  if (items.empty()) return {};
  const auto [first, last] = std::minmax_element(items.begin(), items.end(),
                                                 [&](const Item& a, const Item& b) { return line_of(a) < line_of(b); });
  const std::int32_t y0 = line_of(*first);
  std::vector<std::uint32_t> next(static_cast<std::size_t>(line_of(*last) - y0) + 2);  // where a line's items go
  for (const Item& item : items) ++next[static_cast<std::size_t>(line_of(item) - y0) + 1];
  std::partial_sum(next.begin(), next.end(), next.begin());
  std::vector<Item> sorted(items.size());
  for (const Item& item : items) sorted[next[static_cast<std::size_t>(line_of(item) - y0)]++] = item;
  return sorted;
}

// Slots that wait for their next use: a bit each.
class FreeSlots {
 public:
  void put(std::uint32_t slot) {
    const std::size_t word = slot / 64;
    if (word >= words_.size()) words_.resize(2 * word + 1);
    words_[word] |= std::uint64_t{1} << (slot % 64);
    first_ = std::min(first_, word);
  }
  std::optional<std::uint32_t> take_lowest() {
    while (first_ < words_.size() && words_[first_] == 0) ++first_;
    if (first_ == words_.size()) return std::nullopt;
    const int bit = std::countr_zero(words_[first_]);
    words_[first_] &= words_[first_] - 1;
    return static_cast<std::uint32_t>(64 * first_) + static_cast<std::uint32_t>(bit);
  }

 private:
  std::vector<std::uint64_t> words_;
  std::size_t first_ = 0;  // words before it are 0
};

// Assigns slots in order of entry, the lowest free one first; returns how many are needed.
std::int32_t assign_slots(std::vector<Lifetime>& lives) {
  lives = in_order_of_lines(lives, [](const Lifetime& life) { return life.y0; });
  std::vector<std::size_t> ends(lives.size());  // in order of the last lines
  std::iota(ends.begin(), ends.end(), std::size_t{0});
  ends = in_order_of_lines(ends, [&lives](std::size_t i) { return lives[i].y1; });
  FreeSlots free;
  std::uint32_t count = 0;
  std::size_t ended = 0;  // all of them have a slot, as what ends before a line has entered before it
  for (Lifetime& life : lives) {
    for (; lives[ends[ended]].y1 < life.y0; ++ended) free.put(lives[ends[ended]].slot);
    const auto slot = free.take_lowest();
    life.slot = slot ? *slot : count++;
  }
  return static_cast<std::int32_t>(count);
}

class JobWriter {
 public:
  JobWriter(const IntegerScene& scene, const ResolvedScene& resolved, const JobOptions& options)
      : scene_(scene), resolved_(resolved), options_(options) {}

  JobResult run() {
    check_faces();
    check_arcs();
    collect();
    const std::int32_t most =
        std::max({result_.header.needs.faces, result_.header.needs.arcs, result_.header.needs.cells});
    if (most > largest_pool) {
      limit({}, "a scan line crosses " + std::to_string(most) + " faces, arcs or cells; the limit is " +
                    std::to_string(largest_pool) + ": draw the scene smaller or in parts");
    }
    if (!result_.diagnostics.empty()) return std::move(result_);
    write_forms();
    make_header();
    result_.header.needs.spans = scene_.scissor.x1 - scene_.scissor.x0 + 1;  // spans of a line share no dot
    result_.bytes = bytes();
    if (options_.measure) {
      result_.header.needs.spans = measure();
      result_.bytes = bytes();
    }
    return std::move(result_);
  }

 private:
  enum class Kind : std::uint8_t { face, arc, window, cell, span };
  struct Event {
    std::int32_t y;
    Kind kind;
    std::uint32_t item;
    std::uint32_t slot;
    std::uint32_t window = 0;  // of the arc `item`
  };

  void limit(const SourcePosition& position, const std::string& text) {
    result_.diagnostics.push_back({Severity::limit, position, text});
  }

  void check_faces();
  void check_arcs();
  void collect();
  void make_header();
  std::int32_t measure() const;
  std::vector<std::uint8_t> bytes() const;
  void write_header(JobBytes& out) const;
  void write_face(std::uint32_t index);
  void write_arc(std::uint32_t index);
  void write_forms();
  [[nodiscard]] std::span<const std::uint8_t> face_form(std::uint32_t index) const;
  [[nodiscard]] std::span<const std::uint8_t> arc_form(std::uint32_t index) const;
  std::int64_t start_x(const Arc& arc) const;

  const IntegerScene& scene_;
  const ResolvedScene& resolved_;
  const JobOptions& options_;
  JobResult result_;
  std::vector<Event> events_;
  std::vector<std::uint32_t> face_slot_, arc_slot_;
  std::vector<std::int32_t> face_last_;
  std::vector<ArcKind> kinds_;
  // What of faces and arcs is the same wherever their records stand: written in their order, in which their integers lie in memory.
  JobBytes forms_;
  std::vector<Record> face_record_;
  std::vector<std::size_t> face_end_, arc_end_;
};

// Every face's forms, and any two depths, must fit the core's widths.
void JobWriter::check_faces() {
  FaceBits roots, all;
  int exact_bits = 0;
  SourcePosition widest;
  for (const Face& face : resolved_.faces) {
    const IntegerBody& body = scene_.bodies[face.body];
    const IntegerHalfSpace& half_space = body.half_spaces[face.half_space];
    const FaceBits above = face_bits_above(scene_, body, half_space);
    const auto too_wide = [](const mpz_class& c) { return bits_of(c) > 127; };
    const bool is_known = all.covers(above) && (above.q == 0 || roots.covers(above)) && !check_face(above) &&
                          level_bits(scene_, above) <= exact_bits;
    const FaceBits bits = is_known ? above : face_bits(scene_, body, half_space);
    std::optional<std::string> fault = check_face(bits);
    if (std::abs(body.origin[0]) > largest_origin || std::abs(body.origin[1]) > largest_origin) {
      fault = "its local frame lies more than " + std::to_string(largest_origin) + " dots off";
    }
    if (std::any_of(half_space.c.begin(), half_space.c.end(), too_wide))
      fault = "its coefficients need more than 127 bits";
    if (fault) {
      limit(half_space.position, "'" + half_space.name + "' in body '" + body.name + "' is too large or too far: " +
                                     *fault + "; move it nearer to the page or draw it smaller");
    }
    if (const int levels = level_bits(scene_, bits); levels > exact_bits) {
      exact_bits = levels;
      widest = half_space.position;
    }
    all.extend(bits);
    if (bits.q != 0) roots.extend(bits);
  }
  exact_bits = std::max(exact_bits, depth_bits(scene_, roots, all));
  if (exact_bits > exact_1152.bits) {
    limit(widest, "the scene needs exact arithmetic of " + std::to_string(exact_bits) + " bits, and the core has " +
                      std::to_string(exact_1152.bits) + ": bring its bodies nearer to one size, and to the page");
  }
  result_.header.needs.exact_bits = exact_bits;
}

// Every arc gets its kind.
void JobWriter::check_arcs() {
  kinds_.reserve(resolved_.arcs.size());
  for (const Arc& arc : resolved_.arcs) {
    const IntegerBody& body = scene_.bodies[arc.body];
    const std::optional<ArcKind> kind = arc_kind(scene_, arc);
    if (!kind) {
      const char* most = std::holds_alternative<Curve>(arc.form) ? "255" : "383";
      limit(body.position, "an edge of body '" + body.name + "' needs more than " + most +
                               " bits; draw it smaller or nearer to the page");
    }
    if (!separators_fit(arc)) {
      limit(body.position,
            "an edge of body '" + body.name + "' lies more than 2^31 dots off; bring it nearer to the page");
    }
    kinds_.push_back(kind.value_or(ArcKind::line64));
  }
}

// Lifetimes become slots, and all records one list in order of entry.
void JobWriter::collect() {
  std::vector<Lifetime> faces(resolved_.faces.size());
  for (std::uint32_t i = 0; i < faces.size(); ++i) faces[i] = {INT32_MAX, -1, i, 0};
  const auto extend = [&faces](std::uint32_t face, std::int32_t y0, std::int32_t y1) {
    faces[face].y0 = std::min(faces[face].y0, y0);
    faces[face].y1 = std::max(faces[face].y1, y1);
  };
  std::vector<Lifetime> arcs, cells;
  arcs.reserve(resolved_.arcs.size());
  cells.reserve(resolved_.cells.size() + resolved_.spans.size());
  for (std::uint32_t i = 0; i < resolved_.arcs.size(); ++i) {
    arcs.push_back({resolved_.arcs[i].y0, resolved_.arcs[i].y1, i, 0});
  }
  for (std::uint32_t i = 0; i < resolved_.cells.size(); ++i) {
    const Cell& cell = resolved_.cells[i];
    extend(cell.face, cell.y0, cell.y1);
    cells.push_back({cell.y0, cell.y1, i, 0});
  }
  const auto cell_count = static_cast<std::uint32_t>(cells.size());
  for (std::uint32_t i = 0; i < resolved_.spans.size(); ++i) {
    const LineSpan& span = resolved_.spans[i];
    extend(span.face, span.y, span.y);
    cells.push_back({span.y, span.y, cell_count + i, 0});
  }
  std::erase_if(faces, [](const Lifetime& life) { return life.y1 < life.y0; });
  events_.reserve(faces.size() + arcs.size() + cells.size());
  JobNeeds& needs = result_.header.needs;
  needs.faces = assign_slots(faces);
  needs.arcs = assign_slots(arcs);
  needs.cells = assign_slots(cells);
  face_slot_.resize(resolved_.faces.size());
  face_last_.resize(resolved_.faces.size());
  arc_slot_.resize(resolved_.arcs.size());
  for (const Lifetime& l : faces) {
    face_slot_[l.item] = l.slot;
    face_last_[l.item] = l.y1;
    events_.push_back({l.y0, Kind::face, l.item, l.slot});
  }
  for (const Lifetime& l : arcs) {
    arc_slot_[l.item] = l.slot;
    events_.push_back({l.y0, Kind::arc, l.item, l.slot});
    needs.arc_bytes = std::max(needs.arc_bytes, all_modules.arcs[static_cast<std::size_t>(kinds_[l.item])]->bytes);
  }
  for (const Lifetime& l : arcs) {
    const std::vector<Window>& windows = resolved_.arcs[l.item].guide.windows;
    for (std::uint32_t i = 1; i < windows.size(); ++i) {  // the first is in the arc's record
      events_.push_back({windows[i].y0, Kind::window, l.item, l.slot, i});
    }
  }
  for (const Lifetime& l : cells) {
    if (l.item < cell_count) events_.push_back({l.y0, Kind::cell, l.item, l.slot});
  }
  for (const Lifetime& l : cells) {
    if (l.item >= cell_count) events_.push_back({l.y0, Kind::span, l.item - cell_count, l.slot});
  }
  events_ = in_order_of_lines(events_, [](const Event& event) { return event.y; });  // on one line in that of the kinds
}

void JobWriter::make_header() {
  JobHeader& h = result_.header;
  h.page = options_.page;
  h.screen = options_.screen;
  h.x0 = scene_.scissor.x0;
  h.y0 = scene_.scissor.y0;
  h.x1 = scene_.scissor.x1;
  h.y1 = scene_.scissor.y1;
  h.bound = static_cast<std::uint32_t>(std::min(scene_.bound * 0x1p20 + 1, 4294967295.0));
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 4; ++j) {
      h.lighting.matrix[i][j] = static_cast<std::int32_t>(scene_.lighting.normal_matrix[i][j]);
    }
    h.lighting.light[i] = static_cast<std::int32_t>(scene_.lighting.light[i]);
  }
  h.lighting.ambient = static_cast<std::int32_t>(scene_.lighting.ambient);
  h.lighting.parallel = static_cast<std::int32_t>(scene_.lighting.parallel);
  h.lighting.unit = static_cast<std::int32_t>(scene_.lighting.unit);
}

class NoSink final : public BandSink {
 public:
  bool put_band(const Band&) override { return true; }
};

// The sweep in advance: the spans of the fullest scan line.
std::int32_t JobWriter::measure() const {
  const std::vector<std::uint8_t> job = bytes();
  MemorySource source(job);
  NoSink sink;
  std::vector<std::uint64_t> memory(memory_needed(result_.header, 1) / 8 + 1);
  const DrawResult drawn = draw(source, sink, std::as_writable_bytes(std::span(memory)),
                                {.shader = Shader::isqrt, .band_rows = 1, .measure = true}, all_modules);
  return drawn.status == DrawStatus::ok ? drawn.peak_spans : result_.header.needs.spans;
}

void JobWriter::write_header(JobBytes& out) const {
  const JobHeader& h = result_.header;
  for (const std::uint8_t b : job_magic) out.byte(b);
  out.number(h.page.width);
  out.number(h.page.height);
  out.number(h.page.format == DotFormat::bilevel ? 0 : 1);
  out.number(h.page.levels);
  out.number(h.page.background);
  out.number(static_cast<int>(h.screen));
  for (const std::int32_t edge : {h.x0, h.y0, h.x1, h.y1}) out.number(edge);
  out.unsigned_number(h.bound);
  for (const auto& row : h.lighting.matrix) {
    for (const std::int32_t m : row) out.number(m);
  }
  for (const std::int32_t l : h.lighting.light) out.number(l);
  for (const std::int32_t i : {h.lighting.unit, h.lighting.ambient, h.lighting.parallel}) out.number(i);
  const JobNeeds& n = h.needs;
  for (const std::int32_t need : {n.faces, n.arcs, n.cells, n.spans, n.arc_bytes, n.exact_bits}) out.number(need);
}

void JobWriter::write_face(std::uint32_t index) {
  const Face& face = resolved_.faces[index];
  const IntegerBody& body = scene_.bodies[face.body];
  const IntegerHalfSpace& h = body.half_spaces[face.half_space];
  const bool plane = h.kind == HalfSpaceKind::plane;
  face_record_.push_back(plane ? Record::plane_face : h.c[2] != 0 ? Record::root_face : Record::rational_face);
  JobBytes& out = forms_;
  out.unsigned_number(index);  // faces are listed in tie order
  for (const std::int64_t o : body.origin) out.number(o);
  // The core wants the z or z^2 coefficient positive; turning all signs turns the gradient too.
  const bool turn = h.c[2] < 0;
  if (plane) {
    out.byte(static_cast<std::uint8_t>(plane_level(scene_, body, h)));
  } else {
    const bool back = face.sheet == Sheet::back;
    const bool against = h.complement != turn;
    out.byte(static_cast<std::uint8_t>((back ? 1 : 0) | (against ? 2 : 0)));
    out.number(face_last_[index]);
  }
  for (int i = 0; i < (plane ? 4 : 10); ++i) {
    if (turn) {
      out.wide(-h.c[i]);
    } else {
      out.wide(h.c[i]);
    }
  }
}

// About where a conic or a line crosses scan line y, local: the core may begin anywhere, so doubles will do.
double root_near(const Curve& curve, Branch branch, std::int64_t line) {
  const auto y = static_cast<double>(line);
  std::array<double, 6> q;
  std::transform(curve.q.begin(), curve.q.end(), q.begin(), [](const mpz_class& c) { return truncated(c); });
  const double b = q[1] * y + q[3];
  const double c = (q[2] * y + q[4]) * y + q[5];
  if (branch == Branch::single) return b == 0 ? 0 : -c / b;
  const double root = std::sqrt(std::max(b * b - 4 * q[0] * c, 0.0));
  const double far = b < 0 ? root - b : -b - root;  // the root that suffers from no cancellation, times 2 q0 > 0
  if (far == 0) return 0;
  return (branch == Branch::left) == (far < 0) ? far / (2 * q[0]) : 2 * c / far;
}

// A dot of the window's first line, local: its middle, or beside its only separator.
double middle(const Window& window, std::int64_t otherwise) {
  const auto dot = [](const Separator& s) { return static_cast<double>(s.at >> separator_fraction); };
  if (window.left && window.right) return (dot(*window.left) + dot(*window.right)) / 2;
  return window.left ? dot(*window.left) : window.right ? dot(*window.right) : static_cast<double>(otherwise);
}

// Where the core begins to look for the arc on its first line: clamped to the scissor.
std::int64_t JobWriter::start_x(const Arc& arc) const {
  const auto& origin = scene_.bodies[arc.body].origin;
  const Scissor& s = scene_.scissor;
  const Curve* curve = std::get_if<Curve>(&arc.form);
  const double local = curve != nullptr ? root_near(*curve, arc.branch, arc.y0 - origin[1])
                                        : middle(arc.guide.windows.front(), (s.x0 + s.x1) / 2 - origin[0]);
  const double low = static_cast<double>(s.x0 - origin[0]);
  const double high = static_cast<double>(s.x1 + 1 - origin[0]);
  return static_cast<std::int64_t>(std::clamp(local, low, high)) + origin[0];
}

void write_separators(JobBytes& out, const Window& window) {
  out.number((window.left ? 1 : 0) | (window.right ? 2 : 0));
  for (const auto& separator : {window.left, window.right}) {
    if (!separator) continue;
    out.number(separator->at);
    out.number(separator->step);
  }
}

void write_form(JobBytes& out, const RadicalForm& form) {
  for (const mpz_class& c : form.p.q) out.wide(c);
  for (int i = 3; i < 6; ++i) out.wide(form.r.q[i]);
  for (const mpz_class& c : form.d.q) out.wide(c);
}

void write_form(JobBytes& out, const QuarticForm& form) {
  for (const mpz_class& c : form.q) out.wide(c);
}

void JobWriter::write_arc(std::uint32_t index) {
  const Arc& arc = resolved_.arcs[index];
  JobBytes& out = forms_;
  out.number(static_cast<int>(kinds_[index]));
  out.number(scene_.bodies[arc.body].origin[0]);
  out.number(scene_.bodies[arc.body].origin[1]);
  out.number(arc.y1);
  out.number(start_x(arc));
  if (const auto* curve = std::get_if<Curve>(&arc.form)) {
    const bool line = is_line(*curve);
    if (!line) out.number(static_cast<int>(arc.branch));
    for (int i = line ? 3 : 0; i < 6; ++i) out.wide(curve->q[i]);
    return;
  }
  out.number((arc.guide.rising ? 1 : 0) | (arc.guide.missing_right ? 2 : 0));
  write_separators(out, arc.guide.windows.front());
  if (const auto* radical = std::get_if<RadicalForm>(&arc.form)) write_form(out, *radical);
  if (const auto* quartic = std::get_if<QuarticForm>(&arc.form)) write_form(out, *quartic);
}

void JobWriter::write_forms() {
  face_end_.resize(resolved_.faces.size());
  arc_end_.resize(resolved_.arcs.size());
  face_record_.reserve(face_end_.size());
  forms_.reserve(48 * (face_end_.size() + arc_end_.size()));
  for (std::uint32_t i = 0; i < face_end_.size(); ++i) {
    write_face(i);
    face_end_[i] = forms_.size();
  }
  for (std::uint32_t i = 0; i < arc_end_.size(); ++i) {
    write_arc(i);
    arc_end_[i] = forms_.size();
  }
}

std::span<const std::uint8_t> JobWriter::face_form(std::uint32_t index) const {
  return forms_.between(index == 0 ? 0 : face_end_[index - 1], face_end_[index]);
}

std::span<const std::uint8_t> JobWriter::arc_form(std::uint32_t index) const {
  const std::size_t first = face_end_.empty() ? 0 : face_end_.back();
  return forms_.between(index == 0 ? first : arc_end_[index - 1], arc_end_[index]);
}

std::vector<std::uint8_t> JobWriter::bytes() const {
  JobBytes out;
  out.reserve(512 + forms_.size() + 16 * events_.size());
  write_header(out);
  std::int32_t y = 0;
  const auto arc_number = [this](std::uint32_t arc) {
    return arc == no_arc ? std::int64_t{-1} : static_cast<std::int64_t>(arc_slot_[arc]);
  };
  for (const Event& event : events_) {
    const auto delta = static_cast<std::uint64_t>(event.y - y);
    y = event.y;
    const auto start = [&](Record type) {
      out.byte(static_cast<std::uint8_t>(type));
      out.number(static_cast<std::int64_t>(delta));
      out.number(event.slot);
    };
    switch (event.kind) {
      case Kind::face:
        start(face_record_[event.item]);
        out.append(face_form(event.item));
        break;
      case Kind::arc:
        start(Record::arc);
        out.append(arc_form(event.item));
        break;
      case Kind::window:
        start(Record::window);
        write_separators(out, resolved_.arcs[event.item].guide.windows[event.window]);
        break;
      case Kind::cell: {
        const Cell& cell = resolved_.cells[event.item];
        start(Record::cell);
        out.number(face_slot_[cell.face]);
        out.number(arc_number(cell.left));
        out.number(arc_number(cell.right));
        out.number(cell.y1);
        break;
      }
      case Kind::span: {
        const LineSpan& span = resolved_.spans[event.item];
        start(Record::span);
        out.number(face_slot_[span.face]);
        out.number(span.x0);
        out.number(span.x1);
        break;
      }
    }
  }
  out.byte(static_cast<std::uint8_t>(Record::end));
  return out.take();
}

}  // namespace

JobResult write_job(const IntegerScene& scene, const ResolvedScene& resolved, const JobOptions& options) {
  return JobWriter(scene, resolved, options).run();
}

}  // namespace halfspace
