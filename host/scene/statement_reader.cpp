#include "host/scene/statement_reader.hpp"

#include <algorithm>
#include <charconv>
#include <utility>

#include "host/scene/keywords.hpp"
#include "host/scene/quote.hpp"
#include "host/scene/token_stream.hpp"
#include "host/scene/transform_reader.hpp"
#include "host/scene/view_reader.hpp"

namespace halfspace {
namespace {

constexpr std::uint64_t most_copies = 1'000'000;

bool all_zero(const Number* first, std::size_t count) {
  return std::all_of(first, first + count, [](const Number& n) { return n.value == 0; });
}

// Each read_ function takes a statement up to its ';'; false after an error that leaves its rest unread.
class StatementReader {
 public:
  StatementReader(const std::string& file, std::string_view text, SceneDraft& draft, DiagnosticLog& log)
      : tokens_(file, text, log), draft_(draft), log_(log) {}

  void read_all() {
    while (!tokens_.at(TokenKind::end) && !log_.full()) {
      if (tokens_.at_symbol(';')) {
        tokens_.take();
      } else if (read_one()) {
        tokens_.end_statement();
      } else {
        tokens_.skip_statement();
      }
    }
    if (tokens_.truncated()) draft_.complete = false;
    if (group_ != 0 && !tokens_.truncated() && !log_.full()) report_open_definition();
  }

 private:
  bool read_one() {
    const std::string_view word = tokens_.at(TokenKind::word) ? tokens_.current().text : "";
    const std::optional<Statement> statement = find_statement(word);
    if (!statement) {
      const std::vector<std::string_view> words = statement_words();
      return tokens_.fail_expected("a statement (" + list(words) + ")", did_you_mean(word, words));
    }
    position_ = tokens_.position();
    errors_before_ = log_.errors();
    tokens_.take();
    switch (*statement) {
      case Statement::plane:
        return read_plane();
      case Statement::quadric:
        return read_quadric();
      case Statement::body:
        return read_body();
      case Statement::definition:
        return read_definition();
      case Statement::enddef:
        return read_enddef();
      case Statement::instance:
        return read_instance();
      case Statement::array:
        return read_array();
      case Statement::light:
        return read_light();
      case Statement::view:
        return read_view();
    }
    return false;
  }

  // --- pieces ---

  [[nodiscard]] bool is_good() const { return log_.errors() == errors_before_; }
  Group& group() { return draft_.group(group_); }
  GroupNames& names() { return draft_.group_names[group_]; }

  bool read_new_id(NameSpace& name_space, std::string_view kind, std::string& id) {
    const SourcePosition position = tokens_.position();
    if (!tokens_.take_optional_id(id)) return false;
    if (!id.empty()) name_space.declare(id, position, kind, log_);
    return true;
  }

  template <std::size_t count>
  bool read_coefficients(std::string_view owner, std::string_view letters, std::array<Number, count>& coefficients) {
    const char closing = tokens_.take_opening();
    std::vector<Number> numbers;
    if (closing == 0 || !tokens_.take_numbers(count, owner, letters, numbers)) return false;
    std::move(numbers.begin(), numbers.end(), coefficients.begin());
    return tokens_.take_closing(closing, "");
  }

  // The paper's "=0" is opaque; its prose suggests the letter, so "=o" and "=O" are read as well.
  bool read_opacity(bool& transparent) {
    for (; tokens_.at(TokenKind::option); tokens_.take()) {
      const std::string_view option = tokens_.current().text;
      transparent = option == "=t";
      if (!transparent && option != "=0" && option != "=o" && option != "=O") {
        return tokens_.fail_expected("'=t' (transparent) or '=0' (opaque)");
      }
    }
    return true;
  }

  // --- half-spaces and bodies ---

  template <typename HalfSpace>
  bool read_half_space(HalfSpace& half_space, std::string_view owner, std::string_view letters) {
    half_space.position = position_;
    return read_new_id(names().half_spaces, "plane or quadric", half_space.id) &&
           read_coefficients(owner, letters, half_space.coefficients) && read_opacity(half_space.transparent);
  }

