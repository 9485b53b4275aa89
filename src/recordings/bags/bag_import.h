#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "recordings/bags/bag_description.h"
#include "somato/core/result.h"
#include "somato/recording/frame_sink.h"
#include "somato/recording/recording.h"

namespace somato {

/// Messages of a topic that are in no channel, and why.
struct LeftOutTopic {
  std::string topic;
  std::string type;
  std::uint64_t messages = 0;
  std::string reason;
};

/// The outcome of an import of bags.
struct BagImportReport {
  std::size_t explorations = 0;
  Exploration first;                 ///< The first exploration, with one frame of each channel.
  std::uint64_t frames_outside = 0;  ///< Frames outside of all explorations.
  std::vector<LeftOutTopic> left_out;
  std::vector<std::string> remarks;  ///< How bags differ from their descriptions.
};

/// Reads the bags at `path` (see find_bags()) and hands their explorations to `to`, one after the
/// other; memory grows neither with the bags nor with an exploration, whose frames wait in
/// SpooledFrames until its labels are known. Ends with an error (kInterrupted) when
/// `should_continue` returns false. Without a description of channels, all topics of
/// known types are channels, named as in RecordingReader.
///
/// A bag is one exploration, unless the description cuts it. Times are relative to the first frame
/// of the exploration. Labels come from the name of the bag, the span and the description, in this
/// order. The source is the path of the bag.
///
/// Errors: those of find_bags(), open_bag(), read_span_table() and `to`; kUsage for topics that do
/// not exist and fields that their type does not have; kData with bag, topic and time for messages
/// that cannot be decoded, frames with other elements (see ElementOrder), clocks that are set back
/// or jump between times of the calendar and others (unless the description permits it), stamps of
/// 0, labels without a message, channels without frames, explorations with other channels or labels
/// than the first one.
Result<BagImportReport> import_bags(const std::filesystem::path& path, const BagImport& description,
                                    FrameSink& to, const std::function<bool()>& should_continue);

}  // namespace somato
