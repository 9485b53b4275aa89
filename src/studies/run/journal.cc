#include "studies/run/journal.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "base/archives/checksum.h"
#include "base/files/whole_file.h"
#include "studies/run/checked_line.h"
#include "systems/graph/graph_json.h"

namespace somato {
namespace {

using SortedJson = nlohmann::json;

constexpr int kJournalVersion = 6;

tl::unexpected<Error> system_error(const std::string& path, const std::string& what) {
  return fail(ErrorKind::kSystem, what + ": " + std::strerror(errno), path,
              "use --out with a writable folder");
}

std::string header_of(const std::string& fingerprint) {
  return checked_line({{"somato_journal", kJournalVersion}, {"study", fingerprint}});
}

// Different studies have different names, so that a folder can hold the journals of several.
std::string part_name(const std::string& fingerprint) {
  return checksum_name(header_of(fingerprint)) + ".journal";
}

SortedJson altered_json(const FoldOutcome& outcome) {
  SortedJson altered = SortedJson::array();
  for (const AlteredOutcome& one : outcome.altered) {
    altered.push_back({{"named_by", one.named_by},
                       {"nearest_raw", one.nearest.raw},
                       {"nearest_standardized", one.nearest.standardized}});
  }
  return altered;
}

// The numbers of a comparison in a fixed order, for writing and for reading.
template <typename Outcome, typename Visit>
void for_each_number(Outcome& outcome, const Visit& visit) {
  visit(outcome.values);
  visit(outcome.explorations);
  visit(outcome.steps_right);
  for (auto* part : {&outcome.predicted, &outcome.mean, &outcome.nearest,
                     &outcome.nearest_standardized, &outcome.preceding, &outcome.chance}) {
    visit(part->squared);
    visit(part->right);
    visit(part->distance);
  }
}

SortedJson numbers_of(const std::vector<PredictionOutcome>& predictions) {
  SortedJson all = SortedJson::array();
  for (const PredictionOutcome& prediction : predictions) {
    SortedJson numbers = SortedJson::array();
    for_each_number(prediction, [&](double number) { numbers.push_back(number); });
    all.push_back(std::move(numbers));
  }
  return all;
}

std::vector<PredictionOutcome> predictions_of(const SortedJson& all) {
  std::vector<PredictionOutcome> predictions(all.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::size_t place = 0;
    for_each_number(predictions[i], [&](double& number) { all[i].at(place++).get_to(number); });
  }
  return predictions;
}

// A line has a checksum, so that its grid is possible.
Grid grid_of(const SortedJson& json) {
  const auto columns = json.at("columns").get<std::size_t>();
  if (json.contains("edges")) {
    return Grid(std::make_shared<const NeuronGraph>(
        columns, json.at("edges").get<std::vector<NeuronGraph::Edge>>()));
  }
  return {json.at("rows").get<std::size_t>(), columns,
          choice_named<Lattice>("lattice", json.at("lattice").get<std::string>(), {}).value(),
          choice_named<Topology>("topology", json.at("topology").get<std::string>(), {}).value()};
}

SortedJson json_of(const ObjectsOutcome& objects) {
  SortedJson learners = SortedJson::array();
  for (const LearnerTests& one : objects.learners) {
    learners.push_back({{"right", one.right}, {"vectors", one.vectors}});
  }
  return {{"tested", objects.tested},
          {"learners", std::move(learners)},
          {"elements", objects.elements},
          {"neurons", objects.neurons}};
}

ObjectsOutcome objects_of(const SortedJson& json) {
  ObjectsOutcome objects;
  json.at("tested").get_to(objects.tested);
  for (const SortedJson& one : json.at("learners")) {
    LearnerTests& tests = objects.learners.emplace_back();
    one.at("right").get_to(tests.right);
    one.at("vectors").get_to(tests.vectors);
  }
  json.at("elements").get_to(objects.elements);
  json.at("neurons").get_to(objects.neurons);
  return objects;
}

// The lists of scores in a fixed order, for writing and for reading.
template <typename Outcome, typename Visit>
void for_each_score(Outcome& novelty, const Visit& visit) {
  for (auto* scores : {&novelty.known, &novelty.unknown}) {
    visit(scores->novelty);
    visit(scores->distance);
    visit(scores->nearest);
  }
}

SortedJson json_of(const NoveltyOutcome& novelty) {
  SortedJson json = SortedJson::array();
  for_each_score(novelty, [&](const std::vector<double>& scores) { json.push_back(scores); });
  return json;
}

NoveltyOutcome novelty_of(const SortedJson& json) {
  NoveltyOutcome novelty;
  std::size_t place = 0;
  for_each_score(novelty, [&](std::vector<double>& scores) { json.at(place++).get_to(scores); });
  return novelty;
}

// The numbers of the tests of teaching in a fixed order, for writing and for reading.
template <typename Outcome, typename Visit>
void for_each_count(Outcome& teaching, const Visit& visit) {
  visit(teaching.taught_tested);
  visit(teaching.known_tested);
  visit(teaching.names);
  visit(teaching.refused);
  for (auto& stage : teaching.stages) {
    for (auto* right : {&stage.taught, &stage.known}) {
      visit(right->answered);
      visit(right->nearest);
      visit(right->baseline);
    }
    visit(stage.known_changed);
  }
}

SortedJson json_of(const TeachingOutcome& teaching) {
  SortedJson counts = SortedJson::array();
  for_each_count(teaching, [&](std::size_t count) { counts.push_back(count); });
  return {{"stages", teaching.stages.size()}, {"counts", std::move(counts)}};
}

TeachingOutcome teaching_of(const SortedJson& json) {
  TeachingOutcome teaching;
  teaching.stages.resize(json.at("stages").get<std::size_t>());
  const SortedJson& counts = json.at("counts");
  std::size_t place = 0;
  for_each_count(teaching, [&](std::size_t& count) { counts.at(place++).get_to(count); });
  return teaching;
}

SortedJson content_for(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  SortedJson content{{"protocol", protocol},
                     {"training", training},
                     {"training_winners", outcome.training_winners},
                     {"winners", outcome.winners},
                     {"named_by", outcome.named_by},
                     {"nearest_raw", outcome.nearest.raw},
                     {"nearest_standardized", outcome.nearest.standardized},
                     {"summed_distance", outcome.summed_distance},
                     {"topographic_errors", outcome.topographic_errors},
                     {"altered", altered_json(outcome)},
                     {"recalled", outcome.recalled},
                     {"predictions", numbers_of(outcome.predictions)},
                     {"grid", detail::grid_json(outcome.map.grid)},
                     {"u_matrix", outcome.map.u_matrix},
                     {"edge_distances", outcome.map.edge_distances},
                     {"objects", json_of(outcome.objects)},
                     {"named", outcome.named}};
  if (outcome.novelty != NoveltyOutcome{}) content["novelty"] = json_of(outcome.novelty);
  if (outcome.teaching != TeachingOutcome{}) content["teaching"] = json_of(outcome.teaching);
  return content;
}

FoldOutcome outcome_of(const SortedJson& line) {
  FoldOutcome outcome;
  line.at("training_winners").get_to(outcome.training_winners);
  line.at("winners").get_to(outcome.winners);
  line.at("named_by").get_to(outcome.named_by);
  line.at("nearest_raw").get_to(outcome.nearest.raw);
  line.at("nearest_standardized").get_to(outcome.nearest.standardized);
  line.at("summed_distance").get_to(outcome.summed_distance);
  line.at("topographic_errors").get_to(outcome.topographic_errors);
  for (const SortedJson& one : line.at("altered")) {
    AlteredOutcome& altered = outcome.altered.emplace_back();
    one.at("named_by").get_to(altered.named_by);
    one.at("nearest_raw").get_to(altered.nearest.raw);
    one.at("nearest_standardized").get_to(altered.nearest.standardized);
  }
  line.at("recalled").get_to(outcome.recalled);
  outcome.predictions = predictions_of(line.at("predictions"));
  outcome.map.grid = grid_of(line.at("grid"));
  line.at("u_matrix").get_to(outcome.map.u_matrix);
  line.at("edge_distances").get_to(outcome.map.edge_distances);
  outcome.objects = objects_of(line.at("objects"));
  line.at("named").get_to(outcome.named);
  if (line.contains("novelty")) outcome.novelty = novelty_of(line.at("novelty"));
  if (line.contains("teaching")) outcome.teaching = teaching_of(line.at("teaching"));
  return outcome;
}

// The complete lines of a text, one after the other; text after the last one is omitted.
class Lines {
 public:
  explicit Lines(std::string_view text) : left_(text) {}

