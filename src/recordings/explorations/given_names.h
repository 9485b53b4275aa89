#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "somato/recording/recording.h"

namespace somato {

/// A label that an exploration was given, and the value that it had been given before.
struct GivenName {
  std::size_t exploration = 0;
  Label label;
  std::optional<std::string> before;
};

/// Labels that viewers gave to explorations, such as the name of what was touched. They stand
/// beside the recording, which other threads may read.
class GivenNames {
 public:
  /// Gives a label to the exploration with that index, which may not have ended yet. The same value
  /// again changes nothing.
  void give(std::size_t exploration, const Label& label);

  /// The label that was given last and can be taken back, or nullptr.
  const GivenName* last() const { return order_.empty() ? nullptr : &order_.back(); }

  /// Takes back last(), which exists: the exploration has the value that it was given before, or
  /// none. The label remains one of all explorations.
  void take_back();

  /// Forgets what was given to an exploration that was discarded.
  void forget(std::size_t exploration);

  /// Forgets what was given to the explorations before `first`, which are no longer kept. Their
  /// labels remain names of labels of all explorations.
  void forget_before(std::size_t first);

  /// The value of the label that was given to an exploration, or nothing.
  std::optional<std::string> given(std::size_t exploration, const std::string& label) const;

  bool empty() const { return given_.empty() && forgotten_.empty(); }

  /// The labels of an exploration, with the given ones in the place of those with the same name. A
  /// label that was given to another exploration only is "unknown", as all explorations of a
  /// recording have the same labels.
  std::vector<Label> labels(std::size_t exploration, std::vector<Label> own) const;

  /// A copy with these labels; the first of its explorations has the index `first`.
  Recording apply(const Recording& recording, std::size_t first = 0) const;

 private:
  std::map<std::size_t, std::map<std::string, std::string>> given_;
  std::set<std::string> forgotten_;  // names of labels that were given and are no longer kept
  std::vector<GivenName> order_;     // in which they were given
};

}  // namespace somato
