#include "host/scene/definition_graph.hpp"

#include <algorithm>

#include "host/scene/quote.hpp"

namespace halfspace {
namespace {

// Groups are numbered as in SceneDraft::group; 0, outside any definition, is drawn by nobody.
struct Edge {
  std::size_t drawn;
  const DefinitionUse* use;
};
using Graph = std::vector<std::vector<Edge>>;

enum class Visit : std::uint8_t { unseen, open, done };

struct Step {
  std::size_t group;
  std::size_t next_edge;
};

class CycleSearch {
 public:
  CycleSearch(const Scene& scene, const Graph& graph, DiagnosticLog& log)
      : scene_(scene), graph_(graph), log_(log), visits_(graph.size()), heights_(graph.size(), 0) {}

  // Depth first, with a path of its own in place of recursion.
  void from(std::size_t group) {
    if (visits_[group] != Visit::unseen) return;
    enter(group);
    while (!path_.empty() && !log_.full()) {
      Step& step = path_.back();
      if (step.next_edge == graph_[step.group].size()) {
        leave();
      } else {
        follow(graph_[step.group][step.next_edge++]);
      }
    }
  }

 private:
  static constexpr int most_named = 8;  // of a cycle, in its message

  void enter(std::size_t group) {
    visits_[group] = Visit::open;
    path_.push_back({group, 0});
  }

  void follow(const Edge& edge) {
    if (visits_[edge.drawn] == Visit::open) report_cycle(edge);
    if (visits_[edge.drawn] == Visit::done) raise(path_.back().group, edge.drawn, *edge.use);
    if (visits_[edge.drawn] == Visit::unseen) enter(edge.drawn);
  }

  void leave() {
    const std::size_t group = path_.back().group;
    visits_[group] = Visit::done;
    path_.pop_back();
    if (path_.empty()) return;
    const Step& user = path_.back();
    raise(user.group, group, *graph_[user.group][user.next_edge - 1].use);
  }

  // A group is one higher than the highest that it draws; the limit is reported where it is first exceeded.
  void raise(std::size_t group, std::size_t drawn, const DefinitionUse& use) {
    const int height = std::min(heights_[drawn] + 1, deepest_nesting + 1);
    if (height <= heights_[group]) return;
    heights_[group] = height;
    if (height <= deepest_nesting || too_deep_) return;
    too_deep_ = true;
    log_.limit(use.position, "definitions are nested more than " + std::to_string(deepest_nesting) + " deep below " +
                                 quote(use.definition) + "; draw some of them side by side");
  }

  void report_cycle(const Edge& back) {
    const auto starts_cycle = [&](const Step& step) { return step.group == back.drawn; };
    const auto first = std::find_if(path_.begin(), path_.end(), starts_cycle);
    std::string message = "definition " + quote(id(back.drawn)) + " contains itself: ";
    int named = 0;
    for (auto step = first; step != path_.end() && named < most_named; ++step, ++named) {
      message += quote(id(step->group));
      message += " draws ";
    }
    if (path_.end() - first > most_named) message += "... draws ";
    message += quote(id(back.drawn));
    log_.error(back.use->position, message + "; remove one of these instances");
  }

  [[nodiscard]] const std::string& id(std::size_t group) const { return scene_.definitions[group - 1].id; }

  const Scene& scene_;
  const Graph& graph_;
  DiagnosticLog& log_;
  std::vector<Visit> visits_;
  std::vector<int> heights_;
  std::vector<Step> path_;
  bool too_deep_ = false;
};

using DefinitionIndex = std::unordered_map<std::string_view, std::size_t>;

DefinitionIndex index_definitions(const Scene& scene) {
  DefinitionIndex index;
  for (std::size_t i = 0; i < scene.definitions.size(); ++i) index.try_emplace(scene.definitions[i].id, i + 1);
  return index;
}

Graph connect(const SceneDraft& draft, DiagnosticLog& log) {
  Graph graph(draft.scene.definitions.size() + 1);
  const DefinitionIndex index = index_definitions(draft.scene);
  for (const DefinitionUse& use : draft.uses) {
    if (log.full()) break;
    const auto found = index.find(use.definition);
    if (found != index.end()) {
      graph[use.group].push_back({found->second, &use});
    } else {
      const std::string guess = did_you_mean(use.definition, draft.definitions.all());
      log.error(use.position, "there is no definition " + quote(use.definition) +
                                  (guess.empty() ? "; write one, from 'definition' to 'enddef;'" : guess));
    }
  }
  return graph;
}

}  // namespace

void check_definition_uses(const SceneDraft& draft, DiagnosticLog& log) {
  const Graph graph = connect(draft, log);
  CycleSearch search(draft.scene, graph, log);
  for (std::size_t group = 0; group < graph.size(); ++group) search.from(group);
}

}  // namespace halfspace
