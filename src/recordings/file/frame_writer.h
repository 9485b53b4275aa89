#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "recordings/file/exploration_log.h"
#include "recordings/mcap/mcap_writer.h"
#include "somato/recording/recording_writer.h"

namespace somato {

/// Writes explorations frame by frame into an MCAP file: what RecordingWriter does, for one thread
/// and without a clock.
class FrameWriter final : public FrameSink {
 public:
  /// `path` is for messages.
  FrameWriter(McapWriter::Sink sink, std::string path, const RecordingFileParameters& parameters)
      : file_(std::move(sink), parameters.compression, parameters.chunk_size),
        log_(file_),
        path_(std::move(path)) {}
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter(FrameWriter&&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  FrameWriter& operator=(FrameWriter&&) = delete;
  ~FrameWriter() override = default;

  Result<void> begin_file();
  Result<void> begin_exploration(const ExplorationStart& start) override;
  Result<void> frame(std::size_t channel, std::span<const float> values, double time,
                     std::span<const std::uint8_t> valid) override;
  Result<void> end_exploration() override { return log_.end(); }
  /// Adds a record about an exploration that has begun, open or not. Throws InvalidArgument if it
  /// has not. Errors: kData for a text that is not UTF-8 or too long; those of the sink.
  Result<void> label(std::uint64_t exploration, const Label& label);
  Result<void> leave_out(std::uint64_t exploration);

  Result<void> end_chunk() { return file_.end_chunk(); }
  Result<void> finish() { return file_.finish(); }

  bool is_open() const { return log_.is_open(); }
  std::uint64_t explorations() const { return explorations_; }
  bool chunk_is_empty() const { return file_.chunk_is_empty(); }

 private:
  struct OpenChannel {
    ChannelDescription description;
    std::uint16_t id = 0;
    std::size_t elements = 0;  // 0: not yet known.
    std::int64_t latest = std::numeric_limits<std::int64_t>::min();
    std::uint32_t frames = 0;
  };

  std::int64_t zero_for(std::int64_t start) const;
  Result<std::vector<std::uint16_t>> open_channels(
      const std::vector<ChannelDescription>& descriptions);
  Result<std::uint64_t> log_time(OpenChannel& channel, double time) const;
  std::span<const float> with_gaps(std::span<const float> values,
                                   std::span<const std::uint8_t> valid);

  McapWriter file_;
  ExplorationLog log_;
  std::string path_;
  std::vector<OpenChannel> channels_;
  std::vector<float> gaps_;
  std::uint64_t explorations_ = 0;
  std::int64_t zero_ = 0;
};

}  // namespace somato
