#include "somato/studies/study_parameters.h"

#include <algorithm>

#include "base/core/contains.h"
#include "base/text/flag_hint.h"
#include "somato/core/check.h"
#include "studies/description/changed_keys.h"

namespace somato {
namespace {

// Reads one table of the file into the parameters of its part.
template <typename Parameters>
Result<void> read_part(const Table::Entry& entry, Parameters& parameters) {
  const Table* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'" + entry.name + "' must be a table", entry.where,
                "write [" + entry.name + "] on a separate line, its keys below");
  }
  SOMATO_TRY(Parameters read, read_parameters(*table, parameters));
  parameters = std::move(read);
  return {};
}

template <typename T>
bool has_duplicates(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

// The table [study] of the file, if there is one.
const Table* study_table(const Table& file) {
  const Table::Entry* study = file.find("study");
  return study ? std::get_if<Table>(&study->content) : nullptr;
}

// The location of a key of [study], or of the table, or of the file.
std::string place_of(const Table& file, const std::string& key) {
  const Table* table = study_table(file);
  if (!table) return file.where;
  const Table::Entry* entry = table->find(key);
  return entry ? entry->where : table->where;
}

// A key that only something else reads, such as a protocol.
struct KeyReader {
  std::string key;
  std::string reader;
  bool reads;
};

std::vector<KeyReader> key_readers(const StudyParameters& study) {
  const bool continual = study.has(Protocol::kObjectAfterObject);
  const bool leaves_classes = study.has(Protocol::kLeaveClassOut);
  const bool divides = study.has(Protocol::kFolds) || leaves_classes || continual;
  const bool unknown = study.unknown || leaves_classes;
  // An empty list of groups is how a variation takes them away.
  std::vector<KeyReader> readers{
      {"groups", "the protocol leave_group_out",
       study.groups.empty() || study.has(Protocol::kLeaveGroupOut)},
      {"taught_per_class", "the protocol leave_class_out", leaves_classes}};
  for (const char* key : {"folds", "test_last"}) {
    readers.push_back(
        {key, "the protocol k_folds, leave_class_out or object_after_object", divides});
  }
  readers.push_back({"fold_choice",
                     "the protocol k_folds, leave_class_out or object_after_object and test_last "
                     "= 0, or unknown = true",
                     (divides && study.test_last == 0) || unknown});
  for (const char* key :
       {"replay_per_object", "replay_choice", "generated_per_object", "generated_spread"}) {
    readers.push_back({key, "the protocol object_after_object", continual});
  }
  for (const char* key : {"false_alarm_rate", "calibration_folds", "whitening_shrinkage"}) {
    readers.push_back({key, "the protocol leave_class_out or unknown = true", unknown});
  }
  return readers;
}

Result<void> check_effects(const StudyParameters& study, const Table& file) {
  const Table* table = study_table(file);
  if (!table) return {};
  for (const KeyReader& one : key_readers(study)) {
    if (one.reads || !table->find(one.key)) continue;
    return fail(ErrorKind::kUsage, "'" + one.key + "' has no effect without " + one.reader,
                place_of(file, one.key), "leave it out, or add it");
  }
  return {};
}

Result<void> check_complete(const StudyParameters& study, const Table& file) {
  const auto refuse = [&](const std::string& key, const std::string& what,
                          const std::string& advice) {
    return fail(ErrorKind::kUsage, what, place_of(file, key), advice);
  };
  if (study.name.empty()) {
    return refuse("name", "the study has no name", "add name = \"...\" to [study]");
  }
  if (study.protocols.empty()) {
    return refuse("protocols", "the study has no protocols",
                  "add protocols = [\"leave_one_out\"] to [study]");
  }
  if (has_duplicates(study.protocols)) {
    return refuse("protocols", "a protocol is listed twice", "list each protocol once");
  }
  if (study.has(Protocol::kTestData)) {
    return refuse("protocols", "'test_data' cannot be selected as a protocol",
                  "give the study a test recording instead" + flag_hint("test-data"));
  }
  if (study.has(Protocol::kLeaveGroupOut) && study.groups.empty()) {
    return refuse("protocols", "leave_group_out needs labels that define the groups",
                  "add groups = [\"...\"] to [study]");
  }
  if (has_duplicates(study.groups)) {
    return refuse("groups", "a label is listed twice", "list each label once");
  }
  if (!study.order.empty() && study.individual.empty()) {
    return refuse("order", "an order requires individuals", "add individual = \"...\" to [study]");
  }
  if (!study.within.empty() && study.order.empty()) {
    return refuse("within", "'within' has no effect without 'order'",
                  "remove it, or add the order");
  }
  for (const std::string& pair : study.mapped_with) {
    if (std::count(pair.begin(), pair.end(), ' ') == 1) continue;
    return refuse("mapped_with", "'" + pair + "' does not consist of two classes",
                  "write two names separated by a space: the class that is mapped, and the class "
                  "that it is mapped with");
  }
  if (study.has(Protocol::kObjectAfterObject) && !study.recall.empty()) {
    return refuse("recall", "object_after_object names explorations by the winner, not by a recall",
                  "remove the recall, or the protocol");
  }
  return check_effects(study, file);
}

}  // namespace

