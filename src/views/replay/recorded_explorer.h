#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "recordings/explorations/recording_outline.h"
#include "somato/bodies/explorer.h"
#include "somato/recording/recording_file.h"

namespace somato::live {

/// Plays the explorations of a recording file as if a body explored: its steps are their moments.
/// Memory grows neither with the recording nor with an exploration, except for the labels and the
/// numbers of frames. Only the labels of a finished exploration are returned, unless its frames are
/// to be collected, as far as the limits of the exploration permit.
class RecordedExplorer : public Explorer {
 public:
  /// Reads the file once for what its explorations have. Errors: those of RecordingReader; kData
  /// for a recording that validate() refuses, with the exploration.
  static Result<std::unique_ptr<RecordedExplorer>> open(const std::string& path,
                                                        bool collects_frames);

  const RecordingLayout& layout() const { return layout_; }
  std::size_t explorations() const { return outlines_.size(); }

  /// Nothing real moves.
  bool moves_real_body() const override { return false; }

  /// Those of an exploration, whose number is that of the trial. There is one thing.
  std::vector<Label> labels(std::size_t thing, std::size_t trial) const override;

 protected:
  /// The explorations must be played in their order, each once. Errors: those of RecordingReader
  /// and of the observer; kUnavailable if the file has fewer explorations than it had.
  Result<Exploration> explore_thing(std::size_t thing, std::size_t trial,
                                    const ExploreOptions& options) override;

 private:
  RecordedExplorer(const std::string& path, RecordingReader reader, RecordingLayout layout,
                   std::vector<ExplorationOutline> outlines, bool collects_frames);

  RecordingReader reader_;
  RecordingLayout layout_;
  std::vector<ExplorationOutline> outlines_;
  bool collects_frames_;
};

}  // namespace somato::live
