#include "somato/recording/recording_writer.h"

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string_view>
#include <thread>
#include <utility>

#include "base/files/open_file.h"
#include "recordings/file/frame_writer.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kLargestChunkSize = std::size_t{1} << 22;
constexpr double kShortestWait = 0.001;
constexpr double kLongestWait = 3600.0;

void check_parameters(const RecordingFileParameters& parameters) {
  require(parameters.chunk_size >= 1 && parameters.chunk_size <= kLargestChunkSize,
          "the size of a chunk is between 1 byte and 4 MiB");
  require(parameters.flush_after >= kShortestWait && parameters.flush_after <= kLongestWait,
          "a chunk is written after 0.001 to 3600 s");
}

}  // namespace

const std::vector<std::pair<Compression, std::string>>& Choices<Compression>::all() {
  static const std::vector<std::pair<Compression, std::string>> choices{
      {Compression::kNone, "none"}, {Compression::kLz4, "lz4"}, {Compression::kZstd, "zstd"}};
  return choices;
}

const Declarations<RecordingFileParameters>& RecordingFileParameters::declarations() {
  using P = RecordingFileParameters;
  static const auto declared =
      Declarations<P>()
          .add("compression", &P::compression, "", Range::any(), "Compression of chunks.")
          .add("chunk_size", &P::chunk_size, "bytes", Range::between(1, kLargestChunkSize),
               "Size at which a chunk is full.")
          .add("flush_after", &P::flush_after, "s", Range::between(kShortestWait, kLongestWait),
               "Age at which a chunk is written out.");
  return declared;
}

// All members are protected by one mutex; the thread only writes old data.
class RecordingWriter::Impl {
 public:
  Impl(OpenFile file, const std::string& path, const RecordingFileParameters& parameters)
      : file_(std::move(file)),
        path_(path),
        flush_after_(std::chrono::duration_cast<Clock::duration>(
            std::chrono::duration<double>(parameters.flush_after))),
        frames_([this](std::string_view bytes) { return write(bytes); }, path, parameters),
        thread_([this] { write_out_what_is_old(); }) {}
  Impl(const Impl&) = delete;
  Impl(Impl&&) = delete;
  Impl& operator=(const Impl&) = delete;
  Impl& operator=(Impl&&) = delete;

  ~Impl() {
    {
      const std::scoped_lock guard(mutex_);
      stop_ = true;
      if (!closed_) (void)frames_.end_chunk();
    }
    changed_.notify_all();
    thread_.join();
  }

  // Runs `write` on the file with its exploration open or not, as it must be.
  template <typename Write>
  Result<void> with(bool open, const Write& write) {
    const std::scoped_lock guard(mutex_);
    require(!closed_, "the recording is closed");
    require(frames_.is_open() == open,
            open ? "no exploration is open" : "an exploration is open already");
    Result<void> written = write(frames_);
    remember_age();
    return written;
  }

  // Runs `write` whether an exploration is open or not.
  template <typename Write>
  Result<void> with_any(const Write& write) {
    const std::scoped_lock guard(mutex_);
    require(!closed_, "the recording is closed");
    Result<void> written = write(frames_);
    remember_age();
    return written;
  }

  template <typename Look>
  auto look(const Look& look) {
    const std::scoped_lock guard(mutex_);
    return look(frames_);
  }

  Result<void> synchronize() {
    return with_any([&](FrameWriter& frames) -> Result<void> {
      SOMATO_TRY_VOID(frames.end_chunk());
      const Outcome<void> flushed = file_.flush();
      if (!flushed) return system_failure("cannot write", path_, flushed.error());
      return {};
    });
  }

  Result<void> close() {
    return with(false, [&](FrameWriter& frames) -> Result<void> {
      closed_ = true;
      Result<void> finished = frames.finish();
      if (!finished) return finished;
      const Outcome<void> closed = file_.flush().and_then([&] { return file_.close(); });
      if (!closed) return system_failure("cannot write", path_, closed.error());
      return {};
    });
  }

