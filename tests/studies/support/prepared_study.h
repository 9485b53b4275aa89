#pragma once

#include <string>
#include <vector>

#include "studies/folds/prepared_study.h"

namespace somato::testing {

/// A label of samples that are separate individuals; its classes have one letter per sample.
inline StudiedLabel letter_label(const std::string& name, const std::string& letters) {
  StudiedLabel label{name, {}, {}};
  std::vector<std::string> names;
  for (const char letter : letters) {
    label.individuals.push_back(names.size());
    names.emplace_back(1, letter);
  }
  label.classes = Classes::from_names(names);
  return label;
}

/// A study with so many samples as the labels have.
inline PreparedStudy study_of(const std::vector<StudiedLabel>& labels) {
  PreparedStudy prepared;
  prepared.labels = labels;
  prepared.samples.samples = labels.front().classes.of_sample.size();
  return prepared;
}

}  // namespace somato::testing
