#include "explanation.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

namespace somato::program {
namespace {

std::string in_bytes(std::size_t bytes) {
  constexpr double kStep = 1024.0;
  auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  const std::vector<std::string> units{"B", "KiB", "MiB", "GiB", "TiB"};
  for (; size >= kStep && unit + 1 < units.size(); ++unit) size /= kStep;
  return fmt::format("{:.{}f} {}", size, unit == 0 ? 0 : 1, units[unit]);
}

std::vector<std::string> row_of(const System& system, const SystemModule& module) {
  std::vector<std::string> inputs;
  inputs.reserve(module.inputs.size());
  for (const std::size_t input : module.inputs) inputs.push_back(system.modules()[input].name);
  const std::size_t memory = module.module->memory();
  return {module.name,
          module.type->name,
          fmt::format("{}", fmt::join(inputs, ", ")),
          fmt::format("{}", fmt::join(module.output.shape, " x ")),
          fmt::format("{}{}", module.output.size(), module.output.sparse ? " (sparse)" : ""),
          module.output.rate == Rate::kFrame ? "frame" : "exploration",
          memory == 0 ? "" : in_bytes(memory)};
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
  std::vector<std::string> names;
  names.reserve(phase.learners.size());
  for (const std::size_t module : phase.learners) names.push_back(system.modules()[module].name);
  const std::string draws =
      phase.draws ? fmt::format("{} ", *phase.draws) : std::string("as many as it asks for: ");
  const bool at_once = phase.learners.size() == 1 &&
                       system.modules()[phase.learners.front()].module->learner()->learns_at_once();
  return fmt::format("{}: {}{}", fmt::join(names, ", "), at_once && !phase.draws ? "all " : draws,
                     choice_name(phase.of));
}

}  // namespace

std::string explanation(const System& system) {
  std::vector<std::vector<std::string>> rows{
      {"module", "type", "listens to", "shape", "elements", "every", "memory"}};
  std::size_t memory = 0;
  for (const SystemModule& module : system.modules()) {
    rows.push_back(row_of(system, module));
    memory += module.module->memory();
  }
  std::string text = table(rows) + "\n";
  for (std::size_t i = 0; i < system.phases().size(); ++i) {
    text += fmt::format("phase {}  {}\n", i + 1, phase_line(system, system.phases()[i]));
  }
  return text + fmt::format("learned memory {}\n", in_bytes(memory));
}

}  // namespace somato::program
