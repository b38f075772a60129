#include "host/scene/names.hpp"

#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

std::string describe(const SourcePosition& position) {
  return position.file + ":" + std::to_string(position.line) + ":" + std::to_string(position.column);
}

void check_body(const BodyStatement& body, const NameSpace& half_spaces, const std::string& place, DiagnosticLog& log) {
  for (const HalfSpaceReference& reference : body.half_spaces) {
    if (half_spaces.contains(reference.id)) continue;
    const std::string guess = did_you_mean(reference.id, half_spaces.all());
    log.error(reference.position, "there is no plane or quadric " + quote(reference.id) + " " + place +
                                      (guess.empty() ? "; define it there" : guess));
    if (log.full()) return;
  }
}

// Names what has no id and warns of it. `made` is the statement's word in the text.
template <typename Statement>
void name(Statement& statement, NameSpace& names, char prefix, std::string_view made, DiagnosticLog& log) {
  if (!statement.id.empty()) return;
  statement.id = names.invent(prefix);
  log.warning(statement.position, [&] { return "id " + statement.id + " created for this " + std::string(made); });
}

struct PlacementNamer {
  NameSpace& names;
  DiagnosticLog& log;
  void operator()(BodyStatement& body) const { name(body, names, 'b', "body", log); }
  void operator()(InstanceStatement& instance) const { name(instance, names, 'i', "instance", log); }
  void operator()(ArrayStatement& array) const { name(array, names, 'a', "array", log); }
};

void name_group(Group& group, GroupNames& names, DiagnosticLog& log) {
  for (PlaneStatement& plane : group.planes) name(plane, names.half_spaces, 'p', "plane", log);
  for (QuadricStatement& quadric : group.quadrics) name(quadric, names.half_spaces, 'q', "quadric", log);
  for (Placement& placement : group.placements) std::visit(PlacementNamer{names.placements, log}, placement);
}

}  // namespace

void NameSpace::declare(const std::string& id, const SourcePosition& position, std::string_view kind,
                        DiagnosticLog& log) {
  const auto [first, is_new] = declared_.try_emplace(id, position);
  if (is_new) return;
  log.error(position, "a " + std::string(kind) + " " + quote(id) + " is already defined at " + describe(first->second) +
                          "; choose another id");
}

std::vector<std::string_view> NameSpace::all() const {
  std::vector<std::string_view> ids;
  ids.reserve(declared_.size());
  for (const auto& [id, position] : declared_) ids.emplace_back(id);
  return ids;
}

std::string NameSpace::invent(char prefix) {
  int& number = last_invented_[prefix];
  std::string id;
  do {
    id = std::string(1, prefix) + "#" + std::to_string(++number);
  } while (contains(id));
  return id;
}

void check_half_space_references(SceneDraft& draft, DiagnosticLog& log) {
  for (std::size_t i = 0; i < draft.group_names.size(); ++i) {
    const std::string place = i == 0 ? "outside the definitions" : "in definition " + quote(draft.group(i).id);
    for (const Placement& placement : draft.group(i).placements) {
      if (log.full()) return;
      if (const auto* body = std::get_if<BodyStatement>(&placement)) {
        check_body(*body, draft.group_names[i].half_spaces, place, log);
      }
    }
  }
}

void invent_missing_ids(SceneDraft& draft, DiagnosticLog& log) {
  for (Group& definition : draft.scene.definitions) name(definition, draft.definitions, 'd', "definition", log);
  for (std::size_t i = 0; i < draft.group_names.size(); ++i) {
    name_group(draft.group(i), draft.group_names[i], log);
  }
  for (LightStatement& light : draft.scene.lights) name(light, draft.lights, 'l', "light", log);
  for (ViewStatement& view : draft.scene.views) name(view, draft.views, 'v', "view", log);
}

}  // namespace halfspace
