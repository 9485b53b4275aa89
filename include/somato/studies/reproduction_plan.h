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
#include "somato/studies/variation.h"

namespace somato {

/// What a file about several systems asks: its table `[question]`.
struct QuestionParameters {
  std::string name;
  std::string text;
  std::vector<std::string> systems;
  std::size_t pairs = 24;

  static const Declarations<QuestionParameters>& declarations();
};

/// One thing to run: a system as a file describes it, with a question's changes.
struct ReproductionPart {
  std::string question;   ///< Empty: the system is asked for itself.
  std::string system;     ///< Name of its study.
  std::string variation;  ///< Empty: as it stands.
  StudyDescription description;
  Table explore;                     ///< The table `[explore]`; empty without one.
  std::optional<std::size_t> pairs;  ///< At most so many; of a question.
};

/// What files ask to be run, and what is claimed.
struct ReproductionPlan {
  std::vector<ReproductionPart> parts;
  std::vector<Claim> claims;  ///< Each with its `system`, and `than_system` where it compares.
};

/// A TOML file that was read, by the name that it is asked for with.
struct NamedFile {
  std::string name;
  Table content;
};

/// Adds what a file asks for to the plan: a system as it stands, then its variations; or those of a
/// question (a file with a table [question]). `systems` are the files that a question may name.
/// Errors (kUsage) with their place: those of the descriptions, and of
/// building systems whose channels state their shapes; a question about a system that is
/// not among them; a claim about something that is not run.
Result<void> add_to_plan(const NamedFile& file, const std::vector<NamedFile>& systems,
                         ReproductionPlan& plan);

/// What a table `[explore]` says: `explore`, and for each table within it `explore.NAME`. None
/// where it says nothing.
std::vector<Settings> explore_settings(const Table& explore);

}  // namespace somato
