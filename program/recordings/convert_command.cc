#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "base/files/file_system.h"
#include "bodies/explorers/recorded_scenes.h"
#include "flags/commands.h"
#include "flags/output.h"
#include "recordings/explorations/checked_explorations.h"
#include "recordings/explorations/exploration_frames.h"
#include "recordings/study_data.h"
#include "somato/recording/format.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"
#include "views/exports/recording_export.h"

namespace somato::program {
namespace {

// Passes explorations on until a stop is requested.
class StoppableExplorations final : public FrameSink {
 public:
  explicit StoppableExplorations(FrameSink& to) : to_(&to) {}

  Result<void> begin_exploration(const ExplorationStart& start) override {
    return checked().and_then([&] { return to_->begin_exploration(start); });
  }

  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override {
    return checked().and_then([&] { return to_->frame(channel, values, time, valid); });
  }

  Result<void> end_exploration() override { return to_->end_exploration(); }

 private:
  static Result<void> checked() {
    if (!stop_requested()) return {};
    return fail(ErrorKind::kInterrupted, "the conversion was stopped");
  }

  FrameSink* to_;
};

Result<void> convert_folder(const std::string& path, FrameSink& to) {
  SOMATO_TRY(const Recording recording, read_study_data({}, path));
  SOMATO_TRY_VOID(validate(recording));
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY_VOID(hand_frames(exploration, to));
  }
  return {};
}

Result<ExportFormat> format_of(const Arguments& arguments) {
  if (!arguments.has("format")) return export_format_of(arguments.text("output"));
  return choice_named<ExportFormat>("format", arguments.text("format"), "--format");
}

// A file replaces the one at its path, which must not be read.
Result<void> check_target(ExportFormat format, const std::string& from, const std::string& path) {
  if (format != ExportFormat::kNpz) return {};
  return check_not_read(path, {from}).and_then([&] { return check_output(path); });
}

Result<void> run_convert(const Arguments& arguments) {
  const std::string from = arguments.text("DATA");
  const std::string path = arguments.text("output");
  SOMATO_TRY(const ExportFormat format, format_of(arguments));
  SOMATO_TRY_VOID(check_target(format, from, path));
  catch_stop_requests();
  SOMATO_TRY(const std::unique_ptr<RecordingExport> to,
             begin_export(format, path, recorded_scenes()));
  CheckedExplorations checked(*to);
  StoppableExplorations stoppable(checked);
  std::error_code failure;
  auto converted = std::filesystem::is_directory(from, failure)
                       ? convert_folder(from, stoppable)
                       : hand_file(operating_system(), from, stoppable);
  if (converted && checked.count() == 0) {
    converted = fail(ErrorKind::kData, "there are no explorations", from);
  }
  if (converted) converted = to->finish();
  if (!converted) return fail(with_place(std::move(converted.error()), from));
  print_summary(fmt::format("{}: {}\n", path, counted(checked.count(), "exploration")));
  return {};
}

}  // namespace

Command convert_command() {
  return {
      "convert",
      "Write a recording for pandas, numpy, ROS 2, Foxglove or Rerun",
      {{"DATA", "Recording: its file, or a folder of original files", true}},
      {{"-o,--output",
        "Folder (csv, bag, foxglove), which must not exist, or file (npz). A name that ends with "
        ".npz, _csv, _bag or _foxglove states the format",
        true, true, Role::kOutputFolder},
       {"--format",
        "csv: a table and a description for each channel; npz: arrays for numpy; bag: a bag "
        "of ROS 2; foxglove: a bag with a 3D scene of simulated bodies and a layout for "
        "Foxglove"}},
      {},
      run_convert};
}

}  // namespace somato::program
