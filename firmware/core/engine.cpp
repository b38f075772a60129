#include "firmware/core/engine.hpp"

#include <algorithm>

#include "firmware/core/active_list.hpp"
#include "firmware/core/curtain.hpp"
#include "firmware/core/depth_block.hpp"
#include "firmware/core/exact.hpp"
#include "firmware/core/job_reader.hpp"
#include "firmware/core/root_surface.hpp"
#include "firmware/core/row_painter.hpp"
#include "firmware/core/shade.hpp"
#include "firmware/core/span_list.hpp"

namespace halfspace {
namespace {

struct ArcSlot {
  std::int16_t last = -1;     // scan line
  std::uint8_t kind = 0;      // ArcKind
  std::int8_t rests_at = -1;  // the line of the strip where it stands while it rests; -1: it is awake
};

struct CellSlot {
  std::uint16_t face = 0;
  std::uint16_t left = no_slot, right = no_slot;  // arcs; both no_slot with `fixed`: x0 and x1 stand
  std::int16_t last = -1;                         // scan line
  std::int16_t x0 = 0, x1 = -1;  // dots on the current line; at rest: all that it may have on the strip
  bool fixed : 1 = false;
  bool rational : 1 = false;  // its face: some dots may have no depth
  bool bounded : 1 = false;   // for what is left of a strip: x0 and x1 are, and its face's block
  bool rests : 1 = false;
};

// Carves pools out of the caller's memory, each aligned to 8 bytes. With no memory it only counts.
class Arena {
 public:
  explicit Arena(std::span<std::byte> memory) : memory_(memory) {}

  template <class T>
  std::span<T> take(std::size_t count) {
    const std::size_t at = used_;
    used_ += (count * sizeof(T) + 7) / 8 * 8;
    if (used_ > memory_.size()) return {};
    T* first = reinterpret_cast<T*>(memory_.data() + at);
    for (std::size_t i = 0; i < count; ++i) first[i] = T{};  // implicit-lifetime types only
    return {first, count};
  }
  [[nodiscard]] std::size_t used() const { return used_; }
  [[nodiscard]] std::size_t left() const { return memory_.size() - used_; }

