#include "view/view_preparation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "explore/exploring_body.h"

namespace somato::program {
namespace {

// Another seed than that of the view, so that the system was not trained on what is shown.
constexpr std::uint64_t kPriorSeed = 2;

// How a body begins. The system is trained within some seconds of processor time. An exploration by
// Hand II takes half a minute of its time.
struct Beginning {
  std::string_view body;
  std::string_view system;
  std::size_t rounds;
  double speed;                // of a demonstration
  std::string_view unlearned;  // of its own table: what a demonstration meets without having
                               // learned it; the systems of the probes do not notice new materials
};

constexpr std::array<Beginning, 4> kBeginnings = {
    {{"lucs2", "single_tensor_product", 4, 4.0, "boccia"},
     {"lucs3", "shape_and_size", 3, 1.0, "block_90"},
     {"texture", "texture", 5, 1.0, ""},
     {"hardness", "hardness", 5, 1.0, ""}}};

const Beginning* beginning_of(const std::string& body) {
  const auto found = std::find_if(kBeginnings.begin(), kBeginnings.end(),
                                  [&](const Beginning& one) { return one.body == body; });
  return found == kBeginnings.end() ? nullptr : &*found;
}

std::optional<std::size_t> unlearned_thing(const Beginning& beginning, const Explorer& explorer) {
  const auto& things = explorer.things();
  const auto named = std::find_if(things.begin(), things.end(), [&](const ExploredThing& thing) {
    return thing.name == beginning.unlearned;
  });
  if (named == things.end() || things.size() < 3) return {};
  return static_cast<std::size_t>(named - things.begin());
}

std::vector<std::size_t> all_things(const Explorer& explorer) {
  std::vector<std::size_t> things(explorer.things().size());
  std::iota(things.begin(), things.end(), std::size_t{0});
  return things;
}

}  // namespace

Result<void> prepare_system(const Arguments& arguments, const std::string& body,
                            ViewSource& source) {
  const Beginning* beginning = arguments.has("body") ? beginning_of(body) : nullptr;
  if (beginning == nullptr || source.explorer->things().size() < 2) return {};
  const auto found =
      std::find_if(source.systems.begin(), source.systems.end(),
                   [&](const ViewSystem& one) { return one.name == beginning->system; });
  if (found == source.systems.end()) return {};
  SOMATO_TRY(std::shared_ptr<const SimulatedExplorer> explorer,
             chosen_simulation(arguments, kPriorSeed));
  source.system = static_cast<std::size_t>(found - source.systems.begin());
  std::vector<std::size_t> things = all_things(*explorer);
  if (source.demonstrates) {
    if (const auto unlearned = unlearned_thing(*beginning, *explorer)) {
      std::erase(things, *unlearned);
    }
  }
  source.prior_explorations = {beginning->rounds, std::move(explorer), std::move(things)};
  return {};
}

// The thing that has not been learned comes last, and once more after it has been named.
void plan_demonstration(const std::string& body, ViewSource& source) {
  const Beginning* beginning = beginning_of(body);
  std::optional<std::size_t> unlearned;
  if (beginning != nullptr) unlearned = unlearned_thing(*beginning, *source.explorer);
  source.demonstrates = true;
  for (const std::size_t thing : all_things(*source.explorer)) {
    if (thing != unlearned) source.plan.push_back({thing, 0});
  }
  if (unlearned) {
    source.plan.push_back({*unlearned, 0});
    source.plan.push_back({*unlearned, 1});
  }
  source.thing = source.plan.front().thing;
}

double demonstration_speed(const std::string& body) {
  const Beginning* beginning = beginning_of(body);
  return beginning == nullptr ? 1.0 : beginning->speed;
}

}  // namespace somato::program
