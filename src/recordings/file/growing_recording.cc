#include "recordings/file/growing_recording.h"

#include <fmt/format.h>

#include <utility>

#include "base/files/replacement.h"
#include "recordings/explorations/exploration_frames.h"
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

Result<std::unique_ptr<GrowingRecording>> GrowingRecording::begin(const std::string& path) {
  return begin(operating_system(), path);
}

Result<std::unique_ptr<GrowingRecording>> GrowingRecording::begin(FileSystem& files,
                                                                  const std::string& path) {
  std::unique_ptr<GrowingRecording> recording(new GrowingRecording(files, path));
  if (is_written_directly(path)) {
    SOMATO_TRY(auto direct, RecordingFile::begin(files, path));
    recording->direct_.emplace(std::move(direct));
    return recording;
  }
  // A session does not begin where its file could not be written at the end.
  SOMATO_TRY_VOID(Replacement::begin(files, path).map([](const Replacement&) {}));
  SOMATO_TRY(auto file, create_partial_file(files, path, header_size()));
  RecordingFileParameters parameters;
  parameters.flush_after = kFlushAfter;
  // Many small chunks for a short time: to compress and to decompress them costs as much as all
  // else, and the copy that remains is compressed.
  parameters.compression = Compression::kNone;
  auto writer = RecordingWriter::write_into(std::move(file), partial_path(path), parameters);
  if (!writer) {
    (void)files.remove(partial_path(path));
    return fail(std::move(writer.error()));
  }
  recording->partial_.emplace(std::move(*writer));
  return recording;
}

GrowingRecording::~GrowingRecording() {
  if (partial_ && count() == 0 && !draft_) (void)remove_partial();
}

Result<void> GrowingRecording::begin_draft(const ExplorationStart& start) {
  if (!partial_) return {};
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
  return with_advice(partial_->frame(channel, values, time));
}

Result<void> GrowingRecording::end_open() {
  return partial_->is_open() ? partial_->end_exploration() : Result<void>();
}

Result<void> GrowingRecording::drop_draft() {
  next_labels_.clear();
  if (!draft_) return {};
  const std::uint64_t draft = *std::exchange(draft_, std::nullopt);
  return with_advice(end_open().and_then([&] { return partial_->leave_out(draft); }));
}

Result<void> GrowingRecording::label_next(std::uint64_t index) {
  for (const Label& label : next_labels_) {
    SOMATO_TRY_VOID(with_advice(partial_->label(index, label)));
  }
  return {};
}

Result<void> GrowingRecording::add(Exploration exploration) {
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

Result<void> GrowingRecording::name(std::size_t exploration, const Label& label) {
  if (!partial_) {
    return fail(ErrorKind::kUsage, "this exploration is written already", path_,
                "write to a file, in which names can follow");
  }
  if (exploration < count()) {
    return with_advice(partial_->label(added_[exploration], label).and_then([&] {
      return partial_->synchronize();
    }));
  }
  next_labels_.push_back(label);
  return draft_ ? with_advice(partial_->label(*draft_, label)) : Result<void>();
}

Result<void> GrowingRecording::finish() {
  if (direct_) return direct_->finish();
  SOMATO_TRY_VOID(drop_draft());
  if (count() == 0) return remove_partial();
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
  if (read.count() == count()) return {};
  return fail(ErrorKind::kSystem,
              fmt::format("{} of {} explorations can be read back", read.count(), count()), path_);
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
      added_.size() == 1 ? "1 exploration is" : fmt::format("{} explorations are", count()),
      partial_path(path_), recover_command(path_));
  return done;
}

}  // namespace somato
