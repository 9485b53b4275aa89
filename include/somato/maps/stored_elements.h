#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "somato/core/samples.h"
#include "somato/core/signal.h"

namespace somato {

/// The elements of an input that a map has weights for: all of them, or those of a list. The weight
/// of any other element is 0.
class StoredElements {
 public:
  StoredElements() = default;

  /// All elements of an input of `size` elements.
  explicit StoredElements(std::size_t size) : size_(size) {}

  /// Those of `listed`; throws InvalidArgument unless it is a possible_list().
  StoredElements(std::size_t size, std::vector<std::uint32_t> listed);

  /// Those where a sparse sample holds a value, if they are fewer than half of all; else all. The
  /// first one when there is no value at all.
  static StoredElements used_by(const Samples& samples);

  /// Those of `used`, which ascend, by the same rule.
  static StoredElements worth_storing(std::size_t size, std::vector<std::uint32_t> used);

  /// Whether `listed` is not empty, ascends without repeats and lies below `size`.
  static bool possible_list(std::size_t size, std::span<const std::uint32_t> listed);

  /// Elements of an input.
  std::size_t size() const { return size_; }

  /// How many of them are stored.
  std::size_t count() const { return all() ? size_ : listed_.size(); }

  bool all() const { return listed_.empty(); }

  /// Their numbers, ascending; empty when all are stored.
  std::span<const std::uint32_t> listed() const { return listed_; }

  /// Where `element`, below size(), stands among those that are stored.
  std::optional<std::size_t> place_of(std::size_t element) const;

  /// Writes the stored elements of `signal`, times `factor`, to `out`, which holds count() values.
  /// Returns the squared length of the others, times `factor` as well: above 0 as soon as one of
  /// them is not 0. Throws InvalidArgument when a size differs.
  double gather(const SignalView& signal, std::span<float> out, double factor = 1.0) const;

  /// Samples of size() elements as samples of the stored ones, without the others; sparse ones
  /// become dense unless they are nearly empty. Throws InvalidArgument when the size differs.
  Samples gather(const Samples& samples) const;

  bool operator==(const StoredElements&) const = default;

 private:
  Signal dense_of(const SignalView& signal) const;
  Signal sparse_of(const SignalView& signal) const;

  std::size_t size_ = 0;
  std::vector<std::uint32_t> listed_;
};

}  // namespace somato
