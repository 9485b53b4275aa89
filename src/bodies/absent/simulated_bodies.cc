// The functions of simulated bodies in a program that is built without them
// (SOMATO_BUILD_SIMULATION=OFF): what would simulate says that it cannot.

#include "somato/simulation/simulated_explorer.h"

#include <vector>

#include "bodies/explorers/recorded_scenes.h"
#include "bodies/explorers/simulated_body.h"
#include "bodies/sensors/sensor_parameters.h"
#include "bodies/sensors/stocked_exploration.h"
#include "somato/simulation/sense.h"

namespace somato {
namespace {

tl::unexpected<Error> no_simulation() {
  return fail(ErrorKind::kUsage, "this program was built without simulated bodies", {},
              "use a device, topics or a recording, or a program that is built with "
              "SOMATO_BUILD_SIMULATION=ON");
}

}  // namespace

std::string physics_engine() {
  return "no physics engine";
}

Result<std::unique_ptr<SimulatedExplorer>> simulated_explorer(ExploringBody /*body*/,
                                                              const ObjectTable& /*things*/,
                                                              const ExploringParameters& /*all*/,
                                                              std::uint64_t /*seed*/,
                                                              GraspPictures* /*pictures*/) {
  return no_simulation();
}

Result<std::unique_ptr<Body>> simulated_body(ExploringBody /*body*/, const ObjectTable& /*things*/,
                                             const ExploringParameters& /*parameters*/,
                                             std::uint64_t /*seed*/, std::size_t /*thing*/,
                                             std::size_t /*trial*/) {
  return no_simulation();
}

// No scene is found. NOLINTNEXTLINE(performance-unnecessary-value-param): the declared signature
SceneFinder recorded_scenes(std::vector<Object> /*own*/) {
  return {};
}

const std::vector<ParameterInfo>& sensor_parameters() {
  static const std::vector<ParameterInfo> none;
  return none;
}

Result<Exploration> as_thing(const Exploration& /*explored*/, const Object& /*object*/,
                             std::size_t /*thing*/) {
  return no_simulation();
}

Result<Recording> sense(const Recording& /*explored*/, const ExploringParameters& /*parameters*/,
                        std::optional<std::uint64_t> /*seed*/, std::size_t /*threads*/) {
  return no_simulation();
}

}  // namespace somato