const std::vector<std::pair<Protocol, std::string>>& Choices<Protocol>::all() {
  static const std::vector<std::pair<Protocol, std::string>> choices{
      {Protocol::kTrainIsTest, "train_is_test"},
      {Protocol::kLeaveOneOut, "leave_one_out"},
      {Protocol::kLeaveGroupOut, "leave_group_out"},
      {Protocol::kLeaveClassOut, "leave_class_out"},
      {Protocol::kFolds, "k_folds"},
      {Protocol::kObjectAfterObject, "object_after_object"},
      {Protocol::kTestData, "test_data"}};
  return choices;
}

const std::vector<std::pair<FoldChoice, std::string>>& Choices<FoldChoice>::all() {
  static const std::vector<std::pair<FoldChoice, std::string>> choices{
      {FoldChoice::kBlocks, "blocks"}, {FoldChoice::kInterleaved, "interleaved"}};
  return choices;
}

const std::vector<std::pair<ReplayChoice, std::string>>& Choices<ReplayChoice>::all() {
  static const std::vector<std::pair<ReplayChoice, std::string>> choices{
      {ReplayChoice::kRandom, "random"},
      {ReplayChoice::kFirst, "first"},
      {ReplayChoice::kNearestToMean, "nearest_to_mean"},
      {ReplayChoice::kMostDistant, "most_distant"}};
  return choices;
}

bool StudyParameters::has(Protocol protocol) const {
  return contains(protocols, protocol);
}

