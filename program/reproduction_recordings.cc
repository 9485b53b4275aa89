#include "reproduction_recordings.h"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "folder_lock.h"
#include "somato/bodies/exploring.h"
#include "somato/files/checksum.h"
#include "somato/files/whole_file.h"
#include "somato/recording/content_hash.h"
#include "somato/recording/recording_file.h"
#include "somato/simulation/engine.h"
#include "study_data.h"
#include "terminal.h"
#include "version.h"

namespace somato::program {
namespace {

Result<ObjectTable> things_for(const ExploreTable& table, bool new_objects) {
  const auto& materials = declared_materials();
  if (new_objects) {
    return lucs3_new_objects(materials).map(
        [](std::vector<Object> objects) { return ObjectTable{std::move(objects), {}}; });
  }
  const std::string& objects = table.explore.objects;
  if (objects.empty()) return default_things(table.explore.body);
  return objects.ends_with(".toml") ? read_object_table(objects, materials)
                                    : own_object_table(objects, materials);
}

Result<void> explore_into(const std::string& path, const Explorer& explorer,
                          const ExploringPlan& plan, const std::string& name) {
  auto file = RecordingFile::begin(path);
  if (!file) return fail(std::move(file.error()));
  const ExploreOptions options{{.goes_on = [] { return !stop_requested(); }}};
  const auto explored = explore_all(
      plan,
      [&](std::size_t thing, std::size_t trial) { return explorer.explore(thing, trial, options); },
      [&](Exploration&& exploration) { return file->add(std::move(exploration)); },
      terminal_progress("exploring " + name));
  if (!explored) {
    Error error = explored.error();
    if (error.kind == ErrorKind::kInterrupted) {
      error.advice = "what is done is kept; the same command goes on from there and explores " +
                     name + " anew";
    }
    return fail(std::move(error));
  }
  if (!explored->failures.empty()) return fail(explored->failures.front().error);
  return file->finish();
}

// Other things under the same path must not find these, nor another engine or version, which may
// move them otherwise. Errors: kSystem.
Result<std::string> file_name(const ExploreTable& table, bool new_objects, std::uint64_t seed) {
  std::string what = to_text(table) + physics_engine() + SOMATO_VERSION;
  if (table.explore.objects.ends_with(".toml")) {
    const auto objects = read_whole(table.explore.objects);
    if (!objects) return fail(objects.error());
    what += *objects;
  }
  return fmt::format("{}{}-{:08x}-{}.mcap", choice_name(table.explore.body),
                     new_objects ? "-new" : "", crc32c(what), seed);
}

PairedRecording paired(std::string name, std::string source, std::uint64_t seed,
                       Recording recording) {
  RecordingInfo info{std::move(name), std::move(source), seed, content_hash(recording),
                     recording.explorations.size()};
  return {std::move(info), std::move(recording), {}};
}

// Of the frames, which are nearly all of it.
std::size_t bytes_of(const Recording& recording) {
  std::size_t bytes = 0;
  for (const Exploration& exploration : recording.explorations) {
    for (const Channel& channel : exploration.channels) {
      bytes += channel.frames.values().size() * sizeof(float);
    }
  }
  return bytes;
}

// The last part of a path, whether it ends with a slash or not.
std::string last_part(const std::filesystem::path& path) {
  const auto whole = std::filesystem::absolute(path).lexically_normal();
  return (whole.has_filename() ? whole : whole.parent_path()).filename().string();
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

KeptRecordings::Kept KeptRecordings::find(const std::string& key) const {
  const auto found = kept_.find(key);
  return found == kept_.end() ? nullptr : found->second;
}

KeptRecordings::Kept KeptRecordings::keep(const std::string& key, PairedRecording recording) {
  constexpr std::size_t kMostBytes = std::size_t{1} << 29;
  const std::size_t bytes = bytes_of(recording.recording);
  auto kept = std::make_shared<const PairedRecording>(std::move(recording));
  if (bytes_ + bytes > kMostBytes) return kept;
  bytes_ += bytes;
  kept_.emplace(key, kept);
  return kept;
}

Result<void> ExploredRecordings::explore(const ExploreTable& table, bool new_objects,
                                         std::uint64_t seed, const std::string& name) const {
  const std::string path = (folder_ / name).string();
  const auto alone = FolderLock::wait(folder_);
  if (!alone) return fail(alone.error());
  std::error_code missing;
  if (std::filesystem::exists(path, missing)) return {};
  auto things = things_for(table, new_objects);
  if (!things) return fail(std::move(things.error()));
  const auto explorer = Explorer::build(table.explore.body, *things, table.exploring, seed);
  if (!explorer) return fail(explorer.error());
  const std::size_t each = new_objects ? 1 : table.explore.explorations;
  return explore_into(path, *explorer, {explorer->things().size(), each, threads_}, name);
}

Result<Recording> ExploredRecordings::explored(const ExploreTable& table, bool new_objects,
                                               std::uint64_t seed, std::string& name) const {
  const auto named = file_name(table, new_objects, seed);
  if (!named) return fail(named.error());
  name = *named;
  const std::string path = (folder_ / name).string();
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    auto done = explore(table, new_objects, seed, name);
    if (!done) return fail(std::move(done.error()));
  }
  return read_recording(path);
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
  std::string name;
  auto recording = explored(table, false, seed, name);
  if (!recording) return fail(std::move(recording.error()));
  const std::string source = recording->explorations.front().source;
  PairedRecording pair = paired(name, source, seed, std::move(*recording));
  if (!table.explore.new_objects) return pair;
  std::string name_of_new;
  auto test = explored(table, true, seed, name_of_new);
  if (!test) return fail(std::move(test.error()));
  pair.test = std::move(*test);
  return pair;
}

Result<GivenRecordings> GivenRecordings::at(const std::filesystem::path& path) {
  GivenRecordings given;
  std::error_code missing;
  if (!std::filesystem::exists(path, missing)) {
    return fail(ErrorKind::kSystem, "there is no such file or folder", path.string(),
                "give --data a recording, a folder of recordings, or data sets");
  }
  given.add(path);
  // A folder of data sets of one kind looks like one of them, but cannot be read as such.
  const bool whole = std::filesystem::is_regular_file(path) ||
                     (!given.places_.empty() && load_recording(given.places_[0].format, path));
  GivenRecordings within;
  if (!whole) {
    for (const auto& entry : sorted_entries(path)) within.add(entry);
  }
  if (!within.places_.empty()) return within;
  if (!given.places_.empty()) return given;
  return fail(ErrorKind::kData, "there are no recordings and no known data sets", path.string(),
              "'somato inspect' tells what a file is; 'somato import' makes recordings of others");
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
    if (is_mcap_file(place.string())) places_.push_back({place, RecordingFormat::kAutomatic});
    return;
  }
  if (auto format = recognize_format(place)) places_.push_back({place, *format});
}

std::vector<std::size_t> GivenRecordings::of_format(RecordingFormat format) const {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < places_.size(); ++i) {
    if (places_[i].format == format) numbers.push_back(i);
  }
  return numbers;
}

Result<KeptRecordings::Kept> GivenRecordings::get(std::size_t number) {
  const std::string key = std::to_string(number);
  if (auto kept = kept_.find(key)) return kept;
  const Place& place = places_[number];
  return read_study_data(place.format, place.path.string()).map([&](Recording recording) {
    return kept_.keep(key, paired(last_part(place.path), "given", 0, std::move(recording)));
  });
}

}  // namespace somato::program
