#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/support/json_schema.h"
#include "base/support/temporary_folder.h"
#include "recordings/explorations/content_hash.h"
#include "somato/core/random.h"
#include "somato/studies/reproduction.h"
#include "somato/studies/study.h"
#include "studies/support/made_study.h"
#include "views/report/report.h"
#include "views/report/results_file.h"

namespace somato::testing {

using Json = nlohmann::ordered_json;

/// A study that was run, with all optional data of a report.
struct MadeStudy {
  StudyDescription description;
  std::shared_ptr<const Recording> recording;
  StudyOutcome outcome;

  MadeStudy(StudyDescription described, Recording made)
      : description(std::move(described)),
        recording(std::make_shared<const Recording>(std::move(made))),
        outcome(run_study(description, *recording).value()) {}

  /// Its results with all that `somato run` says of them, read from a file.
  ReportFile file(const std::vector<Claim>& claims = {}) const {
    PartResults part = outcome.results;
    part.recordings[0].name = "made.mcap";
    part.model = ModelFile{"system.somato", "fnv1a64:0", part.pairs.front().seed};
    Results results{{part}, judge(claims, {part}), {}};
    return {"results.json", parse_results(to_json(results), "results.json").value()};
  }

  ReportModel model() const {
    const TemporaryFolder folder;
    const std::string path = folder.file("system.somato");
    if (!save_system(path, outcome.model.system, outcome.model.answer)) {
      throw std::runtime_error("the trained system cannot be saved");
    }
    return {"system.somato", load_system(path).value()};
  }

  ReportSources sources(bool with_recording = true, bool with_model = true) const {
    ReportSources all;
    all.version = "1.2.3";
    all.recording = [recorded = with_recording ? recording : nullptr](const std::string& hash) {
      const bool is_it = recorded && content_hash(*recorded) == hash;
      return is_it ? recorded : nullptr;
    };
    if (with_model) {
      all.model = [this](const std::string&, const ModelFile&) -> Result<ReportModel> {
        return model();
      };
    }
    return all;
  }
};

/// The report of these files, as JSON, checked by its schema.
inline Json report_of(const std::vector<ReportFile>& files, const ReportSources& sources) {
  const std::string text = make_report(files, sources).value().json;
  EXPECT_TRUE(text_fits_schema(text, "report.json"));
  return Json::parse(text);
}

}  // namespace somato::testing