 private:
  std::span<std::byte> memory_;
  std::size_t used_ = 0;
};

struct Pools {
  std::span<ActiveFace> faces;
  std::span<ArcSlot> arcs;
  std::span<ArcCrossing> crossings;  // stale while an arc rests
  std::span<std::byte> arc_states;
  std::span<std::uint16_t> active_arcs, active_cells;
  std::span<CellSlot> cells;
  std::span<Span> spans;
  std::span<std::int32_t> columns;  // of the curtain
  std::span<std::uint32_t> squares;
  std::span<PatternRow> patterns;
  std::span<std::uint32_t> edges;
  std::span<std::uint32_t> row;
  std::span<std::uint8_t> band;
  std::span<std::int32_t> scratch;   // of contours: a word a level
  std::span<FaceContours> contours;  // of the first faces
  std::span<std::uint32_t> blocks;   // of contours, of the first of those
};

std::int32_t state_bytes(const JobHeader& h) { return (h.needs.arc_bytes + 7) / 8 * 8; }

Pools carve(Arena& arena, const JobHeader& h, std::int32_t band_rows) {
  const auto size = [](std::int32_t n) { return static_cast<std::size_t>(n); };
  const bool bilevel = h.page.format == DotFormat::bilevel;
  Pools p;
  p.faces = arena.take<ActiveFace>(size(h.needs.faces));
  p.arcs = arena.take<ArcSlot>(size(h.needs.arcs));
  p.crossings = arena.take<ArcCrossing>(size(h.needs.arcs));
  p.arc_states = arena.take<std::byte>(size(h.needs.arcs) * size(state_bytes(h)));
  p.active_arcs = arena.take<std::uint16_t>(size(h.needs.arcs));
  p.active_cells = arena.take<std::uint16_t>(size(h.needs.cells));
  p.cells = arena.take<CellSlot>(size(h.needs.cells));
  p.spans = arena.take<Span>(size(h.needs.spans));
  p.columns = arena.take<std::int32_t>(Curtain::columns_of(h.page.width));
  p.squares = arena.take<std::uint32_t>(size(h.page.levels));
  p.patterns = arena.take<PatternRow>(bilevel ? size(h.page.levels) * cell_side : 0);
  p.edges = arena.take<std::uint32_t>(bilevel ? edge_words(h.page.levels) * cell_side : 0);
  p.row = arena.take<std::uint32_t>(row_words(h.page));
  p.band = arena.take<std::uint8_t>(h.page.row_bytes() * size(band_rows));
  return p;
}

// Faces on one line whose contours are kept, at most: on a page of many small ones that does not pay.
constexpr std::size_t most_blocks = 64;

// From what memory is left: for as many faces as fit.
void carve_contours(Arena& arena, const JobHeader& h, Pools& p) {
  const auto levels = static_cast<std::size_t>(h.page.levels);
  if (arena.left() < levels * sizeof(std::int32_t) + 8) return;
  p.scratch = arena.take<std::int32_t>(levels);
  p.contours = arena.take<FaceContours>(std::min(p.faces.size(), arena.left() / sizeof(FaceContours)));
  const std::size_t words = contour_block_words(h.page.levels);
  p.blocks = arena.take<std::uint32_t>(words * std::min({p.contours.size(), most_blocks, arena.left() / (4 * words)}));
}

// Lines of a strip that a cell may rest on, at least: to find out costs about as much as three of them.
constexpr std::int32_t least_rest = 4;
// Cells of a line that a curtain is worth.
constexpr std::int32_t least_cells = 16;

class Engine {
 public:
  Engine(const JobHeader& header, const Pools& pools, JobReader& in, BandSink& sink, const DrawOptions& options,
         const Modules& modules, const ExactModule& exact, std::int32_t band_rows, DrawResult& result)
      : h_(header),
        p_(pools),
        in_(in),
        sink_(sink),
        options_(options),
        modules_(modules),
        exact_(exact),
        band_rows_(band_rows),
        arc_bytes_(static_cast<std::size_t>(state_bytes(header))),
        result_(result),
        spans_(pools.spans, pools.faces, exact, result.counters),
        curtain_(pools.columns),
        arcs_(pools.active_arcs),
        cells_(pools.active_cells),
        painter_(header.page, pools.row, pools.patterns, pools.edges),
        levels_(make_levels(header.lighting, header.page.levels, pools.squares)),
        wants_contours_(modules.contours != nullptr &&
                        (options.shader == Shader::contour || options.shader == Shader::automatic)) {}

  void run() {
    next_record();
    for (std::int32_t y = 0; y < h_.page.height && result_.status == DrawStatus::ok; ++y) {
      result_.line = y;
      painter_.begin(y);
      advance(y);
      const std::size_t arcs = arcs_.awake().size();
      const std::size_t cells = cells_.awake().size();
      read_records(y);
      if (result_.status == DrawStatus::ok && y - strip_ == strip_rows) {
        begin_strip(y);
      } else if (result_.status == DrawStatus::ok && is_hung_) {
        rest_hidden(y, cells, arcs);
      }
      if (result_.status == DrawStatus::ok) sweep(y);
      if (result_.status == DrawStatus::ok && !options_.measure) put_row(y);
    }
    if (result_.status == DrawStatus::ok && type_ != Record::end) result_.status = DrawStatus::bad_record;
  }

 private:
  void fail(DrawStatus status) {
    if (result_.status == DrawStatus::ok) result_.status = status;
  }

  // --- records ---

  void next_record() {
    const std::uint8_t type = in_.byte();
    type_ = static_cast<Record>(type);
    if (type > static_cast<std::uint8_t>(Record::window)) fail(DrawStatus::bad_record);
    if (type_ != Record::end) enter_ += in_.number_in(0, h_.page.height);
    if (in_.failed()) fail(DrawStatus::bad_record);
  }

