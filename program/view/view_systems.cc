#include "view/view_systems.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <functional>
#include <utility>

#include "recordings/study_data.h"
#include "somato/graph/system_model.h"
#include "somato/recording/layout.h"
#include "somato/studies/own_systems.h"
#include "somato/studies/study_parameters.h"

namespace somato::program {
namespace {

// A system's file without the tables that only 'reproduce' uses.
Result<StudyDescription> description_in(const Table& content) {
  Table study = content;
  std::erase_if(study.entries, [](const Table::Entry& entry) {
    return entry.name == "explore" || entry.name == "claim" || entry.name == "variation";
  });
  return read_study(study);
}

bool has_labels(const Recording& recording, const std::string& name) {
  const auto values = label_values(recording, name);
  return values && values->size() > 1;
}

ViewSystem offered(const StudyDescription& description) {
  ViewSystem system;
  system.name = description.study.name;
  system.text = fmt::format("Classifies by {}; learns from the explorations in the view.",
                            description.study.label);
  system.description = description.system;
  system.label = description.study.label;
  system.map = description.study.map;
  return system;
}

std::string body_in(const Table& content) {
  const Table::Entry* explore = content.find("explore");
  const Table* table = explore != nullptr ? std::get_if<Table>(&explore->content) : nullptr;
  const Table::Entry* body = table != nullptr ? table->find("body") : nullptr;
  const Value* value = body != nullptr ? std::get_if<Value>(&body->content) : nullptr;
  const auto* text = value != nullptr ? std::get_if<std::string>(&value->content) : nullptr;
  return text != nullptr ? *text : "";
}

// Whether all inputs of a system are among these channels.
bool hears_only(const SystemDescription& description, const std::vector<std::string>& channels) {
  const auto system = System::build(description, {});
  if (!system) return false;
  return std::all_of(
      system->modules().begin(), system->modules().end(), [&](const SystemModule& module) {
        const auto* source = dynamic_cast<const Source*>(module.module.get());
        return source == nullptr ||
               std::find(channels.begin(), channels.end(), source->channel()) != channels.end();
      });
}

Result<std::vector<ViewSystem>> systems_that(
    const std::function<bool(const Table&, const StudyDescription&)>& fits) {
  SOMATO_TRY(auto own, own_systems());
  std::vector<NamedFile> files = questionable_systems(own);
  for (NamedFile& recorded : own.recorded) files.push_back(std::move(recorded));
  std::vector<ViewSystem> systems;
  for (const NamedFile& file : files) {
    SOMATO_TRY(auto description, description_in(file.content));
    if (fits(file.content, description)) systems.push_back(offered(description));
  }
  return systems;
}

}  // namespace

Result<ViewSystem> trained_system(const std::string& path) {
  SOMATO_TRY(auto model, load_system(path));
  ViewSystem system;
  system.name = std::filesystem::path(path).filename().string();
  system.text = "The given trained system.";
  system.trained = std::make_shared<const SystemModel>(std::move(model));
  return system;
}

Result<Recording> read_as_for_model(const Arguments& arguments, const std::string& path) {
  if (!arguments.has("model") || !is_table(path)) return read_study_data({}, path);
  return load_system(arguments.text("model")).and_then([&](const SystemModel& model) {
    return read_study_data(recording_for(model, path), path);
  });
}

Result<std::vector<ViewSystem>> systems_for(const Recording& recording) {
  const RecordingLayout layout = layout_of(recording);
  return systems_that([&](const Table&, const StudyDescription& description) {
    return has_labels(recording, description.study.label) &&
           System::build(description.system, layout).has_value();
  });
}

Result<std::vector<ViewSystem>> systems_for_body(const std::string& body) {
  return systems_that([&](const Table& content, const StudyDescription& description) {
    const std::string needed = body_in(content);
    if (needed != "probes") return needed == body;
    // A single probe has one of the channels of both probes.
    return hears_only(description.system, {body == "texture"    ? "sound"
                                           : body == "hardness" ? "potentiometer"
                                                                : ""});
  });
}

Result<std::vector<ViewSystem>> systems_for_channels(const std::vector<std::string>& channels,
                                                     const std::vector<std::string>& labels) {
  return systems_that([&](const Table&, const StudyDescription& description) {
    return std::find(labels.begin(), labels.end(), description.study.label) != labels.end() &&
           hears_only(description.system, channels);
  });
}

}  // namespace somato::program
