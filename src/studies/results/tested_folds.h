#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "somato/studies/results.h"
#include "somato/studies/study_parameters.h"

namespace somato {

/// For each sample the number of the training by which it was tested, the same in every run: by
/// `k_folds` with `parts` folds by this choice, or by `leave_group_out`, whose group each sample
/// has in `groups`. Empty for other protocols, for a single training, and without `groups` that are
/// needed.
std::vector<std::size_t> tested_folds(const ProtocolResults& protocol, std::size_t parts,
                                      FoldChoice choice, const std::vector<std::string>& groups);

}  // namespace somato
