#include "somato/recording/recording_file.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "base/core/memory.h"
#include "base/files/replacement.h"
#include "recordings/explorations/exploration_frames.h"
#include "recordings/file/frame_writer.h"
#include "recordings/mcap/mcap_input.h"
#include "recordings/mcap/mcap_reader.h"
#include "somato/core/check.h"

namespace somato {
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

  FrameWriter& writer() { return writer_; }

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
  return begin(operating_system(), path, parameters);
}

Result<RecordingFile> RecordingFile::begin(FileSystem& files, const std::string& path,
                                           const RecordingFileParameters& parameters) {
  SOMATO_TRY(auto state, Impl::begin(files, path, parameters));
  return RecordingFile(std::move(state));
}

Result<void> RecordingFile::begin_exploration(const ExplorationStart& start) {
  require(!impl_->writer().is_open(), "an exploration is open already");
  return impl_->writer().begin_exploration(start);
}

Result<void> RecordingFile::frame(std::size_t channel, std::span<const float> values, double time,
                                  std::span<const std::uint8_t> valid) {
  require(impl_->writer().is_open(), "no exploration is open");
  return impl_->writer().frame(channel, values, time, valid);
}

Result<void> RecordingFile::end_exploration() {
  require(impl_->writer().is_open(), "no exploration is open");
  return impl_->writer().end_exploration();
}

Result<void> RecordingFile::add(Exploration exploration) {
  Recording single;
  single.explorations.push_back(std::move(exploration));
  return validate(single).and_then([&] { return hand_frames(single.explorations.front(), *this); });
}

Result<void> RecordingFile::finish() {
  require(!impl_->writer().is_open(), "an exploration is open");
  return impl_->finish();
}

bool is_mcap(std::string_view bytes) {
  return mcap_version(bytes).has_value();
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
    SOMATO_TRY_VOID(hand_frames(exploration, file->writer()));
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
