#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/studies/claim.h"
#include "somato/studies/results.h"

namespace somato {

/// One training and testing of a system: which recording, and the seed of what learns.
struct Pair {
  std::size_t recording = 0;
  std::uint64_t seed = 0;
};

/// How many of `pairs` a recording has: as equal numbers as can be, the first recordings one more.
std::size_t pairs_of(std::size_t recording, std::size_t recordings, std::size_t pairs);

/// What came of a part: its study under each protocol, over all pairs of recording and seed.
struct PartResults {
  std::string question;
  std::string system;
  std::string variation;
  std::vector<std::string> recordings;  ///< Names of those it was run on.
  std::vector<Settings> settings;       ///< As the first recording decided them.
  std::vector<Pair> pairs;
  std::vector<SystemResults> protocols;  ///< Metrics with one value a pair, runs one a pair.
};

/// Adds what a study found on recording number `recording` of the part, whose seeds follow those of
/// the recording before. Errors (kData, the part as it was): protocols or metrics that differ from
/// those before, as where one recording leaves nothing to tell apart. Throws InvalidArgument for
/// results without a protocol.
Result<void> add_results(const StudyResults& found, std::size_t recording, PartResults& part);

/// A recording that was explored or given.
struct RecordingInfo {
  std::string name;
  std::string source;  ///< Where it comes from: its settings, or its path's last part.
  std::uint64_t seed = 0;
  std::string data_hash;
  std::size_t explorations = 0;
};

/// A system that was asked for and could not be run on what was given.
struct NotApplicable {
  std::string system;
  std::string reason;
};

/// Everything that a reproduction found.
struct ReproductionResults {
  std::uint64_t seed = 0;
  std::size_t pairs = 0;
  std::vector<RecordingInfo> recordings;
  std::vector<PartResults> parts;
  std::vector<ClaimOutcome> claims;
  std::vector<NotApplicable> not_applicable;
};

/// How the claims came out; those about something that was not run are left out.
std::vector<ClaimOutcome> judge(const std::vector<Claim>& claims,
                                const std::vector<PartResults>& parts);

/// The results as results.json of a reproduction, version 1; the same bytes for the same results.
std::string to_json(const ReproductionResults& results);

}  // namespace somato
