#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "somato/core/result.h"

namespace somato {

/// Puts the values of frames that name their elements into one order: that of the selected names,
/// or of the first frame. Frames that come with the same names in the same order, as most do, are
/// recognized by a key, so that their names are looked up once.
class ElementOrder {
 public:
  /// Keeps the elements with these names, in this order; none: all elements of the first frame.
  explicit ElementOrder(std::vector<std::string> selected = {})
      : names_(std::move(selected)), is_selection_(!names_.empty()) {}

  /// The names of the elements in their order; none before the first frame without a selection.
  const std::vector<std::string>& names() const { return names_; }

  /// Whether the latest frame had this key.
  bool is_known(std::string_view key) const { return is_begun_ && key == key_; }

  /// Learns the order of the elements of a frame. Equal keys must mean equal names. Errors (kData):
  /// names that are not those of the first frame, unless they were selected; a name that the frame
  /// has twice, unless the first frame has the same names in the same order. The order is unchanged
  /// then.
  Result<void> learn(std::string_view key, const std::vector<std::string>& names);

  /// Puts the values of a frame, whose names were learned last, into the order. Returns whether the
  /// frame has all elements of a selection; otherwise `values` is empty.
  bool place(std::vector<double>& values) const;

  /// The names of elements in the frames so far, up to 1000, for messages.
  std::vector<std::string> known_names() const { return {known_.begin(), known_.end()}; }

 private:
  Result<std::optional<std::vector<std::size_t>>> places_in(
      const std::vector<std::string>& names) const;

  std::vector<std::string> names_;
  bool is_selection_;
  bool is_begun_ = false;
  std::string key_;
  std::set<std::string> known_;
  std::vector<std::size_t> places_;  // In the frame, of each of names_; empty: in order.
  bool has_all_ = false;
};

}  // namespace somato
