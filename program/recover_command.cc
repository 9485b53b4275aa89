#include <fmt/format.h>

#include <string>

#include "commands.h"
#include "somato/recording/recover_recording.h"

namespace somato::program {
namespace {

void print_report(const RecoveryReport& report) {
  for (const Error& damage : report.damage) fmt::print("{}: {}\n", damage.where, damage.what);
  if (report.damaged_places > report.damage.size()) {
    fmt::print("and {} places more\n", report.damaged_places - report.damage.size());
  }
  fmt::print("saved: {} explorations, {} frames\nincomplete: {} explorations\n",
             report.explorations, report.messages, report.incomplete);
}

Result<void> recover(const Arguments& arguments) {
  const Result<RecordingFileParameters> parameters = read_flags<RecordingFileParameters>(arguments);
  if (!parameters) return fail(parameters.error());
  const std::string from = arguments.text("FILE");
  const Result<RecoveryReport> report =
      recover_recording(from, arguments.text("output"), *parameters);
  if (!report) return fail(report.error());
  print_report(*report);
  if (report->lossless) return {};
  return fail(ErrorKind::kIncomplete, "something was lost", from,
              fmt::format("{} holds all that could be saved", arguments.text("output")));
}

}  // namespace

Command recover_command() {
  return {"recover",
          "Save what a damaged recording holds",
          {{"FILE", "A recording (MCAP) that is cut off or damaged", true}},
          {output_flag("-o,--output", "Where the new, whole recording goes", true),
           {"--compression", "How chunks are packed: none, lz4 or zstd (default)"}},
          {},
          recover};
}

}  // namespace somato::program
