#include "recordings/file/growing_recording.h"

#include <fmt/format.h>

#include <cerrno>
#include <utility>

#include "base/files/replacement.h"
#include "recordings/explorations/exploration_frames.h"
#include "recordings/explorations/growing_channel.h"
#include "recordings/file/partial_file.h"
#include "recordings/file/recording_layout.h"
#include "recordings/mcap/mcap_records.h"

namespace somato {
namespace {

constexpr double kFlushAfter = 0.25;  // s; half a second is promised

// Counts explorations and does not keep their frames.
class CountingSink final : public FrameSink {
 public:
  std::size_t count() const { return count_; }

  Result<void> begin_exploration(const ExplorationStart&) override { return {}; }
  Result<void> frame(std::size_t, std::span<const float>, double,
                     std::span<const std::uint8_t>) override {
    return {};
  }
  Result<void> end_exploration() override {
    ++count_;
    return {};
  }

 private:
  std::size_t count_ = 0;
};

// The bytes before the first exploration.
std::size_t header_size() {
  return kMcapMagic.size() +
         mcap_record(McapHeader{std::string(kRecordingProfile), "somato"}).size();
}

}  // namespace

Result<std::unique_ptr<GrowingRecording>> GrowingRecording::begin(const std::string& path,
                                                                  Rollover rollover) {
  return begin(operating_system(), path, std::move(rollover));
}

Result<std::unique_ptr<GrowingRecording>> GrowingRecording::begin(FileSystem& files,
                                                                  const std::string& path,
                                                                  Rollover rollover) {
  std::unique_ptr<GrowingRecording> recording(
      new GrowingRecording(files, path, std::move(rollover)));
  SOMATO_TRY_VOID(recording->open());
  return recording;
}

// No file of the same second is replaced.
std::string GrowingRecording::free_path() const {
  constexpr std::size_t kMostCopies = 1000;
  const auto is_free = [&](const std::string& path) {
    const auto file = OpenFile::open(*files_, path, Opening::kRead);
    return !file && file.error() == ENOENT;
  };
  for (std::size_t copy = 1;; ++copy) {
    std::string path = path_at(pattern_, begun_, copy);
    if (path == pattern_ || copy == kMostCopies) return path;
    if (is_free(path) && is_free(partial_path(path))) return path;
  }
}

Result<void> GrowingRecording::open() {
  begun_ = rollover_.time();
  bytes_ = 0;
  path_ = free_path();
  auto opened = open_partial();
  problem_ = opened ? std::nullopt : std::optional(opened.error());
  return opened;
}

Result<void> GrowingRecording::open_partial() {
  if (is_written_directly(path_)) {
    SOMATO_TRY(auto direct, RecordingFile::begin(*files_, path_));
    direct_.emplace(std::move(direct));
    return {};
  }
  // A session does not begin where its file could not be written at the end.
  SOMATO_TRY_VOID(Replacement::begin(*files_, path_).map([](const Replacement&) {}));
  SOMATO_TRY(auto file, create_partial_file(*files_, path_, header_size()));
  RecordingFileParameters parameters;
  parameters.flush_after = kFlushAfter;
  // Many small chunks for a short time: to compress and to decompress them costs as much as all
  // else, and the copy that remains is compressed.
  parameters.compression = Compression::kNone;
  auto writer = RecordingWriter::write_into(std::move(file), partial_path(path_), parameters);
  if (!writer) {
    (void)files_->remove(partial_path(path_));
    return fail(std::move(writer.error()));
  }
  partial_.emplace(std::move(*writer));
  return {};
}

GrowingRecording::~GrowingRecording() {
  if (partial_ && added_.empty() && !draft_) (void)remove_partial();
}

// The next file begins at the next exploration, so that names can be given until then.
Result<void> GrowingRecording::roll() {
  if (added_.empty() || !is_due()) return {};
  std::vector<Label> labels = std::exchange(next_labels_, {});
  SOMATO_TRY_VOID(finish());
  next_labels_ = std::move(labels);
  leave_file();
  return open();
}

void GrowingRecording::leave_file() {
  files_before_ = files();
  before_ = count();
  added_.clear();
  draft_.reset();
  partial_.reset();
}

Result<bool> GrowingRecording::begin_again() {
  if (direct_ || !is_due()) return false;
  next_labels_.clear();  // of the exploration that was lost
  leave_file();
  return open().map([] { return true; });
}

Result<void> GrowingRecording::begin_draft(const ExplorationStart& start) {
  if (problem_) return fail(*problem_);
  if (!partial_) return {};
  SOMATO_TRY_VOID(roll());
  const std::vector<Label> labels = std::exchange(next_labels_, {});
  SOMATO_TRY_VOID(drop_draft());
  SOMATO_TRY_VOID(with_advice(partial_->begin_exploration(start)));
  draft_ = partial_->explorations() - 1;
  next_labels_ = labels;
  return label_next(*draft_);
}

Result<void> GrowingRecording::draft_frame(std::size_t channel, std::span<const float> values,
                                           double time) {
  if (!partial_) return {};
  bytes_ += values.size_bytes() + sizeof(double);
  return with_advice(partial_->frame(channel, values, time));
}

Result<void> GrowingRecording::end_open() {
  return partial_->is_open() ? partial_->end_exploration() : Result<void>();
}

Result<void> GrowingRecording::keep_draft() {
  if (!draft_) {
    return fail(ErrorKind::kUsage, "the exploration was not saved while it took place", path_,
                "write to a file, or explore for a shorter time");
  }
  next_labels_.clear();
  SOMATO_TRY_VOID(with_advice(end_open().and_then([&] { return partial_->synchronize(); })));
  added_.push_back(*std::exchange(draft_, std::nullopt));
  return {};
}

Result<void> GrowingRecording::drop_draft() {
  next_labels_.clear();
  if (!draft_) return {};
  auto dropped = with_advice(end_open().and_then([&] { return partial_->leave_out(*draft_); }));
  if (dropped) draft_.reset();  // else its frames can be recovered
  return dropped;
}

Result<void> GrowingRecording::label_next(std::uint64_t index) {
  for (const Label& label : next_labels_) {
    SOMATO_TRY_VOID(with_advice(partial_->label(index, label)));
  }
  return {};
}

Result<void> GrowingRecording::add(Exploration exploration) {
  if (problem_) return fail(*problem_);
  if (!draft_ && partial_) SOMATO_TRY_VOID(roll());
  Result<void> added = direct_ ? direct_->add(std::move(exploration))
                               : with_advice(add_valid(std::move(exploration)));
  if (added && direct_) added_.push_back(count());
  return added;
}

Result<void> GrowingRecording::add_valid(Exploration exploration) {
  Recording single;
  single.explorations.push_back(std::move(exploration));
  Result<void> added =
      validate(single).and_then([&] { return add_to_partial(single.explorations.front()); });
  if (!added && added.error().kind == ErrorKind::kData) SOMATO_TRY_VOID(drop_draft());
  return added;
}

// The draft is left out after the exploration is there: no moment is without both.
Result<void> GrowingRecording::add_to_partial(const Exploration& exploration) {
  SOMATO_TRY_VOID(end_open());
  const std::uint64_t index = partial_->explorations();
  for (const Channel& channel : exploration.channels) bytes_ += draft_ ? 0 : bytes_of(channel);
  Result<void> handed = hand_frames(exploration, *partial_);
  if (!handed && partial_->is_open()) {
    SOMATO_TRY_VOID(end_open());
    SOMATO_TRY_VOID(partial_->leave_out(index));
  }
  if (!handed) return handed;
  SOMATO_TRY_VOID(label_next(index));
  SOMATO_TRY_VOID(drop_draft());
  SOMATO_TRY_VOID(partial_->synchronize());
  added_.push_back(index);
  return {};
}

Result<void> GrowingRecording::label_at_once(std::uint64_t index, const Label& label) {
  return with_advice(
      partial_->label(index, label).and_then([&] { return partial_->synchronize(); }));
}

Result<void> GrowingRecording::name(std::size_t exploration, const Label& label) {
  if (!partial_) {
    return fail(ErrorKind::kUsage, "this exploration is written already", path_,
                "write to a file, in which names can follow");
  }
  if (exploration < before_) {
    return fail(ErrorKind::kUsage, "this exploration is in an earlier file, which is complete",
                path_, "give a name before the next exploration begins");
  }
  if (exploration < count()) {
    return label_at_once(added_[exploration - before_], label);
  }
  next_labels_.push_back(label);
  return draft_ ? label_at_once(*draft_, label) : Result<void>();
}

Result<void> GrowingRecording::finish() {
  if (problem_) return fail(*problem_);
  if (direct_) return direct_->finish();
  SOMATO_TRY_VOID(drop_draft());
  if (added_.empty()) return remove_partial();
  return with_advice(partial_->close().and_then([&] { return copy(); }).and_then([&] {
           return check_copy();
         }))
      .and_then([&] { return remove_partial(); });
}

// Without drafts, with the labels that were given last, in chunks of the usual size.
Result<void> GrowingRecording::copy() const {
  SOMATO_TRY(auto file, RecordingFile::begin(*files_, path_));
  SOMATO_TRY_VOID(hand_file(*files_, partial_path(path_), file));
  return file.finish();
}

Result<void> GrowingRecording::check_copy() const {
  CountingSink read;
  SOMATO_TRY_VOID(hand_file(*files_, path_, read));
  if (read.count() == added_.size()) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("{} of {} explorations can be read back", read.count(), added_.size()),
              path_);
}

// Another process does not touch the file until then, because it has data.
Result<void> GrowingRecording::remove_partial() {
  const std::string partial = partial_path(path_);
  const Outcome<void> removed =
      files_->remove(partial).and_then([&] { return flush_folder_of(*files_, partial); });
  partial_.reset();
  if (!removed) return system_failure("cannot remove", partial, removed.error());
  return {};
}

// The explorations that were added before are not lost.
Result<void> GrowingRecording::with_advice(Result<void> done) const {
  if (done || done.error().kind != ErrorKind::kSystem || added_.empty()) return done;
  Error& error = done.error();
  if (error.advice.ends_with(recover_command(path_))) return done;
  error.advice += fmt::format(
      "{}{} in {}; afterwards: {}", error.advice.empty() ? "" : "; ",
      added_.size() == 1 ? "1 exploration is" : fmt::format("{} explorations are", added_.size()),
      partial_path(path_), recover_command(path_));
  return done;
}

}  // namespace somato
