#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/result.h"
#include "somato/core/value.h"
#include "somato/studies/claim.h"
#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// A question about several systems: the table `[question]` of its file.
struct QuestionParameters {
  std::string name;
  std::string text;
  std::vector<std::string> systems;
  std::size_t pairs = 24;

  static const Declarations<QuestionParameters>& declarations();
};

/// One system to run, as described by a file, with a question's changes.
struct ReproductionPart {
  std::string question;   ///< Empty: the system itself.
  std::string system;     ///< Name of its study.
  std::string variation;  ///< Empty: the unchanged system.
  StudyDescription description;
  Table explore;                     ///< The table `[explore]`; empty without one.
  std::optional<std::size_t> pairs;  ///< The maximum for a question.
};

/// The systems to run, and the claims about them.
struct ReproductionPlan {
  std::vector<ReproductionPart> parts;
  std::vector<Claim> claims;  ///< Each with its `system`, and `than_system` for a comparison.
};

/// A TOML file and the name by which it is requested.
struct NamedFile {
  std::string name;
  Table content;
  std::string text = {};  ///< The text of the file, for the results; empty: unknown.
};

/// Adds a file to the plan: a system, then its variations; or the systems of a question (a file
/// with a table [question]). `systems` are the files that a question may use. Errors (kUsage) with
/// their location: those of the descriptions, and of building systems whose channels state their
/// shapes; a question about an unknown system; a claim about a system that is not run.
Result<void> add_to_plan(const NamedFile& file, const std::vector<NamedFile>& systems,
                         ReproductionPlan& plan);

/// The settings of a table `[explore]`: `explore`, and for each table with values within it, at any
/// depth, `explore.NAME`. Empty if there are none.
std::vector<Settings> explore_settings(const Table& explore);

/// The number of pairs of a recording: `pairs` distributed equally, with one more for the first
/// recordings.
std::size_t pairs_of(std::size_t recording, std::size_t recordings, std::size_t pairs);

/// Adds the results of a study on a further recording to a part; its seeds follow those of the
/// preceding recordings. Errors (kData, with the part unchanged): protocols or metrics that differ
/// from the previous ones, for example if one recording has a single class. Throws InvalidArgument
/// for results without a protocol.
Result<void> add_results(const PartResults& found, PartResults& part);

/// The outcomes of the claims; those about systems that were not run are left out.
std::vector<ClaimOutcome> judge(const std::vector<Claim>& claims,
                                const std::vector<PartResults>& parts);

}  // namespace somato
