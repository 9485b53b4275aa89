#include "somato/simulation/explorer.h"

#include <fmt/format.h>

#include <utility>

#include "simulation/hand_explorers.h"
#include "simulation/probe_explorers.h"
#include "somato/core/check.h"
#include "somato/simulation/engine.h"

namespace somato {

const std::vector<std::pair<ExploringBody, std::string>>& Choices<ExploringBody>::all() {
  static const std::vector<std::pair<ExploringBody, std::string>> choices = {
      {ExploringBody::kLucs2, "lucs2"},     {ExploringBody::kLucs3, "lucs3"},
      {ExploringBody::kTexture, "texture"}, {ExploringBody::kHardness, "hardness"},
      {ExploringBody::kProbes, "probes"},   {ExploringBody::kAllSenses, "all_senses"}};
  return choices;
}

namespace {

Result<std::unique_ptr<detail::ThingExplorer>> thing_explorer(ExploringBody body,
                                                              const ObjectTable& things,
                                                              const ExploringParameters& parameters,
                                                              std::uint64_t seed) {
  switch (body) {
    case ExploringBody::kLucs2:
      return detail::grasping_explorer(things, parameters, seed);
    case ExploringBody::kLucs3:
      return detail::closing_explorer(things, parameters, seed);
    case ExploringBody::kTexture:
      return detail::probe_explorer(detail::Probe::kTexture, things, parameters, seed);
    case ExploringBody::kHardness:
      return detail::probe_explorer(detail::Probe::kHardness, things, parameters, seed);
    case ExploringBody::kProbes:
      return detail::probe_explorer(detail::Probe::kBoth, things, parameters, seed);
    case ExploringBody::kAllSenses:
      break;
  }
  return detail::all_senses_explorer(things, parameters, seed);
}

}  // namespace

class Explorer::Parts {
 public:
  std::vector<std::string> things;
  std::string source;  // What the explorations say that they come from.
  std::unique_ptr<const detail::ThingExplorer> explorer;
};

Result<ObjectTable> default_things(ExploringBody body) {
  const auto& materials = declared_materials();
  if (body == ExploringBody::kTexture || body == ExploringBody::kHardness ||
      body == ExploringBody::kProbes) {
    return ObjectTable{{}, materials};
  }
  return (body == ExploringBody::kLucs2 ? lucs2_objects(materials) : lucs3_objects(materials))
      .map([](std::vector<Object> objects) { return ObjectTable{std::move(objects), {}}; });
}

Result<Explorer> Explorer::build(ExploringBody body, const ObjectTable& things,
                                 const ExploringParameters& parameters, std::uint64_t seed) {
  auto explorer = thing_explorer(body, things, parameters, seed);
  if (!explorer) return fail(std::move(explorer.error()));
  auto parts = std::make_shared<Parts>();
  parts->things = (*explorer)->things();
  parts->source =
      fmt::format("{}, simulated ({}), seed {}", choice_name(body), physics_engine(), seed);
  parts->explorer = std::move(*explorer);
  return Explorer(std::move(parts));
}

const std::vector<std::string>& Explorer::things() const {
  return parts_->things;
}

Result<Exploration> Explorer::explore(std::size_t thing, std::size_t trial,
                                      const ExploreOptions& options) const {
  require(thing < parts_->things.size(), "Explorer::explore: no such thing");
  auto exploration = parts_->explorer->explore(thing, trial, options);
  if (exploration) {
    exploration->source = parts_->source;
  } else if (exploration.error().where.empty()) {
    exploration.error().where = parts_->things[thing];
  }
  return exploration;
}

}  // namespace somato
