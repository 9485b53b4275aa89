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
