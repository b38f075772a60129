// names.hpp - the ids of a scene, each kind in its name space, and the scene while it is being read.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "host/scene/diagnostic_log.hpp"
#include "host/scene/scene.hpp"

namespace halfspace {

// One name space: the ids declared in it and where.
class NameSpace {
 public:
  // Reports a second declaration, naming the first's position.
  void declare(const std::string& id, const SourcePosition& position, std::string_view kind, DiagnosticLog& log);
  [[nodiscard]] bool contains(const std::string& id) const { return declared_.count(id) != 0; }
  [[nodiscard]] std::vector<std::string_view> all() const;

  // The next of prefix#1, prefix#2, ... that is not declared; none is given twice.
  std::string invent(char prefix);

 private:
  std::unordered_map<std::string, SourcePosition> declared_;
  std::unordered_map<char, int> last_invented_;
};

struct GroupNames {
  NameSpace half_spaces;  // planes and quadrics
  NameSpace placements;   // bodies, instances and arrays
};

// An instance or array in `group` names a definition.
struct DefinitionUse {
  std::size_t group = 0;  // as in SceneDraft::group
  std::string definition;
  SourcePosition position;
};

// A scene whose references are not yet checked and whose missing ids are still empty.
// A statement with an error is left out of `scene`, but its id is declared, so that its uses are no errors.
struct SceneDraft {
  Scene scene;
  std::vector<GroupNames> group_names = std::vector<GroupNames>(1);  // as in group()
  NameSpace definitions, lights, views;
  std::vector<DefinitionUse> uses;
  bool complete = true;  // false: some text was lost, so a missing id proves nothing

  // 0: outside any definition; k: the k-th definition.
  Group& group(std::size_t index) { return index == 0 ? scene.top : scene.definitions[index - 1]; }
};

// Every half-space that a body names must be one of its own group.
void check_half_space_references(SceneDraft& draft, DiagnosticLog& log);

// Gives each statement without an id one of its own (l#1 for a light), with a warning.
void invent_missing_ids(SceneDraft& draft, DiagnosticLog& log);

}  // namespace halfspace
