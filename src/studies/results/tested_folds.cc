#include "studies/results/tested_folds.h"

#include <algorithm>

#include "somato/maps/labels.h"
#include "studies/description/folds.h"

namespace somato {
namespace {

// The assignment depends on the first seed, the classes and the order of the samples.
std::vector<Fold> k_folds(const Run& first, std::size_t parts, FoldChoice choice) {
  FoldSamples samples{first.labels.size()};
  samples.classes = Classes::from_names(first.labels).of_sample;
  samples.folds = parts;
  samples.seed = first.seed;
  samples.choice = choice;
  if (parts < 2 || parts > samples.samples) return {};
  return folds(Protocol::kFolds, samples);
}

std::vector<Fold> folds_of_groups(const std::vector<std::string>& groups) {
  FoldSamples samples{groups.size()};
  Classes classes = Classes::from_names(groups);
  if (classes.names.size() < 2) return {};
  samples.groups = std::move(classes.of_sample);
  return folds(Protocol::kLeaveGroupOut, samples);
}

std::vector<Fold> folds_of(const ProtocolResults& protocol, std::size_t parts, FoldChoice choice,
                           const std::vector<std::string>& groups) {
  const Run& first = protocol.runs.front();
  if (first.map || first.labels.size() != protocol.samples) return {};
  if (protocol.protocol == "k_folds") return k_folds(first, parts, choice);
  const bool are_known = groups.size() == protocol.samples;
  if (protocol.protocol == "leave_group_out" && are_known) return folds_of_groups(groups);
  return {};
}

}  // namespace

std::vector<std::size_t> tested_folds(const ProtocolResults& protocol, std::size_t parts,
                                      FoldChoice choice, const std::vector<std::string>& groups) {
  if (protocol.runs.empty()) return {};
  const std::vector<Fold> all = folds_of(protocol, parts, choice, groups);
  if (all.size() < 2) return {};
  std::vector<std::size_t> numbers(protocol.samples);
  for (std::size_t fold = 0; fold < all.size(); ++fold) {
    for (const std::size_t sample : all[fold].test) numbers[sample] = fold;
  }
  return numbers;
}

}  // namespace somato
