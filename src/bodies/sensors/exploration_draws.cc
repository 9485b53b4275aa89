#include "bodies/sensors/exploration_draws.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "bodies/sensors/exact_values.h"
#include "recordings/explorations/true_values.h"
#include "somato/core/random.h"

namespace somato::detail {
namespace {

const std::string kName{kTrueDraws};
constexpr double kWord = 4294967296.0;  // 2^32

const std::vector<std::string>& names_of_draws() {
  static const std::vector<std::string> names{"seed_low",     "seed_high",    "thing",    "trial",
                                              "sound_before", "stick_before", "time_step"};
  return names;
}

double low_word(std::uint64_t value) {
  return static_cast<double>(static_cast<std::uint32_t>(value));
}

double high_word(std::uint64_t value) {
  return static_cast<double>(static_cast<std::uint32_t>(value >> 32));
}

// More than any exploration reaches.
constexpr double kMost = 1e9;

bool are_draws(const std::vector<double>& values) {
  return is_count(values[0], kWord - 1.0) && is_count(values[1], kWord - 1.0) &&
         std::all_of(values.begin() + 2, values.end() - 1,
                     [](double value) { return is_count(value, kMost); }) &&
         values.back() >= 0.0;
}

}  // namespace

std::uint64_t draws_seed(std::uint64_t seed, std::uint64_t thing, std::uint64_t trial,
                         Draws draws) {
  constexpr std::uint32_t kExploring = 0x6578706c;  // apart from other uses of the generator
  const auto words =
      philox4x32({static_cast<std::uint32_t>(thing), static_cast<std::uint32_t>(trial),
                  static_cast<std::uint32_t>(draws), kExploring},
                 {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)});
  return (static_cast<std::uint64_t>(words[1]) << 32) | words[0];
}

Result<std::optional<ExplorationDraws>> draws_of(const Exploration& exploration) {
  const Channel* channel = true_channel(exploration, kName);
  if (channel == nullptr) return std::optional<ExplorationDraws>();
  SOMATO_TRY_VOID(check_truth(*channel, kParts * names_of_draws().size()));
  const std::vector<double> values = exact_row(*channel, 0);
  if (!are_draws(values)) return bad_truth(*channel, "has other numbers than counts");
  const auto count = [&](std::size_t i) { return static_cast<std::uint64_t>(values[i]); };
  return ExplorationDraws{
      (count(1) << 32) | count(0), count(2), count(3), count(4), count(5), values[6]};
}

void put_draws(const ExplorationDraws& draws, Exploration& exploration) {
  Channel channel = exact_channel(kName, "", names_of_draws());
  add_exact(channel, std::array{low_word(draws.seed), high_word(draws.seed),
                                static_cast<double>(draws.thing), static_cast<double>(draws.trial),
                                static_cast<double>(draws.sound_before),
                                static_cast<double>(draws.stick_before), draws.time_step});
  const auto found = std::find_if(exploration.channels.begin(), exploration.channels.end(),
                                  [](const Channel& one) { return one.name == kName; });
  if (found != exploration.channels.end()) {
    *found = std::move(channel);
  } else {
    exploration.channels.push_back(std::move(channel));
  }
}

}  // namespace somato::detail
