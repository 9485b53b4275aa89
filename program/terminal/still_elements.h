#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "somato/recording/element_ranges.h"

namespace somato::program {

/// Elements of a channel that deserve a look, counted from 0.
struct StillElements {
  std::vector<std::size_t> zero;       ///< Every reading was exactly 0.
  std::vector<std::size_t> unchanged;  ///< Every reading was the same other value.
  std::vector<std::size_t> missing;    ///< Some readings are missing.
  std::uint64_t missing_values = 0;    ///< Their number, for all elements.
  std::size_t elements = 0;            ///< All elements.
};

StillElements still_elements(const std::vector<ElementRange>& elements);

/// The names of those elements, or their numbers from 1 without `names`.
std::vector<std::string> element_names_of(const std::vector<std::size_t>& elements,
                                          const std::vector<std::string>& names);

/// A line that begins with `prefix` for each kind of elements that there are.
std::string text_of(const StillElements& still, const std::vector<std::string>& names,
                    const std::string& prefix);

}  // namespace somato::program
