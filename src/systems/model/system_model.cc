#include "somato/graph/system_model.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/archives/archive.h"
#include "base/files/toml_file.h"
#include "base/text/text.h"
#include "maps/som/map_parts.h"
#include "somato/core/check.h"
#include "systems/model/labels_part.h"
#include "systems/model/model_parts.h"
#include "systems/model/novelty_part.h"
#include "systems/modules/map_module.h"

namespace somato {
namespace {

const std::string kSystemKind = "system";

std::string prefix_of(const SystemModule& module) {
  return "module." + module.name + ".";
}

// A channel of the layout as TOML reads it.
struct ChannelPart {
  ChannelLayout channel;

  static const Declarations<ChannelPart>& declarations() {
    using P = ChannelPart;
    static const auto declared =
        Declarations<P>()
            .add(
                "name", [](P& p) -> auto& { return p.channel.name; }, "", Range::any(), "Name.")
            .add(
                "unit", [](P& p) -> auto& { return p.channel.unit; }, "", Range::any(), "Unit.")
            .add(
                "shape", [](P& p) -> auto& { return p.channel.shape; }, "", Range::at_least(1),
                "Shape of a frame.")
            .add(
                "elements", [](P& p) -> auto& { return p.channel.element_names; }, "", Range::any(),
                "Names of the elements.")
            .add(
                "clock", [](P& p) -> auto& { return p.channel.clock; }, "", Range::any(),
                "Channels with the same clock have frames recorded together.");
    return declared;
  }
};

std::string layout_to_toml(const RecordingLayout& layout) {
  std::string text;
  for (const ChannelLayout& channel : layout.channels) {
    text += "[[channel]]\n" + parameters_to_toml(ChannelPart{channel});
  }
  return text;
}

Result<RecordingLayout> read_layout(const std::string& text, const std::string& where) {
  const auto table = parse_toml(text, where);
  if (!table) return damaged_model(table.error(), where);
  RecordingLayout layout;
  for (const Table::Entry& entry : table->entries) {
    const auto* channels = std::get_if<std::vector<Table>>(&entry.content);
    if (!channels || entry.name != "channel") return damaged_model("the layout is invalid", where);
    for (const Table& channel : *channels) {
      auto part = read_parameters<ChannelPart>(channel);
      if (!part) return damaged_model(std::move(part.error()), where);
      layout.channels.push_back(std::move(part->channel));
    }
  }
  return layout;
}

struct AnswerPart {
  SystemAnswer answer;

