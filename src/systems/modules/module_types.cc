#include "somato/graph/module.h"

#include <utility>

#include "systems/modules/support.h"

namespace somato {
namespace {

std::vector<ModuleType> all_types() {
  std::vector<ModuleType> all;
  for (const auto types : modules::kTypesOfSources) {
    for (ModuleType& type : types()) all.push_back(std::move(type));
  }
  return all;
}

}  // namespace

Result<Sequence> Module::run(std::span<const Sequence* const> /*inputs*/) const {
  return fail(ErrorKind::kUsage, "the module runs frame by frame");
}

Result<void> Learner::learn(const LearningPlan& /*plan*/, const TrainingInputs& /*explorations*/) {
  return fail(ErrorKind::kUsage, "it cannot learn from all samples at once");
}

Result<std::uint64_t> Learner::begin(const LearningPlan& /*plan*/,
                                     const TrainingInputs& /*explorations*/) {
  return fail(ErrorKind::kUsage, "it cannot learn one draw at a time");
}

Result<void> Learner::step(std::span<const SignalView> /*inputs*/, std::uint64_t /*draw*/) {
  return fail(ErrorKind::kUsage, "it cannot learn one draw at a time");
}

void Learner::turn_to(std::size_t /*exploration*/) {}

void Learner::finish() {}

const std::vector<ModuleType>& module_types() {
  static const std::vector<ModuleType> all = all_types();
  return all;
}

Result<const ModuleType*> find_module_type(const std::string& name, const std::string& where) {
  std::vector<std::string> known;
  for (const ModuleType& type : module_types()) {
    if (type.name == name) return &type;
    known.push_back(type.name);
  }
  return fail(unknown_name("type of module", name, where, known));
}

}  // namespace somato
