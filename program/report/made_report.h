#pragma once

#include <string>
#include <vector>

#include "flags/command_line.h"
#include "somato/core/result.h"
#include "views/report/report.h"

namespace somato::program {

/// The flags --data, --model and --threads, by which the sources of a report are found.
std::vector<Flag> report_source_flags();

struct MadeReport {
  std::string page;  ///< HTML with the data of the report.
  Report report;
};

/// The report of the results at `paths`. Errors: kUsage without the pages, if a file is given twice
/// or if --output would replace a file that is read; those of reading the files and of
/// make_report().
Result<MadeReport> made_report(const Arguments& arguments, const std::vector<std::string>& paths);

}  // namespace somato::program
