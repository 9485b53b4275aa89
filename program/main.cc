#include "flags/commands.h"
#include "flags/completion.h"
#include "terminal/terminal.h"

int main(int argc, char** argv) {
  using namespace somato::program;
  report_file_size_limits();
  std::vector<Command> commands{
      explore_command(),      reproduce_command(),      run_command(),
      sweep_command(),        merge_command(),          report_command(),
      figure_command(),       view_command(),           live_command(),
      information_command(),  suggest_command(),        touch_order_command(),
      apply_command(),        systems_command(),        modules_command(),
      import_command(),       inspect_command(),        recover_command(),
      convert_command(),      som_train_command(),      som_map_command(),
      som_quality_command(),  som_plot_command(),       som_cluster_command(),
      som_features_command(), som_export_command(),     som_import_command(),
      som_predict_command(),  completions_command(),    emulate_command(),
      device_check_command(), device_monitor_command(), device_calibrate_command(),
  };
  commands.insert(commands.begin() + 1, sense_command());
  commands.push_back(reference_command(commands));
  if (is_completion_request(argc, argv)) return answer_completion_request(argc, argv, commands);
  return run_command_line(argc, argv, commands);
}
