#include "somato/recording/recording_file.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "core/memory.h"
#include "recording/collected_channel.h"
#include "recording/mcap_reader.h"
#include "recording/nanoseconds.h"
#include "recording/recording_interpreter.h"

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
    while (!done_) {
      Result<std::optional<Exploration>> found = step();
      if (!found) done_ = true;
      if (!found || *found) return found;
    }
    return std::optional<Exploration>();
  }

 private:
  // Reads a message; an exploration if that was its last.
  Result<std::optional<Exploration>> step() {
    SOMATO_TRY(const std::optional<McapMessage> message, file_.next());
    if (!message) return finish();
    SOMATO_TRY(const Meaning meaning, interpreter_.interpret(*message));
    if (meaning == Meaning::kBegin) channels_.assign(interpreter_.channels().size(), {});
    if (meaning == Meaning::kFrame) {
      channels_.resize(interpreter_.channels().size());
      for (const RecordingInterpreter::Frame& frame : interpreter_.frames()) {
        SOMATO_TRY_VOID(take_memory(frame));
        channels_[frame.channel].add(frame.values, frame.valid, seconds_of(frame.time));
      }
    }
    if (meaning == Meaning::kEnd) return take();
    return std::optional<Exploration>();
  }

  // A small file can unpack to frames that no machine holds.
  Result<void> take_memory(const RecordingInterpreter::Frame& frame) {
    taken_ += frame.values.size() * sizeof(float) + frame.valid.size() + sizeof(double);
    if (taken_ <= most_memory_) return {};
    return fail(ErrorKind::kSystem,
                fmt::format("its frames exceed the available memory of {}",
                            memory_text(static_cast<double>(most_memory_))),
                {}, "use a shorter recording, or a machine with more memory");
  }

  Result<std::optional<Exploration>> finish() {
    done_ = true;
    SOMATO_TRY_VOID(interpreter_.finish());
    return interpreter_.is_open() ? take() : std::nullopt;
  }

  std::optional<Exploration> take() {
    Exploration exploration{
        interpreter_.exploration().labels, interpreter_.exploration().source, {}};
    exploration.channels.reserve(channels_.size());
    for (std::size_t i = 0; i < channels_.size(); ++i) {
      const InterpretedChannel& channel = interpreter_.channels()[i];
      exploration.channels.push_back(channels_[i].take(channel.description, channel.elements));
    }
    return exploration;
  }

  McapReader file_;
  RecordingInterpreter interpreter_;
  std::vector<CollectedChannel> channels_;
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

Result<std::optional<Exploration>> RecordingReader::next() {
  return impl_->next();
}

}  // namespace somato
