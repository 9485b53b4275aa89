#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "base/files/whole_file.h"
#include "flags/commands.h"
#include "report/made_report.h"
#include "terminal/terminal.h"
#include "terminal/wording.h"

namespace somato::program {
namespace {

Result<void> run_report(const Arguments& arguments) {
  SOMATO_TRY(const auto made, made_report(arguments, arguments.lists.at("RESULTS")));
  const std::string output = arguments.text("output");
  SOMATO_TRY_VOID(save_whole(output, made.page));
  const Report& report = made.report;
  const std::string inferences =
      report.inferences > 0 ? ", " + counted(report.inferences, "inference") : "";
  std::string text = fmt::format("{}: {}, {}{}\n", output, counted(report.systems, "system"),
                                 counted(report.claims, "claim"), inferences);
  for (const std::string& sentence : report.missing) text += "  " + sentence + "\n";
  print_summary(text);
  return {};
}

}  // namespace

Command report_command() {
  std::vector<Flag> flags = report_source_flags();
  flags.insert(flags.begin(),
               output_flag("-o,--output", "File for the page, such as report.html", true));
  return {
      "report",
      "Make one page of results for a browser: maps, the classes of their neurons, sensor "
      "readings, "
      "claims and inferences",
      {{"RESULTS",
        "results.json of studies and reproductions, inference.json of inferences, or their folders",
        true, true}},
      std::move(flags),
      {},
      run_report};
}

}  // namespace somato::program