  static const Declarations<AnswerPart>& declarations() {
    using P = AnswerPart;
    static const auto declared =
        Declarations<P>()
            .add(
                "map", [](P& p) -> auto& { return p.answer.map; }, "", Range::any(), "Map.")
            .add(
                "label", [](P& p) -> auto& { return p.answer.label; }, "", Range::any(), "Label.")
            .add(
                "classes", [](P& p) -> auto& { return p.answer.classes; }, "", Range::any(),
                "Names of the classes.");
    return declared;
  }
};

void require_fit(const System& system, const SystemAnswer& answer) {
  const auto module = system.find(answer.map);
  const Som* som = module ? som_of(system, *module) : nullptr;
  require(som != nullptr, "a system's answer needs the name of a map");
  require(som->neurons() == answer.labels.neurons() && !answer.labels.labelled().empty(),
          "a system's answer needs a label or none for each neuron of the map, and at least one");
  for (const std::size_t neuron : answer.labels.labelled()) {
    require(*answer.labels[neuron] < answer.classes.size(), "a neuron's class has no name");
  }
  require(answer.votes.neurons() == 0 || (answer.votes.labels() == answer.labels &&
                                          answer.votes.classes() <= answer.classes.size()),
          "the labels of an answer must be those of its votes");
  require(!answer.novelty || answer.novelty->scales.size() == answer.classes.size(),
          "a threshold for unknown inputs needs a scale for each class");
  require(!answer.novelty || answer.novelty->whitening.empty() ||
              answer.novelty->whitening.rows() == som->input_size(),
          "a whitening has the size of the map's inputs");
}

Result<SystemAnswer> read_answer(const Archive& archive, const System& system,
                                 const std::string& where) {
  SOMATO_TRY(auto part, parameters_from<AnswerPart>(archive, "answer", where));
  const auto module = system.find(part.answer.map, where);
  const Som* som = module ? som_of(system, *module) : nullptr;
  if (som == nullptr) return damaged_model("the output map is missing", where);
  SOMATO_TRY(auto labels, labels_from(archive, som->neurons(), part.answer.classes.size(), where));
  part.answer.labels = std::move(labels);
  SOMATO_TRY(part.answer.novelty,
             novelty_from(archive, part.answer.classes.size(), som->input_size(), where));
  if (!archive.find("votes")) return std::move(part.answer);
  SOMATO_TRY(auto votes, votes_from(archive, som->neurons(), part.answer.classes.size(), where));
  if (votes.labels() != part.answer.labels) {
    return damaged_model("the labels are not those of the votes", where);
  }
  part.answer.votes = std::move(votes);
  return std::move(part.answer);
}

Archive archive_of(const System& system, const std::optional<SystemAnswer>& answer,
                   const RecordingParameters& recording) {
  Archive archive(kSystemKind);
  archive.add("description", to_toml(system.description()));
  archive.add("layout", layout_to_toml(system.layout()));
  if (recording != RecordingParameters{}) {
    archive.add("recording", parameters_to_toml(recording));
  }
  for (const SystemModule& module : system.modules()) {
    if (const Learner* learner = module.module->learner())
      learner->save(archive, prefix_of(module));
  }
  if (answer) {
    archive.add("answer", parameters_to_toml(AnswerPart{*answer}));
    archive.add("labels", labels_array(answer->labels));
    if (answer->votes.neurons() > 0) {
      archive.add("votes", votes_array(answer->votes, answer->classes.size()));
    }
    if (answer->novelty) add_novelty(archive, *answer->novelty);
  }
  return archive;
}

Archive archive_of(const SystemModel& model) {
  return archive_of(model.system, model.answer, model.recording);
}

// Whether the lines of `text` are lines of `again`, in the same order. The parameters in a file of
// an earlier version lack those that were added later.
bool has_lines_in(std::string_view text, std::string_view again) {
  const std::vector<std::string> present = split(again, '\n');
  auto from = present.begin();
  const std::vector<std::string> lines = split(text, '\n');
  return std::ranges::all_of(lines, [&](const std::string& line) {
    from = std::find(from, present.end(), line);
    return from != present.end() && (++from, true);
  });
}

// Saving again must give the same parts, neither more nor fewer.
bool is_written_as(const Archive& archive, const Archive& again) {
  const auto is_same = [](const Archive::Entry& one, const Archive::Entry& other) {
    const auto* text = std::get_if<std::string>(&one.content);
    const auto* other_text = std::get_if<std::string>(&other.content);
    if (text == nullptr || other_text == nullptr) return one == other;
    return one.name == other.name && has_lines_in(*text, *other_text);
  };
  return std::ranges::equal(archive.entries(), again.entries(), is_same);
}

Result<System> build(const Archive& archive, const std::string& where) {
  SOMATO_TRY(const auto description, archive.get<std::string>("description", where));
  SOMATO_TRY(const auto layout_text, archive.get<std::string>("layout", where));
  const auto table = parse_toml(*description, where);
  if (!table) return damaged_model(table.error(), where);
  auto read = read_system(*table);
  if (!read) return damaged_model(std::move(read.error()), where);
  SOMATO_TRY(auto layout, read_layout(*layout_text, where));
  auto system = System::build(std::move(*read), std::move(layout));
  if (!system) return damaged_model(std::move(system.error()), where);
  return system;
}

Result<SystemModel> system_model_in(const Archive& archive, const std::string& where) {
  SOMATO_TRY(auto system, build(archive, where));
  for (const SystemModule& module : system.modules()) {
    Learner* learner = module.module->learner();
    if (learner == nullptr) continue;
    auto loaded = learner->load(archive, prefix_of(module), where);
    if (!loaded) return damaged_model(std::move(loaded.error()), where);
  }
  SystemModel model{std::move(system), {}};
  if (archive.find("recording")) {
    SOMATO_TRY(model.recording, parameters_from<RecordingParameters>(archive, "recording", where));
  }
  if (archive.find("answer")) {
    SOMATO_TRY(model.answer, read_answer(archive, model.system, where));
  }
  return model;
}

}  // namespace

RecordingParameters recording_for(const SystemModel& model, const std::string& path) {
  if (!is_table(path)) return {};
  RecordingParameters parameters = model.recording;
  parameters.labels.clear();  // those of other rows
  parameters.for_system = true;
  const std::vector<ChannelLayout>& channels = model.system.layout().channels;
  if (channels.size() == 1) parameters.features = channels.front().element_names;
  return parameters;
}

const Som* som_of(const System& system, std::size_t module) {
  const auto* som = dynamic_cast<const modules::MapModule*>(system.modules()[module].module.get());
  return som != nullptr ? &som->som() : nullptr;
}

const RefinedOrder* refined_order_of(const System& system, std::size_t module) {
  const auto* som = dynamic_cast<const modules::MapModule*>(system.modules()[module].module.get());
  return som != nullptr ? som->refined_order() : nullptr;
}

Grid grid_of(const System& system, std::size_t module) {
  const auto* som = dynamic_cast<const modules::MapModule*>(system.modules()[module].module.get());
  require(som != nullptr, "only a map has a grid");
  return som->grid();
}

SystemAnswer answer_of(const System& system, std::size_t map, std::string label,
                       std::vector<std::string> classes, const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& of_samples, std::optional<Novelty> novelty) {
  NeuronVotes votes(som_of(system, map)->neurons());
  votes.add_all(winners, of_samples);
  NeuronLabels labels = votes.labels();
  return {system.modules()[map].name, std::move(label), std::move(classes),
          std::move(labels),          std::move(votes), std::move(novelty)};
}

Result<void> save_system(const std::string& path, const System& system,
                         const std::optional<SystemAnswer>& answer) {
  if (answer) require_fit(system, *answer);
  return save_archive(path, archive_of(system, answer, {}));
}

Result<void> save_system(const std::string& path, const SystemModel& model) {
  if (model.answer) require_fit(model.system, *model.answer);
  return save_archive(path, archive_of(model));
}

SystemModel copy_of(const SystemModel& model) {
  return system_model_in(archive_of(model), "copy").value();
}

Result<SystemModel> load_system(const std::string& path) {
  SOMATO_TRY(const auto archive, load_archive(path));
  SOMATO_TRY_VOID(check_kind(archive, kSystemKind, path));
  SOMATO_TRY(auto model, system_model_in(archive, path));
  if (is_written_as(archive, archive_of(model))) return model;
  return damaged_model("the parts do not fit together", path);
}

}  // namespace somato