  std::uint16_t slot(std::size_t count) {
    return static_cast<std::uint16_t>(in_.number_in(0, static_cast<std::int32_t>(count) - 1));
  }
  std::uint16_t arc_or_none() {
    const std::int32_t number = in_.number_in(-1, static_cast<std::int32_t>(p_.arcs.size()) - 1);
    return number < 0 ? no_slot : static_cast<std::uint16_t>(number);
  }
  std::int16_t last_line(std::int32_t y) { return static_cast<std::int16_t>(in_.number_in(y, h_.page.height - 1)); }

  void read_records(std::int32_t y) {
    while (result_.status == DrawStatus::ok && type_ != Record::end && enter_ <= y) {
      switch (type_) {
        case Record::arc:
          read_arc(y);
          break;
        case Record::cell:
          read_cell(y);
          break;
        case Record::span:
          read_span(y);
          break;
        case Record::window:
          read_window(y);
          break;
        default: {
          const std::uint16_t face = slot(p_.faces.size());
          if (!in_.failed()) enter_face(face);
        }
      }
      if (in_.failed()) {
        fail(DrawStatus::bad_record);
      } else {
        next_record();
      }
    }
  }

  // Null for a plane, which has nothing to compute, and for a kind that this firmware leaves out.
  [[nodiscard]] const FaceModule* module_of(FaceKind kind) const {
    if (kind == FaceKind::plane) return nullptr;
    return kind == FaceKind::root ? modules_.root : modules_.rational;
  }

  void enter_face(std::uint16_t number) {
    ActiveFace& face = p_.faces[number];
    read_face(in_, type_, face);
    if (!has_depth(face)) return fail(DrawStatus::bad_record);
    make_depth(face);
    if (face.kind == FaceKind::plane) return;
    if (module_of(face.kind) == nullptr) return fail(DrawStatus::missing_module);
    ++result_.counters.curved_faces;
    if (number < p_.contours.size()) {
      const std::size_t words = contour_block_words(h_.page.levels);
      p_.contours[number] = {};
      if ((number + 1) * words <= p_.blocks.size())
        p_.contours[number].block = p_.blocks.subspan(number * words, words);
    } else if (wants_contours_) {
      ++result_.counters.crowded_faces;
    }
  }

  void read_arc(std::int32_t y) {
    const std::uint16_t number = slot(p_.arcs.size());
    const std::int32_t kind = in_.number_in(0, arc_kinds - 1);
    ArcStart start;
    start.origin_x = in_.number_in(-largest_origin, largest_origin);
    start.origin_y = in_.number_in(-largest_origin, largest_origin);
    const std::int16_t last = last_line(y);
    start.x_min = h_.x0;
    start.x_max = h_.x1;
    start.x = in_.number_in(h_.x0, h_.x1 + 1);
    start.y = y;
    start.y_last = last;
    if (in_.failed() || p_.arcs[number].last >= y) return fail(DrawStatus::bad_record);
    const ArcModule* module = modules_.arcs[static_cast<std::size_t>(kind)];
    if (module == nullptr || module->bytes > h_.needs.arc_bytes) return fail(DrawStatus::missing_module);
    module->load(in_, start, state(number));
    if (in_.failed()) return;
    if (p_.arcs[number].rests_at < 0 || !arcs_.wake(number)) arcs_.add(number);
    p_.arcs[number] = {last, static_cast<std::uint8_t>(kind)};
    settle(number);
  }

  void read_window(std::int32_t y) {
    const std::uint16_t number = slot(p_.arcs.size());
    if (in_.failed()) return;
    if (p_.arcs[number].last < y || arc_module(number).enter_window == nullptr) return fail(DrawStatus::bad_record);
    arc_module(number).enter_window(in_, state(number));
    if (!in_.failed()) settle(number);
  }

