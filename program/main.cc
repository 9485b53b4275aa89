#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/completion.h"
#include "terminal/terminal.h"
#include "version.h"

namespace somato::program {
namespace {

// In the order of the help. Those of parts that this build lacks are not linked.
std::vector<Command> commands_of_this_build() {
  std::vector<Command> commands;
  const auto add = [&](Command command) { commands.push_back(std::move(command)); };
  add(explore_command());
  if constexpr (kHasSimulation) {
    add(sense_command());
    add(reproduce_command());
  }
  if constexpr (kHasStudies) add(run_command());
  if constexpr (kHasSimulation) {
    add(sweep_command());
    add(merge_command());
  }
  if constexpr (kHasReport) {
    add(report_command());
    add(figure_command());
    add(view_command());
  }
  add(live_command());
  if constexpr (kHasStudies) {
    add(information_command());
    add(suggest_command());
    add(touch_order_command());
  }
  add(apply_command());
  if constexpr (kHasStudies) add(systems_command());
  add(modules_command());
  if constexpr (kHasImporters) add(import_command());
  add(inspect_command());
  add(recover_command());
  if constexpr (kHasImporters) add(convert_command());
  if constexpr (kHasStudies) {
    add(som_train_command());
    add(som_map_command());
    add(som_quality_command());
  }
  if constexpr (kHasReport) add(som_plot_command());
  if constexpr (kHasStudies) {
    add(som_cluster_command());
    add(som_features_command());
  }
  if constexpr (kHasImporters) {
    add(som_export_command());
    add(som_import_command());
  }
  if constexpr (kHasStudies) add(som_predict_command());
  add(completions_command());
  if constexpr (kHasSimulation) add(emulate_command());
  add(device_check_command());
  add(device_monitor_command());
  add(device_calibrate_command());
  add(reference_command(commands));
  return commands;
}

}  // namespace
}  // namespace somato::program

int main(int argc, char** argv) {
  using namespace somato::program;
  report_file_size_limits();
  const std::vector<Command> commands = commands_of_this_build();
  if (is_completion_request(argc, argv)) return answer_completion_request(argc, argv, commands);
  return run_command_line(argc, argv, commands);
}
