#pragma once

#include <string>
#include <vector>

#include "base/archives/archive.h"
#include "maps/support/random_maps.h"
#include "somato/maps/som_training.h"
#include "somato/maps/t_mpsom.h"

namespace somato::testing {

/// A trained map of that kind for inputs of `features` elements.
inline Som trained_som(const Variant& variant, std::size_t features, Random& random) {
  SomParameters parameters = random_parameters(variant, random);
  parameters.iterations = 40;
  return train_som(parameters, random_samples(9, features, false, random)).value();
}

/// Parameters of a small T-MPSOM whose three inputs share two axes.
inline TMpsomParameters small_t_mpsom_parameters() {
  TMpsomParameters parameters;
  parameters.shape = {3, 2};
  parameters.input_sizes = {4, 3, 1};
  parameters.input_axes = {1, 0, 0};
  parameters.combination = TMpsomCombination::kAdded;
  parameters.arbor_sigma = 0.7;
  parameters.learning_rate_start = 0.1 + 0.2;
  parameters.weight_norm = TMpsomNorm::kNone;
  parameters.iterations = 77;
  parameters.seed = (std::uint64_t{1} << 60) + 1;
  return parameters;
}

/// The archive without, or with other content in, one of its parts.
inline Archive without_part(const Archive& archive, const std::string& name) {
  Archive changed(archive.kind());
  for (const Archive::Entry& entry : archive.entries()) {
    if (entry.name != name) changed.add(entry.name, entry.content);
  }
  return changed;
}
inline Archive with_part(const Archive& archive, const std::string& name,
                         Archive::Content content) {
  Archive changed = without_part(archive, name);
  changed.add(name, std::move(content));
  return changed;
}

/// `text` with the line of `key` replaced by `line`.
inline std::string with_line(const std::string& text, const std::string& key,
                             const std::string& line) {
  const std::size_t start = ("\n" + text).find("\n" + key + " =");
  if (start == std::string::npos) throw std::invalid_argument("there is no " + key);
  std::string changed = text;
  return changed.replace(start, text.find('\n', start) - start, line);
}

}  // namespace somato::testing
