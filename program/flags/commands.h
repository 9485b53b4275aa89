#pragma once

#include "flags/command_line.h"

namespace somato::program {

Command run_command();
Command reproduce_command();
Command sweep_command();
Command merge_command();
Command report_command();
Command figure_command();
Command information_command();
Command suggest_command();
Command touch_order_command();
Command apply_command();
Command systems_command();
Command modules_command();
Command view_command();
Command live_command();
Command explore_command();
Command sense_command();
Command emulate_command();
Command device_check_command();
Command device_monitor_command();
Command device_calibrate_command();
Command import_command();
Command som_train_command();
Command som_map_command();
Command som_predict_command();
Command som_quality_command();
Command som_plot_command();
Command som_cluster_command();
Command som_features_command();
Command som_export_command();
Command som_import_command();
Command completions_command();
Command inspect_command();
Command recover_command();
Command convert_command();

/// Prints the reference of flags and keys, from the commands and the parameter declarations.
Command reference_command(const std::vector<Command>& others);

}  // namespace somato::program