  void read_cell(std::int32_t y) {
    CellSlot cell;
    const std::uint16_t number = slot(p_.cells.size());
    cell.face = slot(p_.faces.size());
    cell.left = arc_or_none();
    cell.right = arc_or_none();
    cell.last = last_line(y);
    activate(number, cell, y);
    for (const std::uint16_t arc : {cell.left, cell.right}) wake_arc(arc, y);
  }

  void read_span(std::int32_t y) {
    CellSlot cell;
    const std::uint16_t number = slot(p_.cells.size());
    cell.face = slot(p_.faces.size());
    cell.x0 = static_cast<std::int16_t>(in_.number_in(h_.x0, h_.x1));
    cell.x1 = static_cast<std::int16_t>(in_.number_in(cell.x0, h_.x1));
    cell.last = static_cast<std::int16_t>(y);
    cell.fixed = true;
    activate(number, cell, y);
  }

  void activate(std::uint16_t number, const CellSlot& cell, std::int32_t y) {
    if (in_.failed() || p_.cells[number].last >= y || !has_depth(p_.faces[cell.face])) {
      return fail(DrawStatus::bad_record);
    }
    if (!p_.cells[number].rests || !cells_.wake(number)) cells_.add(number);
    p_.cells[number] = cell;
    p_.cells[number].rational = p_.faces[cell.face].kind == FaceKind::rational;
  }

  // Of an arc that a record filled.
  [[nodiscard]] const ArcModule& arc_module(std::uint16_t arc) const { return *modules_.arcs[p_.arcs[arc].kind]; }
  [[nodiscard]] void* state(std::uint16_t arc) const { return p_.arc_states.data() + arc * arc_bytes_; }
  void settle(std::uint16_t arc) { p_.crossings[arc] = arc_module(arc).settle(state(arc)); }

  // --- the sweep ---

  // Brings the arcs to scan line y; arcs and cells whose last line has passed leave. Where a strip begins all wake.
  void advance(std::int32_t y) {
    if (y - strip_ == strip_rows) wake_all(y);
    cells_.remove([&](std::uint16_t number) { return p_.cells[number].last < y; });
    arcs_.remove([&](std::uint16_t number) {
      if (p_.arcs[number].last < y) return true;
      p_.crossings[number] = arc_module(number).next(state(number));
      return false;
    });
  }

  // --- strips ---

  // Brings an arc that rests to line y of the strip.
  void jump(std::uint16_t number, std::int32_t y) {
    ArcSlot& arc = p_.arcs[number];
    arc_module(number).jump_down(state(number), y - strip_ - arc.rests_at);
    arc.rests_at = -1;
  }

  // To the line before y, the strip's last one, if they last beyond it.
  void wake_all(std::int32_t y) {
    for (const std::uint16_t number : arcs_.resting()) {
      if (p_.arcs[number].last >= y) jump(number, y - 1);
    }
    for (const std::uint16_t number : cells_.resting()) p_.cells[number].rests = false;
    arcs_.wake_all();
    cells_.wake_all();
  }

  // Of a cell that has just entered.
  void wake_arc(std::uint16_t number, std::int32_t y) {
    if (number == no_slot || p_.arcs[number].rests_at < 0) return;
    jump(number, y);
    settle(number);
    arcs_.wake(number);
  }

  // Where half of many cells and more showed nothing on the last line, a curtain is drawn with the cells that last all the strip.
  void begin_strip(std::int32_t y) {
    strip_ = y;
    is_hung_ = static_cast<std::int32_t>(cells_.size()) > std::max(2 * spans_.used(), least_cells);
    if (!is_hung_) return;
    curtain_.open();
    rest_hidden(y, 0, 0);
  }

