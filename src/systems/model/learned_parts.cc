#include "systems/model/learned_parts.h"

#include <string>

#include "base/archives/archive.h"
#include "maps/t_mpsom/t_mpsom_archive.h"

namespace somato {
namespace {

const std::string kLearnedPrefix = "learned.";

bool is_a(const System& system, std::size_t module, const std::string& type) {
  return system.modules()[module].type->name == type;
}

// The learned values of the module, by their names in a model file.
Archive parts_of(const System& system, std::size_t module) {
  Archive archive("parts");
  const Learner* learner = system.modules()[module].module->learner();
  if (learner) learner->save(archive, kLearnedPrefix);
  return archive;
}

std::vector<double> numbers_in(const Archive& archive, const std::string& name) {
  const auto found = archive.get<Array<double>>(kLearnedPrefix + name, {});
  return found ? (*found)->values : std::vector<double>{};
}

// A number for all elements, or one each.
std::vector<double> stated(const System& system, std::size_t module, const std::string& name) {
  const Table::Entry* entry = system.description().modules[module].settings.find(name);
  const auto* value = entry ? std::get_if<Value>(&entry->content) : nullptr;
  if (!value) return {};
  const auto* list = std::get_if<Value::List>(&value->content);
  std::vector<double> numbers;
  for (const Value& one : list ? *list : Value::List{*value}) {
    if (const auto* number = std::get_if<double>(&one.content)) numbers.push_back(*number);
    if (const auto* whole = std::get_if<std::int64_t>(&one.content)) {
      numbers.push_back(static_cast<double>(*whole));
    }
  }
  return numbers;
}

}  // namespace

std::optional<TMpsom> t_mpsom_of(const System& system, std::size_t module) {
  if (!is_a(system, module, "t_mpsom")) return {};
  auto map = t_mpsom_from(parts_of(system, module), kLearnedPrefix, {});
  return map ? std::optional(std::move(*map)) : std::nullopt;
}

std::optional<Standardization> standardization_of(const System& system, std::size_t module) {
  if (!is_a(system, module, "standardization")) return {};
  const Archive parts = parts_of(system, module);
  return Standardization{numbers_in(parts, "means"), numbers_in(parts, "deviations")};
}

std::optional<std::vector<std::pair<double, double>>> one_hot_ranges_of(const System& system,
                                                                        std::size_t module) {
  if (!is_a(system, module, "one_hot")) return {};
  const Archive parts = parts_of(system, module);
  const bool learned = system.modules()[module].module->learner() != nullptr;
  const auto low = learned ? numbers_in(parts, "low") : stated(system, module, "low");
  const auto high = learned ? numbers_in(parts, "high") : stated(system, module, "high");
  const std::size_t input = system.modules()[module].inputs.front();
  std::vector<std::pair<double, double>> ranges;
  ranges.reserve(system.modules()[input].output.size());
  for (std::size_t i = 0; i < system.modules()[input].output.size(); ++i) {
    ranges.emplace_back(low[low.size() == 1 ? 0 : i], high[high.size() == 1 ? 0 : i]);
  }
  return ranges;
}

}  // namespace somato
