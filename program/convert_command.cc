#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "bags/bag_import.h"
#include "commands.h"
#include "exports/recording_export.h"
#include "output.h"
#include "somato/recording/format.h"
#include "somato/recording/recording_file.h"
#include "study_data.h"
#include "terminal.h"
#include "wording.h"

namespace somato::program {
namespace {

// Takes explorations one after the other, checked as validate() checks a recording.
class CheckedExport {
 public:
  explicit CheckedExport(RecordingExport& to) : to_(&to) {}

  Result<void> add(Exploration exploration) {
    if (stop_requested()) return fail(ErrorKind::kInterrupted, "the conversion was stopped");
    Recording single;
    single.explorations.push_back(std::move(exploration));
    const Exploration& added = single.explorations.front();
    SOMATO_TRY_VOID(validate(single));
    if (explorations_ == 0) first_ = sketch_of(added);
    SOMATO_TRY_VOID(check_alike(added, first_));
    ++explorations_;
    return to_->add(added);
  }

  std::uint64_t explorations() const { return explorations_; }

 private:
  RecordingExport* to_;
  Exploration first_;
  std::uint64_t explorations_ = 0;
};

// Only one exploration of a file is in memory.
Result<void> convert_file(const std::string& path, CheckedExport& to) {
  SOMATO_TRY(RecordingReader reader, RecordingReader::open(path));
  for (;;) {
    SOMATO_TRY(std::optional<Exploration> exploration, reader.next());
    if (!exploration) return {};
    SOMATO_TRY_VOID(to.add(std::move(*exploration)));
  }
}

Result<void> convert_folder(const std::string& path, CheckedExport& to) {
  SOMATO_TRY(Recording recording, read_study_data(RecordingFormat::kAutomatic, path));
  for (Exploration& exploration : recording.explorations) {
    SOMATO_TRY_VOID(to.add(std::move(exploration)));
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
  SOMATO_TRY(const std::unique_ptr<RecordingExport> to, begin_export(format, path));
  CheckedExport checked(*to);
  std::error_code failure;
  auto converted = std::filesystem::is_directory(from, failure) ? convert_folder(from, checked)
                                                                : convert_file(from, checked);
  if (converted && checked.explorations() == 0) {
    converted = fail(ErrorKind::kData, "there are no explorations", from);
  }
  if (converted) converted = to->finish();
  if (!converted) return fail(with_place(std::move(converted.error()), from));
  print_summary(fmt::format("{}: {}\n", path, counted(checked.explorations(), "exploration")));
  return {};
}

}  // namespace

Command convert_command() {
  return {"convert",
          "Write a recording for pandas, numpy or ROS 2",
          {{"DATA", "Recording: its file, or a folder of original files", true}},
          {{"-o,--output",
            "Folder (csv, bag), which must not exist, or file (npz). A name that ends with .npz, "
            "_csv or _bag states the format",
            true, true, Role::kOutputFolder},
           {"--format",
            "csv: a table and a description for each channel; npz: arrays for numpy; bag: a bag "
            "of ROS 2"}},
          {},
          run_convert};
}

}  // namespace somato::program