  // Of the awake, from these places on: cells that the curtain hides on all that is left of the strip rest, and arcs that no other cell asks
  // for. Where the strip begins they hang the curtain first.
  void rest_hidden(std::int32_t y, std::size_t first_cell, std::size_t first_arc) {
    for (const std::uint16_t number : cells_.awake().subspan(first_cell)) {
      p_.cells[number].bounded = bound_on_strip(p_.cells[number], y);
    }
    for (const std::uint16_t number : arcs_.awake().subspan(first_arc)) {
      ArcSlot& arc = p_.arcs[number];
      if (arc_module(number).ahead != nullptr) arc.rests_at = static_cast<std::int8_t>(y - strip_);
    }
    cells_.rest(first_cell, [&](std::uint16_t number) {
      CellSlot& cell = p_.cells[number];
      cell.rests = cell.bounded && hides(cell, y);
      if (cell.rests) return true;
      for (const std::uint16_t arc : {cell.left, cell.right}) {
        if (arc != no_slot) p_.arcs[arc].rests_at = -1;
      }
      return false;
    });
    arcs_.rest(first_arc, [&](std::uint16_t number) { return p_.arcs[number].rests_at >= 0; });
  }

  [[nodiscard]] bool hides(const CellSlot& cell, std::int32_t y) const {
    const ActiveFace& face = p_.faces[cell.face];
    const std::int32_t last = std::min<std::int32_t>(cell.last, strip_ + strip_end);
    return curtain_.hides(cell.x0, cell.x1, face.block.low,
                          [&](std::int32_t a, std::int32_t b) { return depth_over(face, y, last, a, b).low; });
  }

  // Finds the dots between which a cell stays on what is left of the strip, and hangs its part of the curtain if that is all of it. False:
  // that is too short to be worth it, or it may be anywhere.
  bool bound_on_strip(CellSlot& cell, std::int32_t y) {
    const std::int32_t end = strip_ + strip_end;
    const std::int32_t lines = std::min<std::int32_t>(cell.last, end) - y;
    if (cell.fixed || cell.rational || lines < least_rest) return false;
    if (!is_seen_ahead(cell.left, y + lines) || !is_seen_ahead(cell.right, y + lines)) return false;
    const CrossingRange left = cell.left == no_slot ? CrossingRange{h_.x0, h_.x0} : range_of(cell.left, lines);
    const CrossingRange right =
        cell.right == no_slot ? CrossingRange{h_.x1 + 1, h_.x1 + 1} : range_of(cell.right, lines);
    cell.x0 = static_cast<std::int16_t>(std::max(left.low, h_.x0));
    cell.x1 = static_cast<std::int16_t>(std::min(right.high, h_.x1));
    if (cell.x0 > cell.x1) return false;
    ActiveFace& face = p_.faces[cell.face];
    const DepthBlock& block = bounded_strip(face, y, cell.x0, cell.x1);
    if (lines == strip_end) {
      curtain_.cover(left.high, right.low - 1, block.low,
                     [&](std::int32_t a, std::int32_t b) { return depth_over(face, y, end, a, b).high; });
    }
    return true;
  }

  [[nodiscard]] bool is_seen_ahead(std::uint16_t arc, std::int32_t y) const {
    return arc == no_slot || (p_.arcs[arc].last >= y && arc_module(arc).ahead != nullptr);
  }

  // On so many lines to come.
  [[nodiscard]] CrossingRange range_of(std::uint16_t number, std::int32_t lines) {
    const auto [middle, end, last] = arc_module(number).ahead(state(number), lines);
    const CrossingRange range = crossing_range(p_.crossings[number].at_or_right, middle, end, h_.x0, h_.x1);
    return {std::min<std::int32_t>(range.low, last), std::max<std::int32_t>(range.high, last)};
  }

  // The dots of a cell on the current line: closed between its arcs.
  void place(CellSlot& cell, std::int32_t y) {
    if (!cell.fixed) {
      cell.x0 = cell.left == no_slot ? static_cast<std::int16_t>(h_.x0) : p_.crossings[cell.left].at_or_right;
      cell.x1 = static_cast<std::int16_t>(cell.right == no_slot ? h_.x1 : p_.crossings[cell.right].right - 1);
    }
    if (!cell.rational) return;
    const ActiveFace& face = p_.faces[cell.face];
    while (cell.x0 <= cell.x1 && is_absent(face, cell.x0, y)) ++cell.x0;
    while (cell.x0 <= cell.x1 && is_absent(face, cell.x1, y)) --cell.x1;
  }

