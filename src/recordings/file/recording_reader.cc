#include "somato/recording/recording_file.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "base/core/memory.h"
#include "recordings/explorations/growing_channel.h"
#include "recordings/explorations/nanoseconds.h"
#include "recordings/file/recording_interpreter.h"
#include "recordings/file/spooled_frames.h"
#include "recordings/mcap/mcap_reader.h"

namespace somato {
namespace {

using Meaning = RecordingInterpreter::Meaning;

}  // namespace

class RecordingReader::Impl {
 public:
  Impl(McapReader file, std::size_t most_memory)
      : file_(std::move(file)), interpreter_(file_), most_memory_(most_memory) {}
  Impl(const Impl&) = delete;
  Impl(Impl&&) = delete;
  Impl& operator=(const Impl&) = delete;
  Impl& operator=(Impl&&) = delete;
  ~Impl() = default;

  Result<std::optional<Exploration>> next() {
    SOMATO_TRY(const bool found, read([&](const Frame& frame) { return collect(frame); }));
    return found ? std::optional(take()) : std::nullopt;
  }

  Result<bool> next(FrameSink& to) {
    SOMATO_TRY(const bool found, read([&](const Frame& frame) {
                 return spooled_.add(frame.channel, frame.values, seconds_of(frame.time),
                                     frame.valid);
               }));
    if (!found) return false;
    return spooled_.hand_over(start(), to).map([] { return true; });
  }

 private:
  using Frame = RecordingInterpreter::Frame;

  // Reads an exploration to its end, or the end of the file, and hands its frames to `take_frame`.
  template <typename TakeFrame>
  Result<bool> read(const TakeFrame& take_frame) {
    while (!done_) {
      Result<bool> found = step(take_frame);
      if (!found) done_ = true;
      if (!found || *found) return found;
    }
    return false;
  }

  // Reads a message; whether an exploration ends with it.
  template <typename TakeFrame>
  Result<bool> step(const TakeFrame& take_frame) {
    SOMATO_TRY(const std::optional<McapMessage> message, file_.next());
    if (!message) return finish();
    SOMATO_TRY(const Meaning meaning, interpreter_.interpret(*message));
    if (meaning == Meaning::kFrame) {
      for (const Frame& frame : interpreter_.frames()) SOMATO_TRY_VOID(take_frame(frame));
    }
    return meaning == Meaning::kEnd;
  }

  Result<void> collect(const Frame& frame) {
    channels_.resize(interpreter_.channels().size());
    SOMATO_TRY_VOID(take_memory(frame));
    add_frame(channels_[frame.channel], frame.values, seconds_of(frame.time), frame.valid);
    return {};
  }

  // A small file can unpack to frames that no machine holds.
  Result<void> take_memory(const Frame& frame) {
    taken_ += frame.values.size() * sizeof(float) + frame.valid.size() + sizeof(double);
    if (taken_ <= most_memory_) return {};
    return fail(ErrorKind::kSystem,
                fmt::format("its frames exceed the available memory of {}",
                            memory_text(static_cast<double>(most_memory_))),
                {}, "use a shorter recording, or a machine with more memory");
  }

  Result<bool> finish() {
    done_ = true;
    SOMATO_TRY_VOID(interpreter_.finish());
    return interpreter_.is_open();
  }

  ExplorationStart start() const {
    ExplorationStart start{
        interpreter_.exploration().labels, interpreter_.exploration().source, {}};
    start.channels.reserve(interpreter_.channels().size());
    for (const InterpretedChannel& channel : interpreter_.channels()) {
      start.channels.push_back(channel.description);
    }
    return start;
  }

  Exploration take() {
    channels_.resize(interpreter_.channels().size());
    Exploration exploration{
        interpreter_.exploration().labels, interpreter_.exploration().source, {}};
    exploration.channels.reserve(channels_.size());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const InterpretedChannel& channel = interpreter_.channels()[i];
      exploration.channels.push_back(
          described(std::exchange(channels_[i], {}), channel.description, channel.elements));
    }
    return exploration;
  }

  McapReader file_;
  RecordingInterpreter interpreter_;
  std::vector<Channel> channels_;  // For next() without a sink.
  SpooledFrames spooled_;          // For next() with one.
  std::size_t most_memory_;
  std::size_t taken_ = 0;  // bytes of all frames so far
  bool done_ = false;
};

RecordingReader::RecordingReader(std::unique_ptr<Impl> state) : impl_(std::move(state)) {}
RecordingReader::RecordingReader(RecordingReader&& other) noexcept = default;
RecordingReader& RecordingReader::operator=(RecordingReader&& other) noexcept = default;
RecordingReader::~RecordingReader() = default;

Result<RecordingReader> RecordingReader::open(const std::string& path, std::size_t most_memory) {
  SOMATO_TRY(McapReader file, McapReader::open(operating_system(), path));
  return RecordingReader(std::make_unique<Impl>(std::move(file), most_memory));
}

Result<RecordingReader> RecordingReader::open(FileSystem& files, const std::string& path) {
  SOMATO_TRY(McapReader file, McapReader::open(files, path));
  return RecordingReader(
      std::make_unique<Impl>(std::move(file), std::numeric_limits<std::size_t>::max()));
}

Result<std::optional<Exploration>> RecordingReader::next() {
  return impl_->next();
}

Result<bool> RecordingReader::next(FrameSink& to) {
  return impl_->next(to);
}

}  // namespace somato