const Declarations<StudyParameters>& StudyParameters::declarations() {
  using P = StudyParameters;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(),
               "Name of the study, which is used in the results. Required.")
          .add("label", &P::label, "", Range::any(),
               "Label of the explorations by which the map is evaluated; its values are the "
               "classes.")
          .add("only", &P::only, "", Range::any(),
               "Values of the label to include; explorations with other values are left out. "
               "Empty: all.")
          .add("labels", &P::labels, "", Range::any(),
               "Further labels by which the same maps are evaluated, such as the shape.")
          .add("individual", &P::individual, "", Range::any(),
               "Label of the units that are reassigned to classes at random in wrong groupings, "
               "such as the object if the label is its shape; if it is empty, or if every class is "
               "a single individual, each exploration is reassigned separately.")
          .add("order", &P::order, "", Range::any(),
               "Label with a number of each individual, such as its girth; measures whether the "
               "map preserves its order (P11 section III).")
          .add("within", &P::within, "", Range::any(),
               "Label of the groups within which the order is measured as well, such as the shape.")
          .add("mapped_with", &P::mapped_with, "", Range::any(),
               "Pairs of classes, two names separated by a space: the number of samples of the "
               "first that are mapped with the second.")
          .add("map", &P::map, "", Range::any(),
               "Name of the output map, a module of type som; empty: the only one whose output no "
               "other module uses.")
          .add("recall", &P::recall, "", Range::any(),
               "Name of a module whose output has the shape of the map, such as an association "
               "whose target is the map: its strongest neuron names the test explorations instead "
               "of the map's winner. Empty: the winner.")
          .add("predictions", &P::predictions, "", Range::any(),
               "Names of associations whose predictions for the test explorations are compared "
               "with their targets.")
          .add("protocols", &P::protocols, "", Range::any(),
               "Division into training and test explorations: all for both, as in the papers; or "
               "each exploration, each group, or each of several equal parts is tested by a system "
               "trained on the others; or, with the same parts, by a system that learns the "
               "objects one after another. A separate test recording adds test_data.")
          .add("groups", &P::groups, "", Range::any(),
               "Labels whose values are the groups of leave_group_out, which is run once for each "
               "label.")
          .add("folds", &P::folds, "", Range::between(2, 1e6),
               "Number of parts of k_folds and object_after_object, and of the parts that "
               "leave_class_out holds out of the known classes.")
          .add("fold_choice", &P::fold_choice, "", Range::any(),
               "Which explorations of a class are in the same part: consecutive ones of the "
               "recording, or ones drawn at random. Neighbours in a recording are often alike; if "
               "one is learned and the other tested, the accuracy is that of known explorations. "
               "k_folds and object_after_object are compared with the other choice. The "
               "calibration_folds are chosen in the same way.")
          .add("test_last", &P::test_last, "explorations", Range::between(0, 1e6),
               "Number of explorations of each class, the last of the recording, that are tested "
               "after training on the earlier ones, instead of the parts: by k_folds and "
               "object_after_object, and by leave_class_out as known ones. 0: parts.")
          .add("replay_per_object", &P::replay_per_object, "explorations", Range::between(0, 1e6),
               "Number of explorations of each object that are kept and learned again with each "
               "later object, under object_after_object.")
          .add("replay_choice", &P::replay_choice, "", Range::any(),
               "Which explorations are kept: drawn at random, the first, those nearest to the mean "
               "of the object, or, after the one nearest to the mean, those most distant from "
               "those already chosen; also for the baseline with the memory of the map.")
          .add("generated_per_object", &P::generated_per_object, "vectors", Range::between(0, 1e6),
               "Number of vectors that are generated for each earlier object and learned with each "
               "later one: weights of neurons with its name, with normal noise.")
          .add("generated_spread", &P::generated_spread, "", Range::between(0, 1e3),
               "Standard deviation of that noise, as a share of the distance of the neuron from "
               "the nearest other one.")
          .add("unknown", &P::unknown, "", Range::any(),
               "Whether the saved system reads \"unknown\" if an exploration is too far from all "
               "that it has learned; the threshold is found by further trainings, on training "
               "explorations only.")
          .add("false_alarm_rate", &P::false_alarm_rate, "", Range::between(1e-4, 0.5),
               "Share of explorations of known classes that may be read as unknown; not given in "
               "the paper.")
          .add("calibration_folds", &P::calibration_folds, "", Range::between(2, 1000),
               "Number of parts of the training explorations, each held out of a further training "
               "to find the threshold of unknown ones; not given in the paper.")
          .add("whitening_shrinkage", &P::whitening_shrinkage, "", Range::between(1e-3, 1),
               "Share of the mean variance in the covariance within classes by which vectors are "
               "whitened before the distances of unknown ones are measured; 1: the distances of "
               "the map. Automatic: 0.3 for a Euclidean map of at most 1024 elements, 1 for "
               "others. Not given in the paper.")
          .add("taught_per_class", &P::taught_per_class, "explorations", Range::between(0, 1e6),
               "Number of explorations of the class left out that a system is given the name of, "
               "one after another, under leave_class_out; it is tested on the others after each.")
          .add("seeds", &P::seeds, "", Range::between(1, 1e6),
               "Number of seeds; each trains a separate map. The papers show one map.")
          .add("first_seed", &P::first_seed, "", Range::between(0, 1e15),
               "The first seed; the others follow consecutively.")
          .add("wrong_groupings", &P::wrong_groupings, "", Range::between(0, 1e4),
               "Number of wrong groupings per seed with which the measure of areas is compared.");
  return declared;
}

Result<StudyDescription> read_study(const Table& file) {
  StudyDescription description;
  description.where = place_of(file, {});
  for (const Table::Entry& entry : file.entries) {
    Result<void> part;
    if (entry.name == "study") part = read_part(entry, description.study);
    if (entry.name == "recording") part = read_part(entry, description.recording);
    if (!part) return fail(std::move(part.error()));
  }
  auto system =
      read_system(file, {"study", "recording", "altered", "explore", "variation", "claim"});
  if (!system) return fail(std::move(system.error()));
  description.system = std::move(*system);
  SOMATO_TRY(auto alterations, read_alterations(file));
  description.altered = std::move(alterations);
  if (description.system.name.empty()) description.system.name = description.study.name;
  SOMATO_TRY_VOID(check_complete(description.study, file));
  return description;
}

void reset_unread(StudyParameters& study, const std::vector<std::string>& given) {
  const StudyParameters defaults;
  for (const KeyReader& one : key_readers(study)) {
    if (one.reads || contains(given, one.key)) continue;
    const auto parameter = StudyParameters::declarations().find(one.key);
    require(parameter && parameter->assign(study, parameter->read(defaults)).has_value(),
            "a default is a valid value");
  }
}

std::string to_toml(const StudyDescription& description) {
  // Without defaults, since a key that no protocol reads is refused.
  return changed_keys_to_toml("study", description.study) +
         changed_keys_to_toml("recording", description.recording) + to_toml(description.altered) +
         to_toml(description.system);
}

}  // namespace somato