  // Places every cell awake and sorts the list in ascending order of first dots: nearly in order from the line before, but where a strip
  // begins [Shell 1959].
  void sort_cells(std::int32_t y) {
    const std::span<std::uint16_t> list = cells_.awake();
    for (const std::uint16_t number : list) place(p_.cells[number], y);
    if (y == strip_) {
      for (const std::size_t gap : {132U, 57U, 23U, 10U, 4U}) sort_cells(list, gap);
    }
    sort_cells(list, 1);
  }

  void sort_cells(std::span<std::uint16_t> list, std::size_t gap) {
    const CellSlot* const cells = p_.cells.data();
    for (std::size_t i = gap; i < list.size(); ++i) {
      const std::uint16_t number = list[i];
      const std::int16_t x0 = cells[number].x0;
      std::size_t j = i;
      for (; j >= gap && cells[list[j - gap]].x0 > x0; j -= gap) {
        list[j] = list[j - gap];
        ++result_.counters.edge_swaps;
      }
      list[j] = number;
    }
  }

  void sweep(std::int32_t y) {
    ++result_.counters.lines;
    sort_cells(y);
    spans_.clear(y);
    for (const std::uint16_t number : cells_.awake()) {
      const CellSlot& cell = p_.cells[number];
      if (cell.x0 > cell.x1) continue;
      if (!spans_.insert(cell.face, cell.x0, cell.x1)) {
        result_.have = static_cast<std::int64_t>(p_.spans.size());
        result_.need = result_.have + 1;
        return fail(DrawStatus::too_many_spans);
      }
    }
    result_.peak_spans = std::max(result_.peak_spans, spans_.used());
    if (!options_.measure) shade(y);
  }

  void shade_curved(const Span& span, std::int32_t y) {
    ActiveFace& face = p_.faces[span.face];
    const FaceModule& module = *module_of(face.kind);
    if (!face.ready) module.enter(face, h_.lighting);
    face.ready = true;
    ShadeJob job{face, h_.lighting, levels_, exact_, painter_, result_.counters, options_.stride, nullptr, p_.scratch};
    if (span.face < p_.contours.size() && wants_contours_) {
      job.contours = &p_.contours[span.face];
    }
    if (job.contours == nullptr) return module.shade(job, options_.shader, y, span.x0, span.x1);
    const std::uint32_t spans = result_.counters.level_spans;
    const std::uint32_t steps = result_.counters.level_steps;
    const bool done = modules_.contours->shade(job, options_.shader, y, span.x0, span.x1);
    if (!done) module.shade(job, options_.shader, y, span.x0, span.x1);
    if (span.x1 == span.x0) return;
    job.contours->gaps = static_cast<std::uint32_t>(span.x1 - span.x0);
    job.contours->steps = done ? result_.counters.level_spans - spans - 1 : result_.counters.level_steps - steps;
  }

  void shade(std::int32_t y) {
    Counters& counters = result_.counters;
    for (std::uint16_t i = spans_.first(); i != no_slot; i = spans_.at(i).next) {
      const Span& span = spans_.at(i);
      const ActiveFace& face = p_.faces[span.face];
      ++counters.spans;
      counters.dots += static_cast<std::uint32_t>(span.x1 - span.x0 + 1);
      if (face.kind == FaceKind::plane) {
        ++counters.level_spans;
        painter_.fill(span.x0, span.x1, std::min<std::int32_t>(face.level, h_.page.levels - 1));
      } else {
        shade_curved(span, y);
      }
    }
  }

  // --- bands ---