  std::optional<std::string_view> next() {
    const std::size_t end = left_.find('\n');
    if (end == std::string_view::npos) return {};
    const std::string_view line = left_.substr(0, end);
    left_.remove_prefix(end + 1);
    return line;
  }
  std::size_t left() const { return left_.size(); }

 private:
  std::string_view left_;
};

tl::unexpected<Error> damaged(const std::string& path) {
  return fail(ErrorKind::kData, "the file is damaged, or not a journal of a study", path,
              "remove it to restart the study");
}

}  // namespace

Result<Journal> Journal::open(const std::string& path, const std::string& fingerprint) {
  Journal journal;
  journal.path_ = path;
  journal.header_ = header_of(fingerprint);
  std::error_code code;
  if (!std::filesystem::exists(path, code)) return journal;
  SOMATO_TRY(const auto text, read_whole(path));
  SOMATO_TRY_VOID(journal.read(text));
  return journal;
}

Result<Journal> Journal::open_part(const std::filesystem::path& own,
                                   const std::string& fingerprint) {
  return open((own / part_name(fingerprint)).string(), fingerprint);
}

Result<void> Journal::read(const std::string& text) {
  Lines lines(text);
  const auto header = lines.next();
  if (!header) return header_.starts_with(text) ? Result<void>() : damaged(path_);
  if (std::string(*header) + "\n" != header_) {
    const auto content = checked_content(*header);
    if (!content || !content->contains("somato_journal")) return damaged(path_);
    return fail(ErrorKind::kUsage,
                "the folder contains an interrupted study with other settings or data", path_,
                "complete that study, use another --out, or remove the file");
  }
  whole_ = read_trainings(text);
  return {};
}

std::size_t Journal::read_trainings(const std::string& text) {
  Lines lines(std::string_view(text).substr(header_.size()));
  for (std::size_t left = lines.left();; left = lines.left()) {
    const auto line = lines.next();
    const auto content = line ? checked_content(*line) : std::nullopt;
    if (!content) return text.size() - left;  // trainings after a damaged line are computed again
    known_[{content->at("protocol"), content->at("training")}] = outcome_of(*content);
  }
}

void Journal::look(const std::filesystem::path& parts, const std::string& fingerprint) {
  header_ = header_of(fingerprint);
  std::error_code ignored;
  for (const auto& part : std::filesystem::directory_iterator(parts, ignored)) {
    const auto text = read_whole((part.path() / part_name(fingerprint)).string());
    if (text && text->starts_with(header_)) read_trainings(*text);
  }
}

const FoldOutcome* Journal::find(std::size_t protocol, std::size_t training) const {
  const auto found = known_.find({protocol, training});
  return found == known_.end() ? nullptr : &found->second;
}

Result<void> Journal::add(std::size_t protocol, std::size_t training, const FoldOutcome& outcome) {
  if (path_.empty()) return {};
  const std::string line = checked_line(content_for(protocol, training, outcome));
  const std::scoped_lock lock(*mutex_);
  if (!file_) {
    // A line that was cut must not become the beginning of the next one.
    std::error_code code;
    if (whole_ > 0) std::filesystem::resize_file(path_, whole_, code);
    if (!code) file_.reset(std::fopen(path_.c_str(), whole_ > 0 ? "ab" : "wb"));
    if (!file_) return system_error(path_, "the journal cannot be opened");
    if (whole_ == 0 && !write(header_)) return system_error(path_, "the journal cannot be written");
  }
  if (!write(line)) return system_error(path_, "the journal cannot be written");
  return {};
}

bool Journal::write(const std::string& line) {
  return std::fwrite(line.data(), 1, line.size(), file_.get()) == line.size() &&
         std::fflush(file_.get()) == 0;
}

}  // namespace somato
