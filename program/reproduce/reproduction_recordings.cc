#include "reproduce/reproduction_recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "base/archives/checksum.h"
#include "base/files/whole_file.h"
#include "recordings/explorations/content_hash.h"
#include "recordings/study_data.h"
#include "reproduce/kept_studies.h"
#include "somato/bodies/exploring.h"
#include "somato/recording/recording_file.h"
#include "somato/simulation/simulated_explorer.h"
#include "terminal/folder_lock.h"
#include "terminal/terminal.h"

namespace somato::program {
namespace {

Result<void> explore_into(const std::string& path, const SimulatedExplorer& explorer,
                          std::size_t each, std::size_t threads, const std::string& name) {
  SOMATO_TRY(auto file, RecordingFile::begin(path));
  const ExploreOptions options{{.should_continue = [] { return !stop_requested(); }}};
  const auto explored = explore_all(
      explorer, {each}, threads, options,
      [&](Exploration&& exploration) { return file.add(std::move(exploration)); },
      terminal_progress("exploring " + name));
  if (!explored) {
    Error error = explored.error();
    if (error.kind == ErrorKind::kInterrupted) {
      error.advice =
          "completed recordings are kept; the same command resumes and explores " + name + " again";
    }
    return fail(std::move(error));
  }
  if (!explored->failures.empty()) return fail(explored->failures.front().error);
  return file.finish();
}

// The name depends on the objects, the engine and the bits that it gives, so that other
// explorations do not use these recordings. Errors: kSystem.
Result<std::string> file_name(const ExploreTable& table, bool new_objects, std::uint64_t seed) {
  std::string what = to_text(table) + physics_engine();
  what += kVersionOfBits;
  if (table.explore.objects.ends_with(".toml")) {
    SOMATO_TRY(const auto objects, read_whole(table.explore.objects));
    what += objects;
  }
  return fmt::format("{}{}-{:08x}-{}.mcap", choice_name(table.explore.body),
                     new_objects ? "-new" : "", crc32c(what), seed);
}

PairedRecording paired(std::string name, std::string source, std::uint64_t seed,
                       Recording recording) {
  RecordingInfo info{std::move(name), std::move(source), seed, content_hash(recording),
                     recording.explorations.size()};
  return {std::move(info), std::move(recording)};
}

// A folder that is locked while a recording is explored; the last process removes it. A process
// that waits for a removed folder finds the recording.
class RecordingLock {
 public:
  explicit RecordingLock(std::filesystem::path path) : path_(std::move(path)) {
    std::error_code exists;
    std::filesystem::create_directory(path_, exists);
  }
  RecordingLock(const RecordingLock&) = delete;
  RecordingLock(RecordingLock&&) = delete;
  RecordingLock& operator=(const RecordingLock&) = delete;
  RecordingLock& operator=(RecordingLock&&) = delete;
  ~RecordingLock() {
    std::error_code gone;
    std::filesystem::remove(path_, gone);
  }

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

// The last part of a path, with or without a final slash.
std::string last_part(const std::filesystem::path& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
}

// The memory of the frames, which is nearly all memory.
std::size_t bytes_of(const Recording& recording) {
  std::size_t bytes = 0;
  for (const Exploration& exploration : recording.explorations) {
    for (const Channel& channel : exploration.channels) {
      bytes += channel.frames.values().size() * sizeof(float);
    }
  }
  return bytes;
}

std::vector<std::filesystem::path> sorted_entries(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> entries;
  std::error_code unreadable;
  for (const auto& entry : std::filesystem::directory_iterator(folder, unreadable)) {
    entries.push_back(entry.path());
  }
  std::sort(entries.begin(), entries.end());
  return entries;
}

}  // namespace

PairedRecording paired_recording(std::string name, std::uint64_t seed, Recording recording) {
  const std::string source = recording.explorations.front().source;
  return paired(std::move(name), source, seed, std::move(recording));
}

Result<PairedRecording> read_given(const RecordingParameters& parameters, const std::string& path) {
  return read_study_data(parameters, path).map([&](Recording recording) {
    return paired(last_part(path), "given", 0, std::move(recording));
  });
}

Result<ObjectTable> explored_things(const ExploreTable& table, bool new_objects) {
  const auto& materials = declared_materials();
  if (new_objects) {
    return lucs3_new_objects(materials).map(
        [](std::vector<Object> objects) { return ObjectTable{std::move(objects), {}}; });
  }
  if (table.things) return *table.things;
  const std::string& objects = table.explore.objects;
  if (objects.empty()) return default_things(table.explore.body);
  return find_object_table(objects, materials);
}

KeptRecordings::Kept KeptRecordings::find(const std::string& key) const {
  const auto found = kept_.find(key);
  return found == kept_.end() ? nullptr : found->second;
}

KeptRecordings::Kept KeptRecordings::keep(const std::string& key, PairedRecording recording) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 29;
  const std::size_t bytes = bytes_of(recording.recording);
  auto kept = std::make_shared<const PairedRecording>(std::move(recording));
  if (bytes_ + bytes > kMostBytes) {
    kept_.clear();
    bytes_ = 0;
  }
  bytes_ += bytes;
  kept_.emplace(key, kept);
  return kept;
}

Result<void> ExploredRecordings::explore(const ExploreTable& table, bool new_objects,
                                         std::uint64_t seed, const std::string& name) const {
  const std::string path = (folder_ / name).string();
  const RecordingLock own_folder(folder_ / ("." + name + ".lock"));
  SOMATO_TRY([[maybe_unused]] const auto lock, FolderLock::wait(own_folder.path()));
  std::error_code missing;
  if (std::filesystem::exists(path, missing)) return {};
  SOMATO_TRY(auto things, explored_things(table, new_objects));
  SOMATO_TRY(const auto explorer,
             simulated_explorer(table.explore.body, things, table.exploring, seed));
  const std::size_t each = new_objects ? 1 : table.explore.explorations;
  return explore_into(path, *explorer, each, threads_, name);
}

Result<std::string> ExploredRecordings::path(const ExploreTable& table, bool new_objects,
                                             std::uint64_t seed) const {
  return file_name(table, new_objects, seed).map([&](const std::string& name) {
    return (folder_ / name).string();
  });
}

Result<void> ExploredRecordings::explore_missing(const ExploreTable& table, bool new_objects,
                                                 std::uint64_t seed) const {
  SOMATO_TRY(const auto name, file_name(table, new_objects, seed));
  std::error_code missing;
  if (std::filesystem::exists(folder_ / name, missing)) return {};
  return explore(table, new_objects, seed, name);
}

Result<void> ExploredRecordings::remove(const ExploreTable& table, std::size_t index) const {
  for (const bool new_objects : {false, true}) {
    SOMATO_TRY(const auto file, path(table, new_objects, first_seed_ + index));
    std::error_code gone;
    std::filesystem::remove(file, gone);
  }
  return {};
}

Result<PairedRecording> ExploredRecordings::explored(const ExploreTable& table, bool new_objects,
                                                     std::uint64_t seed) const {
  SOMATO_TRY_VOID(explore_missing(table, new_objects, seed));
  SOMATO_TRY(const auto name, file_name(table, new_objects, seed));
  return read_recording((folder_ / name).string()).map([&](Recording recording) {
    return paired_recording(name, seed, std::move(recording));
  });
}

Result<std::string> ExploredRecordings::identity(const ExploreTable& table,
                                                 std::size_t index) const {
  return file_name(table, table.explore.new_objects, first_seed_ + index)
      .map([&](const std::string& name) { return to_text(table) + name; });
}

Result<KeptRecordings::Kept> ExploredRecordings::get(const ExploreTable& table, std::size_t index) {
  const std::uint64_t seed = first_seed_ + index;
  const std::string key = fmt::format("{} {}", seed, to_text(table));
  if (auto kept = kept_.find(key)) return kept;
  return read(table, seed).map([&](PairedRecording recording) {
    return kept_.keep(key, std::move(recording));
  });
}

Result<PairedRecording> ExploredRecordings::read(const ExploreTable& table,
                                                 std::uint64_t seed) const {
  auto recording = explored(table, false, seed);
  if (!recording || !table.explore.new_objects) return recording;
  auto test = explored(table, true, seed);
  if (!test) return test;
  recording->test = std::make_shared<const PairedRecording>(std::move(*test));
  return recording;
}

Result<GivenRecordings> GivenRecordings::at(const std::filesystem::path& path) {
  GivenRecordings given;
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    return fail(ErrorKind::kSystem, "there is no such file or folder", path.string(),
                "use --data with a recording, a folder of recordings, or data sets");
  }
  given.add(path);
  // A folder of data sets of one kind has the same structure as one of them, but cannot be read as
  // such.
  const bool whole = std::filesystem::is_regular_file(path) ||
                     (!given.places_.empty() && load_recording(given.places_[0].parameters, path));
  GivenRecordings within;
  if (!whole) {
    for (const auto& entry : sorted_entries(path)) within.add(entry);
  }
  if (!within.places_.empty()) return within;
  if (!given.places_.empty()) return given;
  return fail(
      ErrorKind::kData, "no recordings or known data sets were found", path.string(),
      "'somato inspect' identifies a file; 'somato import' converts other files to recordings");
}

