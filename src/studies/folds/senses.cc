#include "studies/folds/senses.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/core/contains.h"
#include "somato/codes/concatenation.h"
#include "somato/graph/system_model.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

class Seeker {
 public:
  explicit Seeker(const System& system) : system_(system), seen_(system.modules().size(), false) {}

  void visit(std::size_t number) {
    if (seen_[number]) return;
    seen_[number] = true;
    const SystemModule& module = system_.modules()[number];
    if (som_of(system_, number)) return add(vectors_of_map(system_, number));
    Numbers inputs = module.inputs;
    if (is_association(module)) inputs.resize(1);
    if (std::any_of(inputs.begin(), inputs.end(), [&](std::size_t input) {
          return system_.modules()[input].output.rate == Rate::kFrame;
        })) {
      return add(number);
    }
    for (const std::size_t input : inputs) visit(input);
  }

  Numbers found() && { return std::move(found_); }

 private:
  void add(std::size_t module) {
    if (!contains(found_, module)) found_.push_back(module);
  }

  const System& system_;
  std::vector<bool> seen_;
  Numbers found_;
};

}  // namespace

bool is_association(const SystemModule& module) {
  return module.type->name == "association";
}

std::size_t vectors_of_map(const System& system, std::size_t map) {
  const std::size_t input = system.modules()[map].inputs.front();
  const SystemModule& module = system.modules()[input];
  return module.type->name == "standardization" ? module.inputs.front() : input;
}

std::vector<std::size_t> vectors_behind(const System& system, std::size_t module) {
  Seeker seeker(system);
  seeker.visit(module);
  return std::move(seeker).found();
}

ExplorationValues values_of(Activations& activations, const std::vector<std::size_t>& modules) {
  if (modules.size() == 1) return activations.values_of(modules.front());
  ExplorationValues all = activations.values_of(modules.front());
  for (const std::size_t module : modules) {
    const auto& known = activations.values_of(module).explorations;
    Numbers common;
    std::set_intersection(all.explorations.begin(), all.explorations.end(), known.begin(),
                          known.end(), std::back_inserter(common));
    all.explorations = std::move(common);
  }
  std::vector<Signal> signals;
  signals.reserve(all.explorations.size());
  SignalBuffer joined;
  for (const std::size_t exploration : all.explorations) {
    std::vector<SignalView> parts;
    parts.reserve(modules.size());
    for (const std::size_t module : modules) {
      parts.push_back(activations.find(module, exploration)->values[0]);
    }
    concatenation(parts, joined);
    signals.push_back(Signal::copy_of(joined.view()));
  }
  all.samples = Samples::from_signals(signals);
  return all;
}

Result<std::size_t> find_recall(const System& system, std::size_t map, const std::string& name,
                                const std::string& where) {
  SOMATO_TRY(const auto module, system.find(name, where));
  const PortType& output = system.modules()[module].output;
  const PortType& of_map = system.modules()[map].output;
  if (output.rate == Rate::kExploration && output.shape == of_map.shape) return module;
  return fail(
      ErrorKind::kUsage,
      fmt::format("'{}' gives {}, but the map gives {}", name, to_string(output),
                  to_string(of_map)),
      where,
      "name an association whose target is the map, or a sum of such associations and the map");
}

}  // namespace somato
