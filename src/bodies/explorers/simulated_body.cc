#include "bodies/explorers/simulated_body.h"

#include <utility>

#include "bodies/explorers/explorer_setup.h"
#include "bodies/probes/hardness_probe.h"
#include "bodies/probes/texture_probe.h"
#include "somato/core/random.h"
#include "somato/simulation/simulated_hand.h"

namespace somato {
namespace {

using detail::Draws;
using detail::ExplorerSetup;

tl::unexpected<Error> no_such_thing() {
  return fail(ErrorKind::kUsage, "the table has no such object or material", {},
              "choose one of the table");
}

Result<std::unique_ptr<Body>> placed_hand(Hand hand, const Object& object,
                                          const ExplorerSetup& setup, std::size_t thing,
                                          std::size_t trial) {
  SOMATO_TRY(const auto scene, HandScene::build(hand, object, setup.parameters.simulation));
  SOMATO_TRY(auto placed,
             SimulatedHand::create(scene, setup.placement_of(thing, trial),
                                   setup.seed_of(thing, trial, Draws::kHand), setup.seed));
  return std::unique_ptr<Body>(std::move(placed));
}

Result<std::unique_ptr<Body>> placed_probe(ExploringBody body, const Material& material,
                                           const ExplorerSetup& setup, std::size_t thing,
                                           std::size_t trial) {
  if (body == ExploringBody::kTexture) {
    return make_texture_probe(material, setup.parameters.texture_probe,
                              {setup.seed, setup.seed_of(thing, trial, Draws::kTexture)});
  }
  return make_hardness_probe(material, setup.parameters.hardness_probe,
                             setup.seed_of(thing, trial, Draws::kHardness));
}

}  // namespace

Result<std::unique_ptr<Body>> simulated_body(ExploringBody body, const ObjectTable& things,
                                             const ExploringParameters& parameters,
                                             std::uint64_t seed, std::size_t thing,
                                             std::size_t trial) {
  const ExplorerSetup setup{parameters, seed, {}, nullptr};
  switch (body) {
    case ExploringBody::kLucs2:
    case ExploringBody::kLucs3: {
      if (thing >= things.objects.size()) return no_such_thing();
      const Hand hand = body == ExploringBody::kLucs2 ? Hand::kLucs2 : Hand::kLucs3;
      return placed_hand(hand, things.objects[thing], setup, thing, trial);
    }
    case ExploringBody::kTexture:
    case ExploringBody::kHardness:
      if (thing >= things.materials.size()) return no_such_thing();
      return placed_probe(body, things.materials[thing], setup, thing, trial);
    case ExploringBody::kProbes:
    case ExploringBody::kAllSenses:
      break;
  }
  return fail(ErrorKind::kUsage, "these are several bodies", choice_name(body),
              "use lucs2, lucs3, texture or hardness");
}

}  // namespace somato
