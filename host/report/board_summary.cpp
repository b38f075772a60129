#include "host/report/board_summary.hpp"

#include <algorithm>
#include <map>
#include <span>

#include "host/report/markdown.hpp"

namespace halfspace {
namespace {

using Span = std::span<const BoardRow>;

// The rows of one page, which stand together.
Span first_page(Span rows) {
  const BoardRow& first = rows.front();
  std::size_t count = 0;
  while (count < rows.size() && rows[count].face == first.face && rows[count].view == first.view &&
         rows[count].radius == first.radius && rows[count].levels == first.levels) {
    ++count;
  }
  return rows.first(count);
}

Cells shaders_of(Span rows) {
  Cells names;
  for (const BoardRow& row : rows) {
    if (std::find(names.begin(), names.end(), row.shader) == names.end()) names.push_back(row.shader);
  }
  return names;
}

std::string cost(const BoardRow& row) {
  std::string text = fmt::format("{} / {}", figure(row.face_instructions), figure(row.draw_instructions));
  if (row.error.wrong == 0) return text;
  return text +
         fmt::format(" ({:.2g} %)", 100.0 * static_cast<double>(row.error.wrong) / static_cast<double>(row.dots));
}

// One line a page, one column a shader.
template <class LineHead>
std::string table(Span rows, const Cells& head, LineHead line_head) {
  const Cells names = shaders_of(rows);
  Cells titles = head;
  titles.insert(titles.end(), names.begin(), names.end());
  std::string text = table_head(titles);
  while (!rows.empty()) {
    const Span page = first_page(rows);
    std::map<std::string, std::string> costs;
    for (const BoardRow& row : page) costs[row.shader] = cost(row);
    Cells line = line_head(page.front());
    for (const std::string& name : names) line.push_back(costs.contains(name) ? costs[name] : "-");
    text += table_line(line);
    rows = rows.subspan(page.size());
  }
  return text;
}

// The kinds of face come first, all on pages of one size.
std::size_t count_kinds(Span rows) {
  std::size_t count = 0;
  while (count < rows.size() && rows[count].radius == rows[0].radius && rows[count].levels == rows[0].levels) ++count;
  return count;
}

const BoardRow* row_by(Span page, const std::string& shader) {
  const auto at = std::find_if(page.begin(), page.end(), [&](const BoardRow& row) { return row.shader == shader; });
  return at == page.end() ? nullptr : &*at;
}

// What `auto` takes by the lesser of what `contour` and `isqrt` take.
std::string choice(Span rows) {
  int pages = 0, good = 0;
  double worst = 0;
  std::string where;
  for (; !rows.empty(); rows = rows.subspan(first_page(rows).size())) {
    const Span page = first_page(rows);
    const BoardRow *chosen = row_by(page, "auto"), *contour = row_by(page, "contour"), *dots = row_by(page, "isqrt");
    if (chosen == nullptr || contour == nullptr || dots == nullptr) continue;
    const double ratio = chosen->face_instructions / std::min(contour->face_instructions, dots->face_instructions);
    ++pages;
    if (ratio <= 1.1) ++good;
    if (ratio <= worst) continue;
    worst = ratio;
    where = fmt::format("{}, radius {}, {} levels", chosen->face, chosen->radius, chosen->levels);
  }
  if (pages == 0) return "";
  return fmt::format(
      "\n`auto` takes at most a tenth more than the better of `contour` and `isqrt` on {} of {} pages; at worst {:.2f} "
      "times as much ({}).\n",
      good, pages, worst, where);
}

}  // namespace

std::string as_csv(const std::vector<BoardRow>& rows) {
  std::string text =
      "face,view,radius,levels,shader,shaded_dots,face_instructions_per_dot,draw_instructions_per_dot,wrong_dots,"
      "level_error_mean,level_error_max\n";
  for (const BoardRow& row : rows) {
    text += fmt::format("\"{}\",{},{},{},{},{},{:.5g},{:.5g},{},{:.4g},{:g}\n", row.face, row.view, row.radius,
                        row.levels, row.shader, row.dots, row.face_instructions, row.draw_instructions, row.error.wrong,
                        row.error.level_mean, row.error.level_max);
  }
  return text;
}

std::string board_summary(const std::vector<BoardRow>& rows) {
  if (rows.empty()) return "";
  const std::size_t kinds = count_kinds(rows);
  const Span all(rows);
  return fmt::format(
             "\n## Cortex-M3\n\nInstructions a shaded dot on the emulated board (`boards/mps2-an385`): of the face "
             "(set-up and "
             "spans, filling included) / of the\nwhole drawing net of an empty page; in brackets the share of wrong "
             "dots, "
             "where there are any. Every page has the bytes of the host's.\nA2 and A4 are the best exact loops over "
             "dots: any "
             "quadric by a root at every dot, a sphere by additions alone.\n\nRadius {} dots, {} levels:\n\n",
             rows[0].radius, rows[0].levels) +
         table(all.first(kinds), {"face", "view", "aim, at most"},
               [](const BoardRow& row) {
                 return Cells{row.face, row.view, figure(row.aim)};
               }) +
         "\nOther sizes:\n\n" +
         table(all.subspan(kinds), {"face", "radius", "levels"},
               [](const BoardRow& row) {
                 return Cells{row.face, std::to_string(row.radius), std::to_string(row.levels)};
               }) +
         choice(all);
}

}  // namespace halfspace
