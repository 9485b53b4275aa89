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

Result<void> refuse_without_effect(const Table& table, const SomParameters& parameters) {
  for (const Table::Entry& key : table.entries) {
    const std::string reason = reason_without_effect(parameters, key.name);
    if (!reason.empty()) return fail(without_effect(key.name, reason, key.where));
  }
  return {};
}

// A study gives every run a seed of its own, so that one in [map] would be passed over.
Result<void> read_map(const Table::Entry& entry, SomParameters& parameters) {
  const Table* table = std::get_if<Table>(&entry.content);
  const Table::Entry* seed = table ? table->find("seed") : nullptr;
  if (!seed) {
    if (auto read = read_part(entry, parameters); !read) return read;
    return refuse_without_effect(*table, parameters);
  }
  return fail(ErrorKind::kUsage, "a study's map has no 'seed' of its own", seed->where,
              "write first_seed = ... in [study]");
}

Result<void> read_part(const Table::Entry& entry, StudyDescription& description) {
  if (entry.name == "study") return read_part(entry, description.study);
  if (entry.name == "recording") return read_part(entry, description.recording);
  if (entry.name == "vector") return read_part(entry, description.vector);
  if (entry.name == "map") return read_map(entry, description.map);
  return fail(
      unknown_name("table", entry.name, entry.where, {"study", "recording", "vector", "map"}));
}

template <typename T>
bool has_duplicates(std::vector<T> values) {
  std::sort(values.begin(), values.end());
  return std::adjacent_find(values.begin(), values.end()) != values.end();
}

Result<void> check_complete(const StudyDescription& description, const std::string& where) {
  const auto missing = [&](const std::string& what, const std::string& advice) {
    return fail(ErrorKind::kUsage, what, where, advice);
  };
  if (description.study.name.empty()) {
    return missing("the study has no name", "add name = \"...\" to [study]");
  }
  if (description.study.protocols.empty()) {
    return missing("the study has no protocols", "add protocols = [\"leave_one_out\"] to [study]");
  }
  if (has_duplicates(description.study.protocols)) {
    return missing("a protocol is named twice", "name each of protocols in [study] once");
  }
  if (has_duplicates(description.vector.channels)) {
    return missing("a channel is named twice", "name each of channels in [vector] once");
  }
  if (description.vector.channels.empty()) {
    return missing("the study names no channels", "add channels = [\"...\"] to [vector]");
  }
  return {};
}

}  // namespace

const std::vector<std::pair<FrameChoice, std::string>>& Choices<FrameChoice>::all() {
  static const std::vector<std::pair<FrameChoice, std::string>> choices{
      {FrameChoice::kFirst, "first"},
      {FrameChoice::kLast, "last"},
      {FrameChoice::kChange, "change"}};
  return choices;
}

const Declarations<StudyParameters>& StudyParameters::declarations() {
  using P = StudyParameters;
  static const auto declared =
      Declarations<P>()
          .add(
              "name", [](P& p) -> auto& { return p.name; }, "", Range::any(),
              "Name of the study; stands in the results. Has to be given.")
          .add(
              "label", [](P& p) -> auto& { return p.label; }, "", Range::any(),
              "Which label of the explorations the map is asked to tell apart.")
          .add(
              "individual", [](P& p) -> auto& { return p.individual; }, "", Range::any(),
              "Label of what is dealt to classes anew in wrong groupings, such as the object when "
              "the label is its shape; empty: each exploration on its own.")
          .add(
              "protocols", [](P& p) -> auto& { return p.protocols; }, "", Range::any(),
              "Which samples are learned from and which are tested: all for both, as in the "
              "papers, or "
              "each in turn on a map that never met it.")
          .add(
              "seeds", [](P& p) -> auto& { return p.seeds; }, "", Range::between(1, 1e6),
              "Number of seeds, each a map of its own. The papers show one map.")
          .add(
              "first_seed", [](P& p) -> auto& { return p.first_seed; }, "", Range::between(0, 1e15),
              "The first seed; the others follow it.")
          .add(
              "wrong_groupings", [](P& p) -> auto& { return p.wrong_groupings; }, "",
              Range::between(0, 1e4),
              "Wrong groupings a seed that the measure of areas is compared with.");
  return declared;
}

const Declarations<RecordingParameters>& RecordingParameters::declarations() {
  using P = RecordingParameters;
  static const auto declared = Declarations<P>().add(
      "format", [](P& p) -> auto& { return p.format; }, "", Range::any(),
      "Format of the data that the study is given.");
  return declared;
}

const Declarations<VectorParameters>& VectorParameters::declarations() {
  using P = VectorParameters;
  static const auto declared =
      Declarations<P>()
          .add(
              "channels", [](P& p) -> auto& { return p.channels; }, "", Range::any(),
              "Channels of the recording, put after each other. Have to be given.")
          .add(
              "frames", [](P& p) -> auto& { return p.frames; }, "", Range::any(),
              "Which frames of an exploration make its vector: the first, the last, or the last "
              "less "
              "the first. P11 III reads the joints once, when the hand is closed.")
          .add(
              "standardize", [](P& p) -> auto& { return p.standardize; }, "", Range::any(),
              "Give each element mean 0 and standard deviation 1, learned on the training part.")
          .add(
              "constant_columns", [](P& p) -> auto& { return p.constant_columns; }, "",
              Range::any(),
              "What happens to an element that never changes in the training part: it is an error, "
              "or it becomes 0.");
  return declared;
}

Result<StudyDescription> read_study(const Table& file) {
  StudyDescription description;
  for (const Table::Entry& entry : file.entries) {
    if (auto part = read_part(entry, description); !part) return fail(std::move(part.error()));
  }
  if (auto complete = check_complete(description, file.where); !complete) {
    return fail(std::move(complete.error()));
  }
  return description;
}

}  // namespace somato
