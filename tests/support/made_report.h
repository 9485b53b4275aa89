#pragma once

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "somato/core/random.h"
#include "somato/recording/content_hash.h"
#include "somato/report/report.h"
#include "somato/studies/study.h"
#include "support/made_study.h"
#include "support/temporary_folder.h"

namespace somato::testing {

using Json = nlohmann::ordered_json;

/// A study that was run, with all that a report may be told of it.
struct MadeStudy {
  StudyDescription description;
  std::shared_ptr<const Recording> recording;
  StudyOutcome outcome;

  MadeStudy(StudyDescription described, Recording made)
      : description(std::move(described)),
        recording(std::make_shared<const Recording>(std::move(made))),
        outcome(run_study(description, *recording).value()) {}

  /// Its results as they are read from a file.
  ReportFile file(bool with_model = true) const {
    ReportFile made{parse_results(to_json(outcome.results), "results.json").value(), {}, {}};
    if (with_model) made.models.push_back(model());
    return made;
  }

  std::shared_ptr<const ReportModel> model() const {
    const TemporaryFolder folder;
    const std::string path = folder.file("system.somato");
    if (!save_system(path, outcome.model.system, outcome.model.answer)) {
      throw std::runtime_error("the trained system cannot be saved");
    }
    return std::make_shared<const ReportModel>(
        ReportModel{"system.somato", load_system(path).value()});
  }

  ReportSources sources(bool with_recording = true) const {
    ReportSources all;
    all.version = "1.2.3";
    all.recording = [recorded = with_recording ? recording : nullptr](const std::string& hash) {
      const bool is_it = recorded && content_hash(*recorded) == hash;
      return is_it ? ReportRecording{"made.mcap", recorded} : ReportRecording{};
    };
    return all;
  }
};

/// The report of these files, as JSON.
inline Json report_of(const std::vector<ReportFile>& files, const ReportSources& sources) {
  return Json::parse(make_report(files, sources).value().json);
}

}  // namespace somato::testing
