#include "somato/simulation/simulated_explorer.h"

#include <mujoco/mujoco.h>

#include <utility>

#include "bodies/explorers/hand_explorers.h"
#include "bodies/explorers/probe_explorers.h"
#include "bodies/objects/built_in_things.h"
#include "bodies/objects/exploration_source.h"

namespace somato {

std::string physics_engine() {
  return std::string("MuJoCo ") + mj_versionString();
}

const std::vector<std::pair<ExploringBody, std::string>>& Choices<ExploringBody>::all() {
  static const std::vector<std::pair<ExploringBody, std::string>> choices = {
      {ExploringBody::kLucs2, "lucs2"},     {ExploringBody::kLucs3, "lucs3"},
      {ExploringBody::kTexture, "texture"}, {ExploringBody::kHardness, "hardness"},
      {ExploringBody::kProbes, "probes"},   {ExploringBody::kAllSenses, "all_senses"}};
  return choices;
}

bool is_probe(ExploringBody body) {
  return body == ExploringBody::kTexture || body == ExploringBody::kHardness ||
         body == ExploringBody::kProbes;
}

Result<ObjectTable> default_things(ExploringBody body) {
  const auto& materials = declared_materials();
  if (is_probe(body)) return ObjectTable{{}, materials};
  return (body == ExploringBody::kLucs2 ? lucs2_objects(materials) : lucs3_objects(materials))
      .map([](std::vector<Object> objects) { return ObjectTable{std::move(objects), {}}; });
}

Result<void> check_effect(ExploringBody body, const Table& given) {
  for (const Table::Entry& entry : given.entries) {
    if (entry.name == "true_values") continue;
    if (is_probe(body) || (entry.name == "taxels" && body == ExploringBody::kLucs2)) {
      return fail(ErrorKind::kUsage, "has no effect on the body " + choice_name(body), entry.where,
                  "omit it");
    }
  }
  return {};
}

Result<std::unique_ptr<SimulatedExplorer>> simulated_explorer(ExploringBody body,
                                                              const ObjectTable& things,
                                                              const ExploringParameters& parameters,
                                                              std::uint64_t seed,
                                                              GraspPictures* pictures) {
  const std::string source =
      simulated_source(choice_name(body), physics_engine(), seed,
                       are_built_in(things) ? SimulatedThings::kBuiltIn : SimulatedThings::kGiven);
  detail::ExplorerSetup setup{parameters, seed, source, pictures};
  switch (body) {
    case ExploringBody::kLucs2:
      return detail::hand_explorer(Hand::kLucs2, things, std::move(setup));
    case ExploringBody::kLucs3:
      return detail::hand_explorer(Hand::kLucs3, things, std::move(setup));
    case ExploringBody::kTexture:
      return detail::probe_explorer(detail::Probe::kTexture, things, std::move(setup));
    case ExploringBody::kHardness:
      return detail::probe_explorer(detail::Probe::kHardness, things, std::move(setup));
    case ExploringBody::kProbes:
      return detail::probe_explorer(detail::Probe::kBoth, things, std::move(setup));
    case ExploringBody::kAllSenses:
      break;
  }
  return detail::all_senses_explorer(things, std::move(setup));
}

}  // namespace somato
