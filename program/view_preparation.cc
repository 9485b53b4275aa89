#include "view_preparation.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "exploring_body.h"
#include "somato/bodies/exploring.h"

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
  double speed;  // of a demonstration
};

constexpr std::array<Beginning, 4> kBeginnings = {{{"lucs2", "single_tensor_product", 4, 4.0},
                                                   {"lucs3", "shape_and_size", 3, 1.0},
                                                   {"texture", "texture", 5, 1.0},
                                                   {"hardness", "hardness", 5, 1.0}}};

const Beginning* beginning_of(const std::string& body) {
  const auto found = std::find_if(kBeginnings.begin(), kBeginnings.end(),
                                  [&](const Beginning& one) { return one.body == body; });
  return found == kBeginnings.end() ? nullptr : &*found;
}

// A demonstration meets the last thing without having learned it.
std::size_t things_to_learn(const Explorer& explorer, bool demonstrates) {
  const std::size_t things = explorer.things().size();
  return demonstrates && things > 2 ? things - 1 : things;
}

// Each of the first `things` once.
Result<Recording> explore(const Explorer& explorer, std::size_t things, std::size_t round,
                          const std::function<bool()>& should_continue) {
  Recording recording;
  const std::size_t threads = std::max(1U, std::thread::hardware_concurrency());
  auto explored = explore_all(
      {things, 1, threads},
      [&](std::size_t thing, std::size_t) {
        ExploreOptions options;
        options.limits.should_continue = should_continue;
        return explorer.explore(thing, round, options);
      },
      [&](Exploration&& exploration) -> Result<void> {
        recording.explorations.push_back(std::move(exploration));
        return {};
      },
      [&](std::uint64_t, std::uint64_t) { return should_continue(); });
  if (!explored) return fail(std::move(explored.error()));
  return recording;
}

}  // namespace

Result<void> prepare_system(const Arguments& arguments, const std::string& body,
                            ViewSource& source) {
  const Beginning* beginning = beginning_of(body);
  if (beginning == nullptr || source.explorer->things().size() < 2) return {};
  const auto found =
      std::find_if(source.systems.begin(), source.systems.end(),
                   [&](const ViewSystem& one) { return one.name == beginning->system; });
  if (found == source.systems.end()) return {};
  SOMATO_TRY(auto session, body_session(arguments, kPriorSeed));
  const std::shared_ptr<const Explorer> explorer = std::move(session.explorer);
  source.system = static_cast<std::size_t>(found - source.systems.begin());
  source.prior_explorations = {
      beginning->rounds, [explorer, things = things_to_learn(*explorer, source.demonstrates)](
                             std::size_t round, const auto& should_continue) {
        return explore(*explorer, things, round, should_continue);
      }};
  return {};
}

void plan_demonstration(ViewSource& source) {
  const std::size_t things = source.explorer->things().size();
  source.demonstrates = true;
  source.plan.reserve(things);
  for (std::size_t thing = 0; thing < things; ++thing) source.plan.push_back({thing, 0});
  // Another time, after it has been named.
  if (things_to_learn(*source.explorer, true) < things) source.plan.push_back({things - 1, 1});
  source.thing = 0;
}

double demonstration_speed(const std::string& body) {
  const Beginning* beginning = beginning_of(body);
  return beginning == nullptr ? 1.0 : beginning->speed;
}

}  // namespace somato::program
