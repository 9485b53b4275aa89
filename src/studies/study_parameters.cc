#include "somato/studies/study_parameters.h"

#include <algorithm>

namespace somato {
namespace {

// Reads one table of the file into the parameters of its part.
template <typename Parameters>
Result<void> read_part(const Table::Entry& entry, Parameters& parameters) {
  const Table* table = std::get_if<Table>(&entry.content);
  if (!table) {
    return fail(ErrorKind::kUsage, "'" + entry.name + "' must be a table", entry.where,
                "write [" + entry.name + "] on a line of its own, its keys below");
  }
  Result<Parameters> read = read_parameters(*table, parameters);
  if (!read) return fail(std::move(read.error()));
  parameters = std::move(*read);
  return {};
}

template <typename T>
bool has_duplicates(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

// What the file says of [study], which may be nothing.
const Table* study_table(const Table& file) {
  const Table::Entry* study = file.find("study");
  return study ? std::get_if<Table>(&study->content) : nullptr;
}

// Where a key of [study] stands, or the table, or the file.
std::string place_of(const Table& file, const std::string& key) {
  const Table* table = study_table(file);
  if (!table) return file.where;
  const Table::Entry* entry = table->find(key);
  return entry ? entry->where : table->where;
}

// A key that only a protocol reads.
Result<void> check_effect(const Table& file, const std::string& key, const std::string& protocol,
                          bool is_read) {
  const Table* table = study_table(file);
  if (is_read || !table || !table->find(key)) return {};
  return fail(ErrorKind::kUsage, "'" + key + "' has no effect without the protocol " + protocol,
              place_of(file, key), "leave it out, or add the protocol");
}

Result<void> check_complete(const StudyParameters& study, const Table& file) {
  const auto refuse = [&](const std::string& key, const std::string& what,
                          const std::string& advice) {
    return fail(ErrorKind::kUsage, what, place_of(file, key), advice);
  };
  const auto has = [&](Protocol protocol) {
    return std::find(study.protocols.begin(), study.protocols.end(), protocol) !=
           study.protocols.end();
  };
  if (study.name.empty()) {
    return refuse("name", "the study has no name", "add name = \"...\" to [study]");
  }
  if (study.protocols.empty()) {
    return refuse("protocols", "the study has no protocols",
                  "add protocols = [\"leave_one_out\"] to [study]");
  }
  if (has_duplicates(study.protocols)) {
    return refuse("protocols", "a protocol is named twice",
                  "name each of protocols in [study] once");
  }
  if (has(Protocol::kTestData)) {
    return refuse("protocols", "'test_data' is no protocol to name",
                  "run the study with --test-data instead");
  }
  if (has(Protocol::kLeaveGroupOut) && study.groups.empty()) {
    return refuse("protocols", "leave_group_out needs the labels whose groups are left out",
                  "add groups = [\"...\"] to [study]");
  }
  if (has_duplicates(study.groups)) {
    return refuse("groups", "a label is named twice", "name each of groups in [study] once");
  }
  if (!study.order.empty() && study.individual.empty()) {
    return refuse("order", "an order is one of individuals, and none are named",
                  "add individual = \"...\" to [study]");
  }
  if (!study.within.empty() && study.order.empty()) {
    return refuse("within", "'within' has no effect without 'order'",
                  "leave it out, or add the order");
  }
  for (const std::string& pair : study.mapped_with) {
    if (std::count(pair.begin(), pair.end(), ' ') == 1) continue;
    return refuse(
        "mapped_with", "'" + pair + "' does not name two classes",
        "write two names with a space between them: those mapped, and those they are with");
  }
  // An empty list is how a variation takes the groups away.
  return check_effect(file, "groups", "leave_group_out",
                      study.groups.empty() || has(Protocol::kLeaveGroupOut))
      .and_then([&] { return check_effect(file, "folds", "k_folds", has(Protocol::kFolds)); });
}

}  // namespace

const Declarations<StudyParameters>& StudyParameters::declarations() {
  using P = StudyParameters;
  static const auto declared =
      Declarations<P>()
          .add("name", &P::name, "", Range::any(),
               "Name of the study; stands in the results. Has to be given.")
          .add("label", &P::label, "", Range::any(),
               "Which label of the explorations the map is asked to tell apart.")
          .add("only", &P::only, "", Range::any(),
               "Values of the label that are asked about; explorations with others are left out. "
               "Empty: all.")
          .add("labels", &P::labels, "", Range::any(),
               "Further labels asked of the same maps, such as the shape.")
          .add("individual", &P::individual, "", Range::any(),
               "Label of what is dealt to classes anew in wrong groupings, such as the object when "
               "the label is its shape; each exploration on its own where it is empty, or where "
               "every class is a single individual.")
          .add("order", &P::order, "", Range::any(),
               "Label with a number of each individual, such as its girth: whether it is in order "
               "around the map (P11 section III).")
          .add("within", &P::within, "", Range::any(),
               "Label of the groups within which the order is asked, too, such as the shape.")
          .add(
              "mapped_with", &P::mapped_with, "", Range::any(),
              "Pairs of classes, each two names with a space between them: how many samples of the "
              "first are mapped with the second.")
          .add("map", &P::map, "", Range::any(),
               "Name of the module of type som whose winners answer; empty: the one that no other "
               "module listens to.")
          .add("protocols", &P::protocols, "", Range::any(),
               "Which explorations are learned from and which are tested: all for both, as in the "
               "papers; or each in turn, each group, or each of some equal parts on what never met "
               "it. test_data comes with --test-data.")
          .add("groups", &P::groups, "", Range::any(),
               "Labels whose values are the groups of leave_group_out, which is run once for each "
               "label.")
          .add("folds", &P::folds, "", Range::between(2, 1e6), "Number of parts of k_folds.")
          .add("seeds", &P::seeds, "", Range::between(1, 1e6),
               "Number of seeds, each a map of its own. The papers show one map.")
          .add("first_seed", &P::first_seed, "", Range::between(0, 1e15),
               "The first seed; the others follow it.")
          .add("wrong_groupings", &P::wrong_groupings, "", Range::between(0, 1e4),
               "Wrong groupings a seed that the measure of areas is compared with.");
  return declared;
}

const Declarations<RecordingParameters>& RecordingParameters::declarations() {
  using P = RecordingParameters;
  static const auto declared = Declarations<P>().add(
      "format", &P::format, "", Range::any(),
      "Format of the data that the study is given; automatic: by the files' names.");
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
  auto system = read_system(file, {"study", "recording", "explore", "variation", "claim"});
  if (!system) return fail(std::move(system.error()));
  description.system = std::move(*system);
  if (description.system.name.empty()) description.system.name = description.study.name;
  if (auto complete = check_complete(description.study, file); !complete) {
    return fail(std::move(complete.error()));
  }
  return description;
}

}  // namespace somato
