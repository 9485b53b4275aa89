#include "views/live/naming_state.h"

namespace somato::live {
namespace {

Json names_json(const NameCounts& counts, const std::string& label) {
  Json names = Json::array();
  for (const NameCount& one : counts.of(label)) {
    names.push_back({{"name", one.name}, {"explorations", one.explorations}});
  }
  return names;
}

Json next_json(const NameCounts& counts, const std::string& label) {
  const auto next = counts.next(label);
  if (!next) return {};
  return {{"name", next->name}, {"number", next->explorations}};
}

Json last_json(const KeptExplorations& kept) {
  const GivenName* last = kept.names().last();
  if (last == nullptr) return {};
  return {{"exploration", last->exploration},
          {"id", kept.id(last->exploration)},
          {"label", last->label.name},
          {"name", last->label.value}};
}

// Only of what is kept, and can be named.
Json id_json(const KeptExplorations& kept, const PlayedExploration* played) {
  if (played == nullptr || played->index < kept.first()) return {};
  return kept.id(played->index);
}

}  // namespace

Json naming_json(const KeptExplorations& kept, const PlayedExploration* played,
                 const std::string& predicted) {
  const std::string label = predicted.empty() ? "object" : predicted;
  const NameCounts& counts = kept.counts();
  const auto given = played != nullptr ? kept.names().given(played->index, label) : std::nullopt;
  return {{"names", names_json(counts, label)},
          {"each", counts.each() > 0 ? Json(counts.each()) : Json()},
          {"next", next_json(counts, label)},
          {"id", id_json(kept, played)},
          {"given", given ? Json(*given) : Json()},
          {"last", last_json(kept)}};
}

}  // namespace somato::live