  void put_row(std::int32_t y) {
    const std::size_t bytes = h_.page.row_bytes();
    const std::int32_t row = y % band_rows_;
    painter_.copy_to(p_.band.subspan(static_cast<std::size_t>(row) * bytes, bytes));
    if (row != band_rows_ - 1 && y != h_.page.height - 1) return;
    const Band band{y - row, row + 1, p_.band.first(static_cast<std::size_t>(row + 1) * bytes)};
    if (!sink_.put_band(band)) fail(DrawStatus::stopped);
  }

  const JobHeader& h_;
  const Pools& p_;
  JobReader& in_;
  BandSink& sink_;
  const DrawOptions& options_;
  const Modules& modules_;
  const ExactModule& exact_;
  std::int32_t band_rows_;
  std::size_t arc_bytes_;
  DrawResult& result_;
  SpanList spans_;
  Curtain curtain_;
  std::int32_t strip_ = -strip_rows;  // the line where the current strip began
  bool is_hung_ = false;              // a curtain on it
  ActiveList arcs_, cells_;
  RowPainter painter_;
  LevelTable levels_;
  bool wants_contours_;
  Record type_ = Record::end;
  std::int32_t enter_ = 0;
};

// The preferred band height, halved until the job fits.
std::int32_t choose_band_rows(const JobHeader& header, std::int32_t preferred, std::size_t have) {
  std::int32_t rows = std::clamp<std::int32_t>(preferred, 1, header.page.height);
  while (rows > 1 && memory_needed(header, rows) > have) rows /= 2;
  return rows;
}

// The narrowest module that holds `bits`; none: nullptr.
const ExactModule* choose_exact(const Modules& modules, std::int32_t bits) {
  for (const ExactModule* module : modules.exact) {
    if (module != nullptr && module->bits >= bits) return module;
  }
  return nullptr;
}

}  // namespace

std::size_t memory_needed(const JobHeader& header, std::int32_t band_rows) {
  Arena counting({});
  (void)carve(counting, header, band_rows);
  return counting.used();
}

std::size_t memory_wanted(const JobHeader& header, std::int32_t band_rows) {
  Arena counting({});
  (void)counting.take<std::int32_t>(static_cast<std::size_t>(header.page.levels));
  const auto faces = static_cast<std::size_t>(header.needs.faces);
  (void)counting.take<FaceContours>(faces);
  (void)counting.take<std::uint32_t>(contour_block_words(header.page.levels) * std::min(faces, most_blocks));
  return memory_needed(header, band_rows) + counting.used();
}

DrawResult draw(JobReader& in, const JobHeader& header, BandSink& sink, std::span<std::byte> memory,
                const DrawOptions& options, const Modules& modules) {
  DrawResult result;
  const ExactModule* exact = choose_exact(modules, header.needs.exact_bits);
  if (exact == nullptr) {
    result.status = DrawStatus::missing_module;
    return result;
  }
  result.band_rows = choose_band_rows(header, options.band_rows, memory.size());
  result.need = static_cast<std::int64_t>(memory_needed(header, result.band_rows));
  result.have = static_cast<std::int64_t>(memory.size());
  if (result.need > result.have) {
    result.status = DrawStatus::does_not_fit;
    return result;
  }
  Arena arena(memory);
  Pools pools = carve(arena, header, result.band_rows);
  carve_contours(arena, header, pools);
  if (header.page.format == DotFormat::bilevel) {
    make_patterns(header.screen, header.page.levels, pools.patterns);
    find_edges(header.page.levels, pools.patterns, pools.edges);
  }
  Engine(header, pools, in, sink, options, modules, *exact, result.band_rows, result).run();
  return result;
}

DrawResult draw(ByteSource& job, BandSink& sink, std::span<std::byte> memory, const DrawOptions& options,
                const Modules& modules) {
  JobReader in(job);
  JobHeader header;
  if (!read_header(in, header)) {
    DrawResult result;
    result.status = DrawStatus::not_a_job;
    return result;
  }
  return draw(in, header, sink, memory, options, modules);
}

}  // namespace halfspace