 private:
  Result<void> write(std::string_view bytes) {
    const Outcome<void> written = file_.write_all(bytes);
    if (!written) return system_failure("cannot write", path_, written.error());
    return {};
  }

  // The thread has to know when the oldest message came.
  void remember_age() {
    if (frames_.chunk_is_empty()) {
      oldest_.reset();
    } else if (!oldest_) {
      oldest_ = Clock::now();
      changed_.notify_all();
    }
  }

  // A failure is kept by the file and returned by the next call.
  void write_out_what_is_old() {
    std::unique_lock lock(mutex_);
    while (!stop_) {
      if (!oldest_) {
        changed_.wait(lock, [&] { return stop_ || oldest_; });
      } else if (const Clock::time_point then = *oldest_ + flush_after_; Clock::now() < then) {
        changed_.wait_until(lock, then);
      } else {
        oldest_.reset();
        if (!closed_) (void)frames_.end_chunk();
      }
    }
  }

  OpenFile file_;
  std::string path_;
  Clock::duration flush_after_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<Clock::time_point> oldest_;  // The arrival of the oldest message of the chunk.
  bool stop_ = false;
  bool closed_ = false;
  FrameWriter frames_;
  std::thread thread_;  // Last, so that everything it uses is there.
};

RecordingWriter::RecordingWriter(std::unique_ptr<Impl> state) : impl_(std::move(state)) {}
RecordingWriter::RecordingWriter(RecordingWriter&& other) noexcept = default;
RecordingWriter& RecordingWriter::operator=(RecordingWriter&& other) noexcept = default;
RecordingWriter::~RecordingWriter() = default;

Result<RecordingWriter> RecordingWriter::create(FileSystem& files, const std::string& path,
                                                const RecordingFileParameters& parameters) {
  check_parameters(parameters);
  Outcome<OpenFile> file = OpenFile::open(files, path, Opening::kCreate);
  if (!file) return system_failure("cannot create", path, file.error());
  return write_into(std::move(*file), path, parameters);
}

Result<RecordingWriter> RecordingWriter::write_into(OpenFile file, const std::string& path,
                                                    const RecordingFileParameters& parameters) {
  check_parameters(parameters);
  RecordingWriter writer(std::make_unique<Impl>(std::move(file), path, parameters));
  Result<void> begun =
      writer.impl_->with(false, [](FrameWriter& frames) { return frames.begin_file(); });
  if (!begun) return fail(std::move(begun.error()));
  return writer;
}

Result<RecordingWriter> RecordingWriter::create(const std::string& path,
                                                const RecordingFileParameters& parameters) {
  return create(operating_system(), path, parameters);
}

Result<void> RecordingWriter::begin_exploration(const ExplorationStart& start) {
  return impl_->with(false, [&](FrameWriter& frames) { return frames.begin_exploration(start); });
}

Result<void> RecordingWriter::frame(std::size_t channel, std::span<const float> values, double time,
                                    std::span<const std::uint8_t> valid) {
  return impl_->with(
      true, [&](FrameWriter& frames) { return frames.frame(channel, values, time, valid); });
}

Result<void> RecordingWriter::end_exploration() {
  return impl_->with(true, [](FrameWriter& frames) { return frames.end_exploration(); });
}

bool RecordingWriter::is_open() const {
  return impl_->look([](const FrameWriter& frames) { return frames.is_open(); });
}

std::uint64_t RecordingWriter::explorations() const {
  return impl_->look([](const FrameWriter& frames) { return frames.explorations(); });
}

Result<void> RecordingWriter::label(std::uint64_t exploration, const Label& label) {
  return impl_->with_any([&](FrameWriter& frames) { return frames.label(exploration, label); });
}

Result<void> RecordingWriter::leave_out(std::uint64_t exploration) {
  return impl_->with_any([&](FrameWriter& frames) { return frames.leave_out(exploration); });
}

Result<void> RecordingWriter::synchronize() {
  return impl_->synchronize();
}

Result<void> RecordingWriter::close() {
  return impl_->close();
}

}  // namespace somato
