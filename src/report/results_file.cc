#include "somato/report/results_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "report/checked_json.h"

namespace somato {
namespace {

using detail::CheckedJson;

constexpr std::uint64_t kStudyVersion = 3;
constexpr std::uint64_t kReproductionVersion = 1;
constexpr std::uint64_t kMostNeurons = (1U << 24U) - 1;
constexpr double kMostGroupings = 1e9;
constexpr std::uint64_t kAny = std::numeric_limits<std::uint64_t>::max();

std::vector<std::string> texts(const CheckedJson& json) {
  std::vector<std::string> all;
  json.each([&](const CheckedJson& one) { all.push_back(one.text()); });
  return all;
}

std::string optional_text(const CheckedJson& json, const std::string& key) {
  return json.has(key) ? json.at(key).text() : std::string();
}

void expect_length(const CheckedJson& json, std::size_t length) {
  if (json.size() == length) return;
  json.refuse(fmt::format("has {} entries, where {} are needed", json.size(), length));
}

// Values with how often they occurred: lists of two.
Distribution distribution_of(const CheckedJson& json) {
  Distribution distribution;
  json.each([&](const CheckedJson& entry) {
    std::vector<double> numbers;
    entry.each([&](const CheckedJson& number) { numbers.push_back(number.number()); });
    if (entry.ok()) expect_length(entry, 2);
    if (!entry.ok()) return;
    if (numbers[1] < 1.0 || numbers[1] > kMostGroupings || numbers[1] != std::floor(numbers[1])) {
      entry.refuse("does not say how often the value occurred");
      return;
    }
    distribution[numbers[0]] = static_cast<std::size_t>(numbers[1]);
  });
  if (json.ok() && distribution.empty()) json.refuse("has no value");
  return distribution;
}

Metric metric_of(const std::string& name, const CheckedJson& json, std::size_t runs) {
  Metric metric{name, {}};
  static_cast<void>(json.at("mean").number_or_nan());
  static_cast<void>(json.at("sd").number_or_nan());
  const CheckedJson values = json.at("values");
  values.each([&](const CheckedJson& value) { metric.values.push_back(value.number_or_nan()); });
  if (json.ok()) expect_length(values, runs);
  if (!json.has("of_each")) return metric;
  const CheckedJson of_each = json.at("of_each");
  of_each.each(
      [&](const CheckedJson& of_run) { metric.of_each.push_back(distribution_of(of_run)); });
  if (json.ok()) expect_length(of_each, runs);
  return metric;
}

std::vector<std::string> classes_of(const CheckedJson& json, std::size_t samples) {
  std::vector<std::string> names = texts(json);
  if (json.ok()) expect_length(json, samples);
  return names;
}

Run run_of(const CheckedJson& json, std::size_t samples) {
  Run run;
  run.seed = json.at("seed").whole(kAny);
  const CheckedJson winners = json.at("winners");
  winners.each(
      [&](const CheckedJson& winner) { run.winners.push_back(winner.whole(kMostNeurons)); });
  if (json.ok()) expect_length(winners, samples);
  run.labels = classes_of(json.at("labels"), samples);
  run.predictions = classes_of(json.at("predictions"), samples);
  if (!json.has("other_predictions")) return run;
  json.at("other_predictions").entries([&](const std::string& name, const CheckedJson& named) {
    run.other_predictions.emplace_back(name, classes_of(named, samples));
  });
  return run;
}

SystemResults protocol_of(const CheckedJson& json) {
  SystemResults results{json.at("name").text(),
                        json.at("protocol").text(),
                        optional_text(json, "group"),
                        json.at("label").text(),
                        json.at("samples").whole(kAny),
                        {},
                        {}};
  json.at("runs").each(
      [&](const CheckedJson& run) { results.runs.push_back(run_of(run, results.samples)); });
  json.at("metrics").entries([&](const std::string& name, const CheckedJson& metric) {
    results.metrics.push_back(metric_of(name, metric, results.runs.size()));
  });
  return results;
}

// Protocols of one part have the same runs.
void read_protocols(const CheckedJson& json, PartResults& part) {
  json.each([&](const CheckedJson& one) {
    part.protocols.push_back(protocol_of(one));
    if (one.ok() && part.protocols.front().runs.size() != part.protocols.back().runs.size()) {
      one.refuse("has another number of runs than the one before");
    }
  });
}

// Names become keys of TOML again.
bool is_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
}

std::vector<Settings> settings_of(const CheckedJson& json) {
  std::vector<Settings> all;
  json.entries([&](const std::string& part, const CheckedJson& settings) {
    if (!is_name(part)) settings.refuse("is no name of a part");
    all.push_back({part, {}});
    settings.entries([&](const std::string& name, const CheckedJson& value) {
      if (!is_name(name)) value.refuse("is no name of a setting");
      all.back().settings.push_back({name, to_toml(value.value())});
    });
  });
  return all;
}

void check_version(const CheckedJson& root, std::uint64_t known) {
  const std::uint64_t version = root.at("version").whole(kAny);
  if (!root.ok() || version == known) return;
  root.at("version").refuse(
      fmt::format("is {}, and {} is the one that can be read", version, known));
}

void read_study(const CheckedJson& root, ResultsFile& file) {
  check_version(root, kStudyVersion);
  PartResults part;
  part.system = root.at("study").text();
  part.recordings = {""};
  part.settings = settings_of(root.at("settings"));
  read_protocols(root.at("systems"), part);
  if (!part.protocols.empty()) {
    for (const Run& run : part.protocols.front().runs) part.pairs.push_back({0, run.seed});
  }
  file.recordings.push_back({"", "", 0, root.at("data_hash").text(), 0});
  file.parts.push_back(std::move(part));
}

RecordingInfo recording_of(const CheckedJson& json) {
  return {json.at("name").text(), json.at("source").text(), json.at("seed").whole(kAny),
          json.at("data_hash").text(), json.at("explorations").whole(kAny)};
}

Pair pair_of(const CheckedJson& json, std::size_t recordings) {
  std::vector<std::uint64_t> numbers;
  json.each([&](const CheckedJson& number) { numbers.push_back(number.whole(kAny)); });
  if (json.ok()) expect_length(json, 2);
  if (!json.ok()) return {};
  if (numbers[0] >= recordings) json.refuse("is of a recording that is not there");
  return {numbers[0], numbers[1]};
}

void read_part(const CheckedJson& json, ResultsFile& file) {
  PartResults part;
  part.question = json.at("question").text();
  part.system = json.at("system").text();
  part.variation = json.at("variation").text();
  part.settings = settings_of(json.at("settings"));
  part.recordings = texts(json.at("recordings"));
  json.at("pairs").each([&](const CheckedJson& pair) {
    part.pairs.push_back(pair_of(pair, part.recordings.size()));
  });
  read_protocols(json.at("protocols"), part);
  for (const SystemResults& protocol : part.protocols) {
    if (json.ok() && protocol.runs.size() != part.pairs.size()) {
      json.at("pairs").refuse("are not as many as there are runs");
    }
  }
  for (const std::string& name : part.recordings) {
    if (json.ok() && !file.find_recording(name)) {
      json.at("recordings").refuse("names one that the file does not have");
    }
  }
  file.parts.push_back(std::move(part));
}

Claim claim_of(const CheckedJson& json) {
  Claim claim;
  claim.text = json.at("text").text();
  claim.paper = json.at("paper").text();
  claim.question = json.at("question").text();
  claim.system = json.at("system").text();
  claim.variation = json.at("variation").text();
  claim.metric = json.at("metric").text();
  claim.protocol = json.at("protocol").text();
  claim.group = json.at("group").text();
  claim.than_system = optional_text(json, "than_system");
  claim.than_variation = optional_text(json, "than_variation");
  claim.published = json.at("published").number_or_nothing();
  claim.at_least = json.at("at_least").number_or_nothing();
  claim.at_most = json.at("at_most").number_or_nothing();
  return claim;
}

// The values that the figures are made of stand with the systems: the claim is judged by them anew,
// so that files from before the verdicts have them too.
void read_claim(const CheckedJson& json, ResultsFile& file) {
  JudgedClaim judged;
  const Claim claim = claim_of(json);
  judged.share = json.at("share").number();
  static_cast<void>(json.at("by_luck").number_or_nothing());
  if (!json.ok()) return;
  if (judged.share < 0.0 || judged.share > 1.0) json.at("share").refuse("is no share");
  const auto outcomes = judge({claim}, file.parts);
  if (outcomes.empty()) json.refuse("is about something that is not in the file");
  if (!outcomes.empty()) judged.outcome = outcomes.front();
  file.claims.push_back(std::move(judged));
}

void read_reproduction(const CheckedJson& root, ResultsFile& file) {
  check_version(root, kReproductionVersion);
  root.at("recordings").each([&](const CheckedJson& one) {
    file.recordings.push_back(recording_of(one));
  });
  root.at("systems").each([&](const CheckedJson& one) { read_part(one, file); });
  root.at("claims").each([&](const CheckedJson& one) { read_claim(one, file); });
}

}  // namespace

const RecordingInfo* ResultsFile::find_recording(const std::string& name) const {
  const auto found = std::find_if(recordings.begin(), recordings.end(),
                                  [&](const RecordingInfo& one) { return one.name == name; });
  return found == recordings.end() ? nullptr : &*found;
}

Result<ResultsFile> parse_results(std::string_view text, const std::string& path) {
  const auto json = detail::parse_results_json(text, path);
  if (!json) return fail(json.error());
  std::optional<Error> trouble;
  const CheckedJson root(*json, trouble);
  ResultsFile file;
  file.path = path;
  file.is_study = root.has("study");
  if (!root.has("version") || !root.has("systems") || (!file.is_study && !root.has("claims"))) {
    return fail(ErrorKind::kData, "it is no results.json of a study or a reproduction", path,
                "give one that 'somato run' or 'somato reproduce' wrote");
  }
  if (file.is_study) {
    read_study(root, file);
  } else {
    read_reproduction(root, file);
  }
  if (!trouble) return file;
  trouble->where = path;
  trouble->advice =
      "give results.json as 'somato run' or 'somato reproduce' of this version wrote it";
  return fail(std::move(*trouble));
}

}  // namespace somato
