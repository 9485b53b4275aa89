#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "maps/reading/sample_reader.h"
#include "somato/graph/som_model.h"

namespace somato::program {

/// The text of the winners of rows: a CSV table, or a list of JSON objects.
class WinnerFormat {
 public:
  /// Refers to the model.
  WinnerFormat(const SomModel& model, bool is_json);

  /// The text before the first row.
  std::string begin() const;

  /// The text of rows, of which the first has the number `first`, from 0; formatted on `threads`
  /// threads. The readings need distances and, if the model has labels, the nearest neurons with
  /// one.
  std::vector<std::string> rows(const SampleReadings& readings, std::size_t first,
                                std::size_t threads) const;

  /// The text after the last row.
  std::string end() const;

 private:
  void append(const SampleReadings& readings, std::size_t i, std::size_t number,
              std::string& text) const;

  const SomModel& model_;
  bool is_json_;
  std::vector<std::string> labels_;  // as they are written after a row, of each class
};

}  // namespace somato::program