GivenRecordings GivenRecordings::one(const std::filesystem::path& path,
                                     RecordingParameters parameters) {
  GivenRecordings given;
  given.places_.push_back({path, std::move(parameters)});
  return given;
}

GivenRecordings GivenRecordings::files_in(const std::filesystem::path& folder) {
  GivenRecordings given;
  for (const auto& entry : sorted_entries(folder)) {
    if (std::filesystem::is_regular_file(entry)) given.add(entry);
  }
  return given;
}

void GivenRecordings::add(const std::filesystem::path& place) {
  if (std::filesystem::is_regular_file(place)) {
    if (is_mcap_file(place.string())) places_.push_back({place, {}});
    return;
  }
  const auto format = recognize_format(place);
  if (format) places_.push_back({place, {.format = *format}});
}

std::vector<std::size_t> GivenRecordings::of_format(RecordingFormat format) const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].parameters.format == format) numbers.push_back(i);
  }
  return numbers;
}

Result<KeptRecordings::Kept> GivenRecordings::get(std::size_t number) {
  const std::string key = std::to_string(number);
  if (auto kept = kept_.find(key)) return kept;
  const Place& place = places_[number];
  return read_given(place.parameters, place.path.string()).map([&](PairedRecording recording) {
    return kept_.keep(key, std::move(recording));
  });
}

}  // namespace somato::program
