#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/reproduction.h"

namespace somato {

/// A claim as a reproduction's results.json has it.
struct JudgedClaim {
  ClaimOutcome outcome;  ///< Judged by the systems in the same file.
  double share = 0.0;    ///< As the file says.
};

/// What a results.json holds: of a study (docs/reference/results.md, version 3), which is one part
/// on one recording without a name, or of a reproduction (docs/reference/reproduction.md).
struct ResultsFile {
  std::string path;  ///< As it was named.
  bool is_study = false;
  std::vector<PartResults> parts;
  std::vector<RecordingInfo> recordings;
  std::vector<JudgedClaim> claims;  ///< None in a study.

  /// The recording of that name, or nullptr.
  const RecordingInfo* find_recording(const std::string& name) const;
};

/// Reads the text of a results.json, which is `path`. Nothing in it is trusted. Errors (kData, with
/// the field): no JSON, another version, another kind of file, fields that are missing, of another
/// type or out of range, lists whose lengths do not fit each other.
Result<ResultsFile> parse_results(std::string_view text, const std::string& path);

}  // namespace somato
