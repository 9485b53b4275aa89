#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "base/archives/archive.h"
#include "somato/core/result.h"
#include "somato/maps/labels.h"

namespace somato {

/// The classes of neurons as a model file holds them: a number a neuron, -1 for none.
Array<std::int64_t> labels_array(const NeuronLabels& labels);

/// The part `labels` of an archive. Errors (kData, at `where`): another number of neurons, a class
/// that is not there, no neuron with a class.
Result<NeuronLabels> labels_from(const Archive& archive, std::size_t neurons, std::size_t classes,
                                 const std::string& where);

/// The votes of neurons as a model file contains them: neurons x classes.
Array<std::int64_t> votes_array(const NeuronVotes& votes, std::size_t classes);

/// The part `votes` of an archive. Errors (kData, at `where`): another number of neurons or
/// classes, a negative number of votes, or one above 2^53.
Result<NeuronVotes> votes_from(const Archive& archive, std::size_t neurons, std::size_t classes,
                               const std::string& where);

}  // namespace somato
