#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/samples.h"
#include "somato/studies/study_parameters.h"
#include "views/report/report.h"

namespace somato::detail {

/// The data that a report reads in addition to the results of a part.
struct Evidence {
  const PartResults* part = nullptr;
  std::optional<StudyDescription> study;
  std::optional<ReportModel> model;
  std::shared_ptr<const Recording> recording;
  std::size_t recording_number = 0;  ///< The number of `recording` among those of the part.
  std::vector<std::size_t>
      explorations;                ///< The explorations of `recording` that are samples, in order.
  std::optional<System> built;     ///< Without a model, from `study`.
  std::optional<std::size_t> map;  ///< The module that answers, of system().
  std::optional<Samples> inputs;   ///< Those of the map, one for each sample; see read_inputs().
  std::vector<std::string> missing;  ///< Sentences.

  /// The trained system, or one that has learned nothing, or nullptr.
  const System* system() const;
};

/// Looks for model and recording of `part`, which is one of `file`.
Evidence find_evidence(const ReportFile& file, const PartResults& part,
                       const ReportSources& sources);

/// Runs the trained system on the samples: sets `inputs`, if there are model and recording, or adds
/// a sentence to `missing`. The result is the same for any number of threads.
void read_inputs(Evidence& evidence, std::size_t threads);

}  // namespace somato::detail
