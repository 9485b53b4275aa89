#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system_model.h"
#include "somato/recording/recording.h"
#include "somato/report/results_file.h"

namespace somato {

/// A thing that can be explored, as far as it is known.
struct ReportThing {
  std::string name;
  std::string shape;                          ///< As in a table of objects; empty: none.
  std::optional<std::array<double, 3>> size;  ///< Width, depth, height in mm.
  double top_diameter = 0.0;                  ///< mm.
  std::string material;
  std::string hardness;
  std::optional<std::array<double, 3>> colour;  ///< Red, green, blue, 0 to 1.
  std::optional<double> mass;                   ///< kg.
};

/// A trained system and the file it was in.
struct ReportModel {
  std::string path;
  SystemModel model;
};

/// A valid recording and what it is called; nullptr: it is not at hand.
struct ReportRecording {
  std::string name;
  std::shared_ptr<const Recording> recording;
};

/// Results with the trained systems that may be theirs: the first that has their settings is taken.
struct ReportFile {
  ResultsFile results;
  std::vector<std::shared_ptr<const ReportModel>> models;
  std::vector<std::string> missing;  ///< What whoever looked for models has to say, in sentences.
};

/// Where a report gets from what results do not tell.
struct ReportSources {
  std::string version;  ///< Of the program.
  /// The recording with that content_hash(); without a function there is none.
  std::function<ReportRecording(const std::string& hash)> recording;
  std::string named_recordings = {};  ///< What somebody named to look for them in; empty: nothing.
  std::vector<ReportThing> things;
  std::map<std::string, std::string> units;  ///< Of settings, such as "explore.simulation.noise".
  std::size_t threads = 1;
};

/// A report, before it is a page.
struct Report {
  std::string json;  ///< As docs/formats/report.md says; the same bytes for the same sources.
  std::size_t systems = 0;
  std::size_t claims = 0;
  std::vector<std::string> missing;  ///< What was not at hand, each sentence once.
};

/// Puts together what is known about the systems in `files`. What is not at hand is left out, with
/// a sentence. Errors (kData): winners that are not on the map of the settings beside them.
Result<Report> make_report(const std::vector<ReportFile>& files, const ReportSources& sources);

/// The page with the report in place of the `null` that it has for it, written so that nothing in
/// it can end the element or be taken for code. Errors (kUsage): the page has no such place, or
/// more than one.
Result<std::string> report_page(std::string_view page, std::string_view json);

}  // namespace somato
