#include "reproduce/stock.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/archives/checksum.h"
#include "base/files/toml_file.h"
#include "base/text/text.h"
#include "bodies/sensors/sensor_parameters.h"
#include "bodies/sensors/stocked_exploration.h"
#include "somato/simulation/sense.h"

namespace somato::program {
namespace {

bool is_explored(const std::string& key) {
  return key.starts_with("explore.");
}

// Whether sense() gives it another value: explore.simulation.NAME, or a key of a probe.
bool is_of_sensor(const std::string& key) {
  const std::vector<std::string> names = split(key, '.');
  if (names.size() != 3 || names[2] == "true_values") return false;
  constexpr std::string_view kTables[] = {"simulation", "texture_probe", "hardness_probe"};
  const auto& known = sensor_parameters();
  return std::ranges::find(kTables, names[1]) != std::end(kTables) &&
         std::any_of(known.begin(), known.end(),
                     [&](const ParameterInfo& info) { return info.name == names[2]; });
}

bool changes_what_is_explored(const Unknown& unknown) {
  const auto& keys = unknown.parameters.key;
  return std::any_of(keys.begin(), keys.end(),
                     [](const std::string& key) { return is_explored(key) && !is_of_sensor(key); });
}

bool is_only_of_sensors(const Unknown& unknown) {
  const auto& keys = unknown.parameters.key;
  return std::all_of(keys.begin(), keys.end(), is_of_sensor);
}

Table without(const Table& table, std::string_view name) {
  Table rest = table;
  std::erase_if(rest.entries, [&](const Table::Entry& entry) { return entry.name == name; });
  return rest;
}

// The same exploration with a single object, whose name does not tell which.
Table with_object(const Table& explore, const Table::Entry& object) {
  Table single = without(without(explore, "object"), "new_objects");
  Table::Entry only = object;
  only.name = "object";
  single.entries.push_back({"object", object.where, Table{object.where, {std::move(only)}}});
  return single;
}

// Objects differ in their placement and in what the servos do, as if they were explored one after
// the other.
std::uint64_t seed_of_object(std::uint64_t seed, const ExploreTable& table) {
  return seed ^ (static_cast<std::uint64_t>(crc32c(table.things_text)) << 32);
}

}  // namespace

SweepPoint explored_point(const SweepDescription& sweep, const SweepPoint& point) {
  SweepPoint explored = point;
  for (std::size_t i = 0; i < explored.size(); ++i) {
    if (is_only_of_sensors(sweep.unknowns[i])) explored[i].reset();
  }
  return explored;
}

Result<void> check_stock(const SweepDescription& sweep) {
  if (!sweep.sweep.stock) return {};
  for (const Unknown& unknown : sweep.unknowns) {
    const UnknownParameters& given = unknown.parameters;
    if (!changes_what_is_explored(unknown) || !given.is_range() || given.whole) continue;
    return fail(ErrorKind::kUsage,
                fmt::format("the unknown '{}' changes what is explored, and has a range of real "
                            "numbers, so that a stock cannot contain its values",
                            unknown.name),
                unknown.where, "list 'values', each of which has a stock, or remove 'stock'");
  }
  return {};
}

Result<std::vector<StockFile>> RecordingStock::files(const StockedRecording& recording) const {
  const std::uint64_t seed = first_seed_ + recording.number % members_;
  std::vector<StockFile> files;
  const auto add = [&](const Table& explore, bool new_objects) -> Result<void> {
    SOMATO_TRY(auto table, read_explore_table(explore));
    table.exploring.simulation.true_values = true;
    files.push_back({std::move(table), new_objects, seed});
    return {};
  };
  const Table* objects = table_in(recording.explored, "object");
  if (objects == nullptr) {
    SOMATO_TRY_VOID(add(recording.explored, false));
  } else {
    for (const Table::Entry& object : objects->entries) {
      SOMATO_TRY_VOID(add(with_object(recording.explored, object), false));
      files.back().seed = seed_of_object(seed, files.back().table);
    }
  }
  SOMATO_TRY(const auto sensors, read_explore_table(recording.sensors));
  if (!sensors.explore.new_objects) return files;
  SOMATO_TRY_VOID(add(without(without(recording.explored, "object"), "material"), true));
  return files;
}

Result<std::string> RecordingStock::path(const StockFile& file) const {
  return explored_.path(file.table, file.new_objects, file.seed);
}

Result<void> RecordingStock::explore(const StockFile& file) const {
  return explored_.explore_missing(file.table, file.new_objects, file.seed);
}

Result<KeptRecordings::Kept> RecordingStock::read(const StockFile& file) {
  SOMATO_TRY(const auto key, path(file));
  if (auto kept = files_.find(key)) return kept;
  return explored_.explored(file.table, file.new_objects, file.seed)
      .map([&](PairedRecording recording) { return files_.keep(key, std::move(recording)); });
}

Result<std::shared_ptr<const Recording>> RecordingStock::training(
    const StockedRecording& recording, const std::vector<StockFile>& files) {
  SOMATO_TRY(const auto sensors, read_explore_table(recording.sensors));
  if (table_in(recording.explored, "object") == nullptr) {
    return read(files.front()).map([](const KeptRecordings::Kept& file) {
      return std::shared_ptr<const Recording>(file, &file->recording);
    });
  }
  Recording explored;
  for (std::size_t thing = 0; thing < sensors.things->objects.size(); ++thing) {
    SOMATO_TRY(const auto file, read(files[thing]));
    for (const Exploration& one : file->recording.explorations) {
      SOMATO_TRY(auto named, as_thing(one, sensors.things->objects[thing], thing));
      explored.explorations.push_back(std::move(named));
    }
  }
  return std::make_shared<const Recording>(std::move(explored));
}

Result<PairedRecording> RecordingStock::play(const Recording& explored,
                                             const StockedRecording& recording,
                                             const ExploreTable& sensors,
                                             const std::string& name) const {
  return sense(explored, sensors.exploring, recording.seed, threads_).map([&](Recording played) {
    return paired_recording(fmt::format("{}-{}", name, recording.seed), recording.seed,
                            std::move(played));
  });
}

Result<KeptRecordings::Kept> RecordingStock::get(const StockedRecording& recording) {
  SOMATO_TRY(const auto key, identity(recording));
  if (auto kept = played_.find(key)) return kept;
  SOMATO_TRY(const auto files, this->files(recording));
  SOMATO_TRY(const auto sensors, read_explore_table(recording.sensors));
  const std::string name = fmt::format("{}-stock-{}", choice_name(sensors.explore.body),
                                       first_seed_ + recording.number % members_);
  SOMATO_TRY(const auto explored, training(recording, files));
  SOMATO_TRY(auto played, play(*explored, recording, sensors, name));
  if (files.back().new_objects) {
    SOMATO_TRY(const auto new_objects, read(files.back()));
    SOMATO_TRY(auto test, play(new_objects->recording, recording, sensors, name + "-new"));
    played.test = std::make_shared<const PairedRecording>(std::move(test));
  }
  return played_.keep(key, std::move(played));
}

Result<std::string> RecordingStock::identity(const StockedRecording& recording) const {
  SOMATO_TRY(const auto sensors, read_explore_table(recording.sensors));
  SOMATO_TRY(const auto files, this->files(recording));
  std::string text = to_text(sensors) + fmt::format("seed = {}\n", recording.seed);
  for (const StockFile& file : files) {
    SOMATO_TRY(const auto path, this->path(file));
    text += "stock = " + std::filesystem::path(path).filename().string() + "\n";
  }
  return text;
}

}  // namespace somato::program
