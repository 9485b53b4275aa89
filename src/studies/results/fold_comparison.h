#pragma once

#include <optional>
#include <string>
#include <vector>

#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// The choice that a study's choice is compared with.
FoldChoice other_choice(FoldChoice choice);

/// Counts the samples that are named rightly: their true classes are `labels`, those named under
/// the choice of the study `named`, and under the other choice `other_named`.
void count_right(const std::vector<std::string>& labels, const std::vector<std::string>& named,
                 const std::vector<std::string>& other_named, FoldComparison& comparison);

/// Adds the counts of another recording.
void add(const FoldComparison& found, FoldComparison& all);

/// The accuracy of the first seed by a fold choice, "blocks" or "interleaved"; empty if the choices
/// were not compared.
std::optional<double> accuracy_by(const std::string& choice, const FoldComparison& comparison);

/// Whether the accuracy falls when neighbouring explorations are kept together, by more than two
/// standard errors: of b samples that are named rightly only in interleaved folds and c that are
/// only in blocks, b - c > 2 sqrt(b + c) (the statistic of McNemar, Psychometrika 12, 1947). For
/// samples that are all drawn independently this happens by chance in one of 40 comparisons.
bool neighbours_leak(const FoldComparison& comparison);

/// The comparison in one sentence.
std::string sentence_of(const FoldComparison& comparison);

}  // namespace somato
