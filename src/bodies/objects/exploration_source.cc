#include "bodies/objects/exploration_source.h"

#include <fmt/format.h>

namespace somato {
namespace {

constexpr std::string_view kSimulated = ", simulated (";
constexpr std::string_view kGivenThings = ", things of another table";
constexpr std::string_view kPlayed = ", sensors played, seed ";
constexpr std::string_view kDevice = "device ";

bool is_simulated(std::string_view source) {
  return source.find(kSimulated) != std::string_view::npos;
}

}  // namespace

std::string simulated_source(std::string_view body, std::string_view engine, std::uint64_t seed,
                             SimulatedThings things) {
  return fmt::format("{}{}{}), seed {}{}", body, kSimulated, engine, seed,
                     things == SimulatedThings::kGiven ? kGivenThings : std::string_view());
}

std::string played_source(std::string_view source, std::uint64_t seed) {
  const bool of_given_things = source.ends_with(kGivenThings);
  if (of_given_things) source.remove_suffix(kGivenThings.size());
  return fmt::format("{}{}{}{}", source.substr(0, source.find(kPlayed)), kPlayed, seed,
                     of_given_things ? kGivenThings : std::string_view());
}

std::string device_source(std::string_view name) {
  return fmt::format("{}{}", kDevice, name);
}

bool is_of_built_in_things(std::string_view source) {
  return is_simulated(source) && !source.ends_with(kGivenThings);
}

bool is_of_body(std::string_view source) {
  return is_simulated(source) || source.starts_with(kDevice);
}

}  // namespace somato