  bool read_plane() {
    PlaneStatement plane;
    if (!read_half_space(plane, "a plane", "A B C D")) return false;
    if (is_good() && all_zero(plane.coefficients.data(), 3)) {
      log_.error(position_, "this plane has no direction; one of A B C must not be 0");
    }
    if (is_good()) group().planes.push_back(std::move(plane));
    return true;
  }

  bool read_quadric() {
    QuadricStatement quadric;
    if (!read_half_space(quadric, "a quadric", "A B C D E F G H J K")) return false;
    if (is_good() && all_zero(quadric.coefficients.data(), 9)) {
      log_.error(position_, "this quadric has no surface; one of A B C D E F G H J must not be 0");
    }
    if (is_good()) group().quadrics.push_back(std::move(quadric));
    return true;
  }

  bool read_body() {
    BodyStatement body;
    body.position = position_;
    if (!read_new_id(names().placements, "body, instance or array", body.id)) return false;
    const char closing = tokens_.take_opening();
    if (closing == 0) return false;
    while (tokens_.at_symbol('!') || (tokens_.at(TokenKind::word) && !tokens_.at_next_statement())) {
      if (!read_half_space_reference(body)) return false;
    }
    if (!tokens_.take_closing(closing, "the id of a plane or quadric, '!' or ")) return false;
    if (body.half_spaces.empty() && is_good()) {
      log_.error(position_, "this body has no half-space; name at least one plane or quadric in its list");
    }
    if (is_good()) group().placements.emplace_back(std::move(body));
    return true;
  }

  bool read_half_space_reference(BodyStatement& body) {
    HalfSpaceReference reference;
    reference.complement = tokens_.at_symbol('!');
    if (reference.complement) tokens_.take();
    reference.position = tokens_.position();
    if (!tokens_.take_id("the id of a plane or quadric after '!'", reference.id)) return false;
    body.half_spaces.push_back(std::move(reference));
    return true;
  }

  // --- definitions, instances, arrays ---

  bool read_definition() {
    if (group_ != 0) {
      log_.error(position_, "a definition cannot stand in another; end " + name_of_open_definition() +
                                " with 'enddef;' before this line");
      is_enddef_due_ = true;
    }
    draft_.scene.definitions.push_back({{}, {}, {}, {}, position_});
    draft_.group_names.emplace_back();
    group_ = draft_.scene.definitions.size();
    return read_new_id(draft_.definitions, "definition", group().id);
  }

  bool read_enddef() {
    if (group_ == 0 && !std::exchange(is_enddef_due_, false)) {
      log_.error(position_, "there is no definition to end here; remove this 'enddef;'");
    }
    group_ = 0;
    return true;
  }

  [[nodiscard]] std::string name_of_open_definition() {
    const std::string line = " (line " + std::to_string(group().position.line) + ")";
    return (group().id.empty() ? std::string("the one") : quote(group().id)) + line;
  }

  void report_open_definition() {
    log_.error(group().position,
               "this definition is still open at the end of the file; write 'enddef;' after its last statement");
  }

  // "(definition transforms)"
  bool read_placed_definition(std::string& definition, std::vector<Transform>& transforms) {
    const char closing = tokens_.take_opening();
    if (closing == 0) return false;
    const SourcePosition position = tokens_.position();
    if (!tokens_.take_id("the id of a definition", definition)) return false;
    draft_.uses.push_back({group_, definition, position});
    return read_transforms(tokens_, log_, transforms) && tokens_.take_closing(closing, "a transform or ");
  }

  bool read_instance() {
    InstanceStatement instance;
    instance.position = position_;
    if (!read_new_id(names().placements, "body, instance or array", instance.id)) return false;
    if (!read_placed_definition(instance.definition, instance.transforms)) return false;
    if (is_good()) group().placements.emplace_back(std::move(instance));
    return true;
  }

