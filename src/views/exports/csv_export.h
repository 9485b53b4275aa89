#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/files/file_writer.h"
#include "views/exports/new_folder.h"
#include "views/exports/recording_export.h"

namespace somato {

/// A folder with a table NAME.csv for each channel, a row a frame: the number of the exploration
/// from 1, the labels, the time in seconds (empty if unknown), the elements (empty if invalid).
/// Beside it NAME.toml describes the table for import_csv_trials(). Numbers are the shortest that
/// give the same float32, or double for times.
class CsvExport final : public RecordingExport {
 public:
  static Result<std::unique_ptr<RecordingExport>> begin(const std::string& path);

  explicit CsvExport(NewFolder folder) : folder_(std::move(folder)) {}

  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override;
  Result<void> finish() override;

 private:
  struct ChannelTable {
    std::string name;  // The name of its files, without ending.
    FileWriter file;
    ChannelDescription description;
    std::string exploration;  // Names of columns.
    std::string time;
    std::vector<std::string> elements = {};  // Once there is a frame.
    std::string rows = {};                   // Not yet written.
    std::uint64_t frames = 0;                // Belongs to the exploration.
    bool is_time_known = true;
    bool is_rate_constant = true;
    bool has_missing = false;
  };

  Result<void> open_tables(const ExplorationStart& first);
  static void begin_table(ChannelTable& table, std::size_t elements,
                          const std::vector<std::string>& labels);
  std::string description_of_table(const ChannelTable& table) const;

  NewFolder folder_;
  std::vector<std::string> labels_;
  std::vector<ChannelTable> tables_;
  std::vector<ChannelDescription> channels_;  // Belongs to the exploration.
  std::string beginning_;                     // The first fields of each row.
  std::uint64_t explorations_ = 0;
};

}  // namespace somato
