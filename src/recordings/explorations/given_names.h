#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// Labels that viewers gave to explorations, such as the name of what was touched. They stand
/// beside the recording, which other threads may read.
class GivenNames {
 public:
  /// Gives a label to the exploration with that index, which may not have ended yet.
  void give(std::size_t exploration, const Label& label);

  /// Takes back what was given to an exploration that was discarded.
  void forget(std::size_t exploration) { given_.erase(exploration); }

  /// The value of the label that was given to an exploration, or nothing.
  std::optional<std::string> given(std::size_t exploration, const std::string& label) const;

  bool empty() const { return given_.empty(); }

  /// The labels of an exploration, with the given ones in the place of those with the same name. A
  /// label that was given to another exploration only is "unknown", as all explorations of a
  /// recording have the same labels.
  std::vector<Label> labels(std::size_t exploration, std::vector<Label> own) const;

  /// A copy with these labels.
  Recording apply(const Recording& recording) const;

 private:
  std::map<std::size_t, std::map<std::string, std::string>> given_;
};

}  // namespace somato
