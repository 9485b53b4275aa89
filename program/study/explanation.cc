#include "study/explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "base/core/memory.h"
#include "flags/result_output.h"

namespace somato::program {
namespace {

std::vector<std::string> names_of(const System& system, const std::vector<std::size_t>& modules) {
  std::vector<std::string> names;
  names.reserve(modules.size());
  for (const std::size_t module : modules) names.push_back(system.modules()[module].name);
  return names;
}

std::string rate_of(const SystemModule& module) {
  return module.output.rate == Rate::kFrame ? "frame" : "exploration";
}

std::vector<std::string> row_of(const System& system, const SystemModule& module) {
  const std::vector<std::string> inputs = names_of(system, module.inputs);
  const std::size_t memory = module.module->memory();
  return {module.name,
          module.type->name,
          fmt::format("{}", fmt::join(inputs, ", ")),
          fmt::format("{}", fmt::join(module.output.shape, " x ")),
          fmt::format("{}{}", module.output.size(), module.output.sparse ? " (sparse)" : ""),
          rate_of(module),
          memory == 0 ? "" : memory_text(static_cast<double>(memory))};
}

std::string table(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.front().size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      line += fmt::format("{:<{}}", row[i], widths[i] + 2);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string phase_line(const System& system, const Phase& phase) {
  const std::vector<std::string> names = names_of(system, phase.learners);
  const std::string draws =
      phase.draws ? fmt::format("{} ", *phase.draws) : std::string("by default: ");
  const bool at_once = phase.learners.size() == 1 &&
                       system.modules()[phase.learners.front()].module->learner()->learns_at_once();
  return fmt::format("{}: {}{}", fmt::join(names, ", "), at_once && !phase.draws ? "all " : draws,
                     choice_name(phase.of));
}

Table module_table(const System& system, const SystemModule& module) {
  return {{},
          {entry("module", module.name), entry("type", module.type->name),
           entry("inputs", names_of(system, module.inputs)), entry("shape", module.output.shape),
           entry("elements", module.output.size()), entry("sparse", module.output.sparse),
           entry("every", rate_of(module)), entry("memory", module.module->memory())}};
}

Table phase_table(const System& system, const Phase& phase) {
  Table table{{}, {entry("modules", names_of(system, phase.learners))}};
  if (phase.draws) table.entries.push_back(entry("draws", *phase.draws));
  table.entries.push_back(entry("of", choice_name(phase.of)));
  return table;
}

}  // namespace

Table explanation_table(const System& system) {
  std::size_t memory = 0;
  for (const SystemModule& module : system.modules()) memory += module.module->memory();
  const auto of_module = [&](const SystemModule& module) { return module_table(system, module); };
  const auto of_phase = [&](const Phase& phase) { return phase_table(system, phase); };
  return {{},
          {entry("modules", system.modules(), of_module),
           entry("phases", system.phases(), of_phase), entry("learned_memory", memory)}};
}

std::string explanation(const System& system) {
  std::vector<std::vector<std::string>> rows{
      {"module", "type", "input from", "shape", "elements", "every", "memory"}};
  std::size_t memory = 0;
  for (const SystemModule& module : system.modules()) {
    rows.push_back(row_of(system, module));
    memory += module.module->memory();
  }
  std::string text = table(rows) + "\n";
  for (std::size_t i = 0; i < system.phases().size(); ++i) {
    text += fmt::format("phase {}  {}\n", i + 1, phase_line(system, system.phases()[i]));
  }
  return text + fmt::format("learned memory {}\n", memory_text(static_cast<double>(memory)));
}

}  // namespace somato::program
