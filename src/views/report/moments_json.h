#pragma once

#include <cstddef>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "views/report/evidence.h"

namespace somato::detail {

/// The sensor readings of explorations, each once, although several systems may study it.
class Moments {
 public:
  /// For each sample the number of its readings in list(), or null; [] without a recording. If
  /// `adds`, readings that are not listed are added: of every sample, unless this would be more
  /// than 300000 numbers with 40 frames of each; then of the first exploration of each thing, with
  /// at most 200 frames. Channels with more than 64 elements have values at the moment only.
  nlohmann::ordered_json numbers(const Evidence& evidence, bool adds);

  /// As MomentData of web/schema/report.json: the frame where the channel `touch` has the greatest
  /// sum (of equals the first), of other channels the one nearest to it in time, or the last where
  /// there is no `touch`; and evenly chosen frames, this one among them.
  const nlohmann::ordered_json& list() const { return list_; }

 private:
  void add(const Evidence& evidence);
  void add(const Evidence& evidence, std::size_t exploration, std::size_t frames);

  using Key = std::pair<std::string, std::size_t>;  // hash of the recording, exploration
  std::map<Key, std::size_t> numbers_;
  nlohmann::ordered_json list_ = nlohmann::ordered_json::array();
};

}  // namespace somato::detail
