#include "somato/recording/recording_file.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/memory.h"
#include "files/replacement.h"
#include "recording/frame_writer.h"
#include "recording/mcap_input.h"
#include "recording/mcap_reader.h"

namespace somato {
namespace {

ExplorationStart start_of(const Exploration& exploration, const std::vector<PlacedFrame>& frames) {
  ExplorationStart start{exploration.labels, exploration.source, {}, frames.front().time};
  start.channels.reserve(exploration.channels.size());
  for (const Channel& channel : exploration.channels) {
    start.channels.push_back(description_of(channel));
  }
  return start;
}

Result<void> write_exploration(FrameWriter& file, const Exploration& exploration) {
  const std::vector<PlacedFrame> frames = frames_in_time(exploration);
  Result<void> done = file.begin_exploration(start_of(exploration, frames));
  for (const PlacedFrame& placed : frames) {
    if (!done) return done;
    const Channel& channel = exploration.channels[placed.channel];
    const auto valid =
        channel.valid.empty() ? std::span<const std::uint8_t>() : channel.valid.row(placed.frame);
    done = file.frame(placed.channel, channel.frames.row(placed.frame), placed.time, valid);
  }
  return done.and_then([&] { return file.end_exploration(); });
}

}  // namespace

class RecordingFile::Impl {
 public:
  Impl(Replacement file, const std::string& path, const RecordingFileParameters& parameters)
      : file_(std::move(file)),
        writer_([this](std::string_view bytes) { return file_.write(bytes); }, path, parameters) {}

  static Result<std::unique_ptr<Impl>> begin(FileSystem& files, const std::string& path,
                                             const RecordingFileParameters& parameters) {
    SOMATO_TRY(Replacement file, Replacement::begin(files, path));
    auto state = std::make_unique<Impl>(std::move(file), path, parameters);
    SOMATO_TRY_VOID(state->writer_.begin_file());
    return state;
  }

  Result<void> add(const Exploration& exploration) {
    return write_exploration(writer_, exploration);
  }

  Result<void> finish() {
    return writer_.finish().and_then([&] { return file_.commit(); });
  }

 private:
  Replacement file_;
  FrameWriter writer_;
};

RecordingFile::RecordingFile(std::unique_ptr<Impl> state) : impl_(std::move(state)) {}
RecordingFile::RecordingFile(RecordingFile&&) noexcept = default;
RecordingFile& RecordingFile::operator=(RecordingFile&&) noexcept = default;
RecordingFile::~RecordingFile() = default;

Result<RecordingFile> RecordingFile::begin(const std::string& path,
                                           const RecordingFileParameters& parameters) {
  SOMATO_TRY(auto state, Impl::begin(operating_system(), path, parameters));
  return RecordingFile(std::move(state));
}

Result<void> RecordingFile::add(Exploration exploration) {
  Recording single;
  single.explorations.push_back(std::move(exploration));
  return validate(single).and_then([&] { return impl_->add(single.explorations.front()); });
}

Result<void> RecordingFile::finish() {
  return impl_->finish();
}

bool is_mcap(std::string_view bytes) {
  return bytes.starts_with(kMcapMagic);
}

bool is_mcap_file(const std::string& path) {
  Result<McapInput> input = McapInput::open(operating_system(), path);
  if (!input) return false;
  const Result<std::string_view> bytes = input->view(0, kMcapMagic.size());
  return bytes && is_mcap(*bytes);
}

namespace detail {

Result<void> write_recording(FileSystem& files, const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters) {
  Result<void> valid = validate(recording);
  if (!valid) return valid;
  SOMATO_TRY(auto file, RecordingFile::Impl::begin(files, path, parameters));
  for (const Exploration& exploration : recording.explorations) {
    SOMATO_TRY_VOID(file->add(exploration));
  }
  return file->finish();
}

}  // namespace detail

Result<void> write_recording(const std::string& path, const Recording& recording,
                             const RecordingFileParameters& parameters) {
  return detail::write_recording(operating_system(), path, recording, parameters);
}

Result<Recording> read_recording(const std::string& path) {
  // A growing vector temporarily takes three times its size.
  SOMATO_TRY(RecordingReader reader, RecordingReader::open(path, free_memory() / 3));
  Recording recording;
  for (;;) {
    Result<std::optional<Exploration>> exploration = reader.next();
    if (!exploration) {
      if (exploration.error().where.empty()) exploration.error().where = path;
      return fail(std::move(exploration.error()));
    }
    if (!*exploration) return recording;
    recording.explorations.push_back(std::move(**exploration));
  }
}

}  // namespace somato
