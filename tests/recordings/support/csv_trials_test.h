#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "base/support/temporary_folder.h"
#include "recordings/support/csv_channel.h"
#include "somato/core/matrix.h"
#include "somato/recording/csv_import.h"

namespace somato {

/// Imports of files whose channel touch has the columns a and b.
class CsvTrialsTest : public ::testing::Test {
 protected:
  CsvTrialsTest() {
    plan_.trials.files = "{object}_{trial:number}.csv";
    plan_.channels = {channel_of("touch", {"a", "b"})};
  }

  Result<Recording> import() const { return import_csv_trials(folder_.path(), plan_); }

  /// The only exploration of a folder with this text as its only file.
  Exploration read(const std::string& text) const {
    folder_.with("x_1.csv", text);
    const auto recording = import();
    EXPECT_TRUE(validate(recording.value()));
    return recording.value().explorations.at(0);
  }

  /// The error for it, without the folder.
  std::string error_for(const std::string& text) const {
    folder_.with("x_1.csv", text);
    const auto recording = import();
    if (recording) return "none";
    EXPECT_EQ(recording.error().kind, ErrorKind::kData);
    return to_string(recording.error()).substr(folder_.path().size() + 1);
  }

  static Matrix<float> matrix(std::size_t rows, std::vector<float> values) {
    const std::size_t columns = values.size() / rows;
    return Matrix<float>(rows, columns, std::move(values));
  }

  TemporaryFolder folder_;
  CsvImport plan_;
};

}  // namespace somato
