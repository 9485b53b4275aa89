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

Json last_json(const GivenName* last) {
  if (last == nullptr) return {};
  return {
      {"exploration", last->exploration}, {"label", last->label.name}, {"name", last->label.value}};
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
          {"given", given ? Json(*given) : Json()},
          {"last", last_json(kept.names().last())}};
}

}  // namespace somato::live
