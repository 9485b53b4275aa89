#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "flags/commands.h"
#include "flags/result_output.h"
#include "somato/recording/recover_recording.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

std::string text_of(const RecoveryReport& report) {
  std::string text;
  for (const Error& damage : report.damage) {
    text += fmt::format("{}: {}\n", damage.where, damage.what);
  }
  if (report.damaged_places > report.damage.size()) {
    text += fmt::format("and {} more places\n", report.damaged_places - report.damage.size());
  }
  return text +
         fmt::format("saved: {}, {}\nincomplete: {}\n", counted(report.explorations, "exploration"),
                     counted(report.messages, "frame"), counted(report.incomplete, "exploration"));
}

Table table_of(const RecoveryReport& report) {
  const auto of_place = [](const Error& place) {
    return Table{{}, {entry("where", place.where), entry("what", place.what)}};
  };
  return {{},
          {entry("explorations", report.explorations), entry("frames", report.messages),
           entry("incomplete", report.incomplete), entry("damaged_places", report.damaged_places),
           entry("damage", report.damage, of_place), entry("lossless", report.lossless)}};
}

Result<void> recover(const Arguments& arguments) {
  SOMATO_TRY(const RecordingFileParameters parameters,
             read_flags<RecordingFileParameters>(arguments));
  const std::string from = arguments.text("FILE");
  SOMATO_TRY(const auto report, recover_recording(from, arguments.text("output"), parameters));
  print_summary(arguments, text_of(report), table_of(report));
  if (report.lossless) return {};
  return fail(ErrorKind::kIncomplete, "some data could not be recovered", from,
              fmt::format("{} contains all readable data", arguments.text("output")));
}

}  // namespace

Command recover_command() {
  return {"recover",
          "Recover the readable part of a damaged recording",
          {{"FILE", "Truncated or damaged recording (MCAP)", true}},
          {output_flag("-o,--output", "File for the recovered recording", true),
           {"--compression", "Compression of chunks: none, lz4 or zstd (default)"},
           json_flag()},
          {},
          recover};
}

}  // namespace somato::program
