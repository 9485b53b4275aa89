#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/archives/zip_writer.h"
#include "base/files/file_writer.h"
#include "views/exports/recording_export.h"

namespace somato {

/// A file for numpy.load(). With the number N of an exploration from 0: `frames/CHANNEL/N` is
/// float32 of the shape (frames, ...) of the channel, with NaN for invalid elements;
/// `times/CHANNEL/N` is float64 in seconds, absent if unknown. `labels/NAME` has the text of the
/// label of each exploration; `rates/CHANNEL` has the rate in Hz of each exploration, or 0;
/// `unit/CHANNEL` is a text of no dimension; `elements/CHANNEL` has the names of the elements. Its
/// arrays are written as a whole: memory is bounded by one exploration.
class NpzExport final : public WholeExport {
 public:
  static Result<std::unique_ptr<RecordingExport>> begin(const std::string& path);

  explicit NpzExport(FileWriter file)
      : file_(std::move(file)),
        zip_([this](std::string_view bytes) { return file_.write(bytes); }) {}

  Result<void> finish() override;

 private:
  struct ChannelNotes {
    ChannelDescription description;
    std::vector<double> rates;  // One an exploration.
  };
  struct LabelValues {
    std::string name;
    std::vector<std::string> values;  // One an exploration.
  };

  Result<void> add(const Exploration& exploration) override;
  Result<void> add_frames(const Channel& channel);
  Result<void> add_member(const std::string& name, const std::string& bytes);

  FileWriter file_;
  ZipWriter zip_;
  std::vector<ChannelNotes> channels_;
  std::vector<LabelValues> labels_;
  std::uint64_t explorations_ = 0;
};

}  // namespace somato
