#include "somato/recording/recover_recording.h"

#include <fmt/format.h>

#include <map>
#include <optional>
#include <utility>

#include "base/files/replacement.h"
#include "recordings/file/exploration_log.h"
#include "recordings/file/recording_interpreter.h"
#include "recordings/mcap/mcap_reader.h"
#include "recordings/mcap/mcap_writer.h"

namespace somato {
namespace {

using Meaning = RecordingInterpreter::Meaning;

constexpr std::size_t kMostPlaces = 10;  // Maximum number reported.

class Recovery {
 public:
  Recovery(McapReader& from, McapWriter::Sink sink, const RecordingFileParameters& parameters)
      : from_(&from),
        meanings_(from),
        to_(std::move(sink), parameters.compression, parameters.chunk_size),
        log_(to_) {}

  Result<RecoveryReport> run() {
    Result<void> done = to_.begin(from_->header());
    bool more = true;
    while (done && more) {
      SOMATO_TRY(const bool stepped, step());
      more = stepped;
    }
    if (done && log_.is_open()) done = end(false);
    if (done && report_.messages == 0 && !report_.lossless) done = nothing_saved();
    if (done) done = to_.finish();
    if (!done) return fail(std::move(done.error()));
    if (meanings_.is_foreign()) ++report_.explorations;
    return report_;
  }

 private:
  // Whether there is more to come.
  Result<bool> step() {
    const Result<std::optional<McapMessage>> message = from_->next();
    if (!message) return go_on(message.error());
    if (!*message) return false;
    const Result<Meaning> meaning = interpret(**message);
    const bool is_of_other_program = !meaning && meanings_.is_unfit();
    if (!meaning && !is_of_other_program) {
      lose(meaning.error());
      return true;
    }
    Result<void> written = write(is_of_other_program ? Meaning::kNothing : *meaning, **message);
    if (!written && written.error().kind == ErrorKind::kData) {
      lose(written.error());
      return true;
    }
    return written.map([] { return true; });
  }

  // A jump in the numbers of explorations indicates a gap that was not detected otherwise.
  Result<Meaning> interpret(const McapMessage& message) {
    Result<Meaning> meaning = meanings_.interpret(message);
    if (meaning || !is_exploration_schema(from_->schema_of(message.channel_id))) return meaning;
    lose(meaning.error());
    meanings_.after_gap();
    return meanings_.interpret(message);
  }

  Result<bool> go_on(const Error& damage) {
    if (damage.kind != ErrorKind::kData) return fail(damage);
    if (from_->has_all_messages()) {
      report(damage);
      return false;
    }
    Result<bool> more = from_->go_on();
    if (more && *more && from_->continues_without_gap()) return more;
    lose(damage);
    meanings_.after_gap();
    return more;
  }

  void report(const Error& damage) {
    ++report_.damaged_places;
    if (report_.damage.size() < kMostPlaces) report_.damage.push_back(damage);
  }

  void lose(const Error& damage) {
    report(damage);
    report_.lossless = false;
    complete_ = false;
  }

  Result<void> nothing_saved() const {
    Error error = report_.damage.front();
    error.what = fmt::format("nothing can be recovered: {}", error.what);
    error.advice = "use a backup copy";
    return fail(std::move(error));
  }

  Result<void> write(Meaning meaning, const McapMessage& message) {
    if (meaning == Meaning::kBegin) return begin(message);
    if (meaning == Meaning::kContinue || meaning == Meaning::kLeftOut) return {};
    if (meaning == Meaning::kEnd) return end(true);
    McapMessage copy = message;
    SOMATO_TRY(const std::uint16_t id, id_of(message.channel_id));
    copy.channel_id = id;
    return log_.add(copy).map([&] { ++report_.messages; });
  }

  Result<void> begin(const McapMessage& message) {
    Result<void> ended = log_.is_open() ? end(false) : Result<void>();
    if (!ended) return ended;
    std::vector<std::uint16_t> ids;
    for (const std::string& name : meanings_.exploration().channels) {
      const McapChannel* announced = from_->latest(topic_of(name));
      if (!announced) continue;
      SOMATO_TRY(const std::uint16_t id, id_of(announced->id));
      ids.push_back(id);
    }
    complete_ = meanings_.exploration().event == ExplorationMessage::Event::kBegin;
    ExplorationMessage begun = meanings_.exploration();
    begun.index = report_.explorations++;
    return log_.begin(std::move(begun), std::move(ids), message.log_time);
  }

  Result<void> end(bool has_end) {
    if (!has_end || !complete_) ++report_.incomplete;
    complete_ = true;
    return log_.end();
  }

  // The channel in the new file.
  Result<std::uint16_t> id_of(std::uint16_t id) {
    const auto known = ids_.find(id);
    if (known != ids_.end()) return known->second;
    const McapSchema& schema = from_->schema_of(id);
    Result<std::uint16_t> made =
        to_.channel(schema.id == 0 ? nullptr : &schema, from_->channel(id));
    if (made) ids_.emplace(id, *made);
    return made;
  }

  McapReader* from_;
  RecordingInterpreter meanings_;
  McapWriter to_;
  ExplorationLog log_;
  RecoveryReport report_;
  std::map<std::uint16_t, std::uint16_t> ids_;
  bool complete_ = true;  // The open exploration, so far.
};

}  // namespace

namespace detail {

Result<RecoveryReport> recover_recording(FileSystem& files, const std::string& from,
                                         const std::string& to,
                                         const RecordingFileParameters& parameters) {
  SOMATO_TRY(McapReader reader, McapReader::open(files, from));
  SOMATO_TRY(Replacement file, Replacement::begin(files, to));
  Recovery recovery(reader, [&](std::string_view bytes) { return file.write(bytes); }, parameters);
  Result<RecoveryReport> report = recovery.run();
  if (!report) return report;
  SOMATO_TRY_VOID(file.commit());
  return report;
}

}  // namespace detail

Result<RecoveryReport> recover_recording(const std::string& from, const std::string& to,
                                         const RecordingFileParameters& parameters) {
  return detail::recover_recording(operating_system(), from, to, parameters);
}

}  // namespace somato
