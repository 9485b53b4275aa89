#pragma once

#include <string>
#include <vector>

#include "somato/studies/results.h"

namespace somato {

/// The files of a result, as commands name them; empty if unknown.
struct ResultFiles {
  std::string data;   ///< The recording.
  std::string model;  ///< The trained system.
};

/// A proposal for the user of a result.
struct NextStep {
  std::string text;                   ///< A sentence that gives the reason.
  std::vector<std::string> commands;  ///< Commands of a shell; may be empty.
  std::string page;  ///< A page of the documentation, such as "docs/suggest.md"; may be empty.
};

/// Proposals for what to try next, the most important first: by the difference between accuracy,
/// baseline and chance, the number of samples and the confusions. Empty for results of simulations
/// that this project made, and without a main_result().
std::vector<NextStep> next_steps(const PartResults& part, const ResultFiles& files);

}  // namespace somato
