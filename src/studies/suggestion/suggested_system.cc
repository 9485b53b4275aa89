#include "studies/suggestion/suggested_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <set>
#include <string>
#include <vector>

#include "maps/grid/principal_plane.h"
#include "studies/codes/rounding.h"

namespace somato {
namespace {

// Those of with_size() that the map gets.
constexpr std::array kOfSize{"rows",      "columns",   "initial_weights", "training",
                             "epochs",    "tolerance", "radius_schedule", "radius_start",
                             "radius_end"};

// The names of modules in a setting.
std::vector<std::string> names_in(const Value& value) {
  if (const auto* name = std::get_if<std::string>(&value.content)) return {*name};
  std::vector<std::string> names;
  if (const auto* list = std::get_if<Value::List>(&value.content)) {
    for (const Value& item : *list) {
      if (const auto* name = std::get_if<std::string>(&item.content)) names.push_back(*name);
    }
  }
  return names;
}

std::vector<std::string> inputs_of(const ModuleDescription& module) {
  std::vector<std::string> inputs;
  for (const char* port : {"input", "inputs", "speed"}) {
    const Table::Entry* entry = module.settings.find(port);
    const auto* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
    if (!value) continue;
    for (const std::string& name : names_in(*value)) inputs.push_back(name);
  }
  return inputs;
}

// Those on which `output` depends, in order.
std::vector<ModuleDescription> needed(const std::vector<ModuleDescription>& modules,
                                      const std::string& output) {
  std::set<std::string> names{output};
  std::vector<ModuleDescription> found;
  for (const ModuleDescription& module : std::views::reverse(modules)) {
    if (!names.contains(module.name)) continue;
    for (const std::string& input : inputs_of(module)) names.insert(input);
    found.insert(found.begin(), module);
  }
  return found;
}

class SystemOfParts {
 public:
  SystemOfParts(const Suggestion& suggestion, std::span<const CandidateGroup> groups)
      : suggestion_(suggestion), groups_(groups) {}

  SystemDescription built() {
    std::vector<std::string> vectors;
    vectors.reserve(suggestion_.parts.size());
    for (const SuggestedPart& part : suggestion_.parts) vectors.push_back(add_part(part));
    const std::string input = vectors.size() == 1 ? vectors.front() : add_vector(vectors);
    add_map(input);
    return {suggestion_.parameters.name, modules_, {}};
  }

 private:
  void add(const ModuleDescription& module) {
    const bool is_known = std::ranges::any_of(
        modules_, [&](const ModuleDescription& known) { return known.name == module.name; });
    if (!is_known) modules_.push_back(module);
  }

  std::string add_part(const SuggestedPart& part) {
    const CandidateGroup& group = groups_[part.group];
    const CandidateCode& candidate = group.candidates[part.code];
    const Code code = scaled(candidate.code, candidate.scaling);
    std::vector<ModuleDescription> modules = group.sources[candidate.source].modules;
    modules.insert(modules.end(), code.modules.begin(), code.modules.end());
    std::ranges::for_each(needed(modules, code.output), [&](const auto& m) { add(m); });
    if (suggestion_.parts.size() == 1 || part.factor == 1.0) return code.output;
    const std::string name = "part_of_" + code.output;
    const SystemBuilder builder = SystemBuilder("").module(
        name, "scale", {{"input", {code.output}}, {"factor", {rounded(part.factor)}}});
    add(builder.description().modules.front());
    return name;
  }

  std::string add_vector(const std::vector<std::string>& vectors) {
    Value::List inputs;
    for (const std::string& vector : vectors) inputs.push_back({vector});
    const SystemBuilder builder =
        SystemBuilder("").module("vector", "concatenation", {{"inputs", {inputs}}});
    add(builder.description().modules.front());
    return "vector";
  }

  std::size_t elements_of_parts() const {
    std::size_t elements = 0;
    for (const SuggestedPart& part : suggestion_.parts) {
      elements += groups_[part.group].candidates[part.code].elements;
    }
    return elements;
  }

  void add_map(const std::string& input) {
    const auto [rows, columns] =
        sides_of_map(suggestion_.explorations, suggestion_.parameters.least_side.value_or(15),
                     suggestion_.size.share);
    SomParameters parameters = with_size({}, rows, columns);
    const bool has_plane =
        suggestion_.explorations <= kMostRowsOfPlane || elements_of_parts() <= kMostRowsOfPlane;
    if (!has_plane) parameters.initial_weights = InitialWeights::kSamples;
    std::vector<SystemBuilder::Setting> settings{{"input", {input}}};
    for (const char* name : kOfSize) {
      settings.push_back({name, SomParameters::declarations().find(name)->read(parameters)});
    }
    if (suggestion_.similarity != Similarity::kEuclidean) {
      settings.push_back({"similarity", {choice_name(suggestion_.similarity)}});
    }
    add(SystemBuilder("").module("map", "som", settings).description().modules.front());
  }

  const Suggestion& suggestion_;
  std::span<const CandidateGroup> groups_;
  std::vector<ModuleDescription> modules_;
};

}  // namespace

std::pair<std::size_t, std::size_t> sides_of_map(std::size_t explorations, std::size_t least_side,
                                                 double share) {
  const double wanted = share * static_cast<double>(explorations);
  const auto [rows, columns] = sides_of(std::min(wanted, most_neurons(explorations)));
  return {std::max(rows, least_side), std::max(columns, least_side)};
}

SystemDescription system_of(const Suggestion& suggestion, std::span<const CandidateGroup> groups) {
  return SystemOfParts(suggestion, groups).built();
}

}  // namespace somato