  bool read_array() {
    ArrayStatement array;
    array.position = position_;
    if (!read_new_id(names().placements, "body, instance or array", array.id)) return false;
    if (!read_placed_definition(array.definition, array.initial)) return false;
    if (!tokens_.at_number()) return tokens_.fail_expected("the number of copies");
    array.count = take_count();
    if (!read_transforms(tokens_, log_, array.delta)) return false;
    if (is_good()) group().placements.emplace_back(std::move(array));
    return true;
  }

  // 0 after an error.
  std::uint32_t take_count() {
    const SourcePosition position = tokens_.position();
    const std::string_view text = tokens_.take().text;
    const char* end = text.data() + text.size();
    std::uint64_t count = 0;
    const auto [rest, status] = std::from_chars(text.data(), end, count);
    const bool is_whole = rest == end && status != std::errc::invalid_argument;
    if (is_whole && (status == std::errc::result_out_of_range || count > most_copies)) {
      log_.limit(position, quote(text) + " copies are too many; an array has at most " + std::to_string(most_copies));
    } else if (!is_whole || count == 0) {
      log_.error(position, quote(text) + " is not a number of copies; write a whole number from 1 to " +
                               std::to_string(most_copies));
    } else {
      return static_cast<std::uint32_t>(count);
    }
    return 0;
  }

  // --- lights and views ---

  // Such a statement is still read: its own errors are of interest too.
  void refuse_in_definition(std::string_view kind) {
    if (group_ == 0) return;
    log_.error(position_, "a " + std::string(kind) + " cannot stand in a definition; move it behind the 'enddef;' of " +
                              name_of_open_definition());
  }

  bool read_light() {
    refuse_in_definition("light");
    LightStatement light;
    light.position = position_;
    if (!tokens_.at_number() && !read_new_id(draft_.lights, "light", light.id)) return false;
    if (!tokens_.at_number()) return tokens_.fail_expected("the intensity of the light");
    const SourcePosition intensity_position = tokens_.position();
    light.intensity = tokens_.take_number();
    if (tokens_.at_number() && !read_direction(light)) return false;
    if (is_good()) warn_of_intensity(light.intensity, intensity_position);
    if (is_good()) draft_.scene.lights.push_back(std::move(light));
    return true;
  }

  bool read_direction(LightStatement& light) {
    const SourcePosition position = tokens_.position();
    std::vector<Number> numbers;
    if (!tokens_.take_numbers(3, "the direction to a parallel light", "x y z", numbers)) return false;
    if (is_good() && all_zero(numbers.data(), 3)) {
      log_.error(position, "the direction to this light is the zero vector; one of x y z must not be 0");
    }
    std::move(numbers.begin(), numbers.end(), light.direction.emplace().begin());
    return true;
  }

  void warn_of_intensity(const Number& intensity, const SourcePosition& position) {
    if (intensity.value >= 0 && intensity.value <= 1) return;
    log_.warning(position, "intensity " + intensity.text + " is outside 0 to 1; it counts as " +
                               (intensity.value < 0 ? "0" : "1"));
  }

  bool read_view() {
    refuse_in_definition("view");
    ViewStatement view;
    view.position = position_;
    const bool has_id = tokens_.at(TokenKind::word) && find_view_key(tokens_.current().text) == nullptr;
    if (has_id && !read_new_id(draft_.views, "view", view.id)) return false;
    if (!read_view_parameters(tokens_, log_, view.parameters)) return false;
    if (is_good()) draft_.scene.views.push_back(std::move(view));
    return true;
  }

  TokenStream tokens_;
  SceneDraft& draft_;
  DiagnosticLog& log_;
  std::size_t group_ = 0;       // where statements go: SceneDraft::group
  bool is_enddef_due_ = false;  // after a nested definition: the enddef of its outer one is not a second error
  SourcePosition position_;     // of the statement's first word
  int errors_before_ = 0;       // before the statement
};

}  // namespace

void read_statements(const std::string& file, std::string_view text, SceneDraft& draft, DiagnosticLog& log) {
  StatementReader(file, text, draft, log).read_all();
}

}  // namespace halfspace
