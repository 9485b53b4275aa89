#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

#include "base/support/damaged_files.h"
#include "base/support/temporary_folder.h"
#include "maps/support/saved_maps.h"
#include "recordings/support/made_recording.h"
#include "somato/graph/system_model.h"
#include "systems/modules/support.h"
#include "systems/support/systems.h"

namespace somato::testing {

/// The types of modules that hold a GrowingMap: a new one takes part in the laws of all of them.
inline std::vector<std::string> growing_kinds() {
  std::vector<std::string> kinds;
  for (const ModuleType& type : modules::growing_types()) kinds.push_back(type.name);
  return kinds;
}

inline const std::vector<std::string> kKinds = [] {
  std::vector<std::string> kinds = growing_kinds();
  kinds.insert(kinds.begin(), "som");
  return kinds;
}();

inline std::string system_text(const std::string& kind) {
  const std::string settings =
      kind == "som" ? "rows = 3\ncolumns = 4\niterations = 100\n"
      : kind == "growing_cells"
          ? "most_neurons = 12\ninsertion_interval = 9\ndeletion_threshold = 0.4\n"
      : kind == "growing_when_required"
          ? "most_neurons = 12\nhabituation_threshold = 2.0\ninsertion_share = 1.0\n"
          : "most_neurons = 12\n";
  return "[module.joints]\ntype = \"channel\"\nchannel = \"joints\"\n" +
         module("closed", "last", "input = \"joints\"\n") +
         module("map", kind, "input = \"closed\"\n" + settings);
}

// Three objects of six explorations each.
inline Recording recording() {
  return objects_apart(3, 6, 8.0, 1);
}

inline std::vector<std::size_t> range(std::size_t begin, std::size_t end) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = begin; i < end; ++i) numbers.push_back(i);
  return numbers;
}

// Trained on the first object, whose explorations have voted.
inline SystemModel model_of_first(const std::string& kind) {
  const Recording all = recording();
  SystemModel model{trained(build(system_text(kind), all), all, 6, 3), {}};
  const Som& som = *som_of(model.system, 2);
  NeuronVotes votes(som.neurons());
  for (std::size_t i = 0; i < 6; ++i) {
    votes.add(som.winner(frames_of(all, "joints", i).row(0)), 0);
  }
  const std::string name = find_label(all.explorations.front(), "object").value();
  model.answer = SystemAnswer{"map", "object", {name}, votes.labels(), votes};
  return model;
}

// The map of such a model.
inline const Som& map_of(const SystemModel& model) {
  return *som_of(model.system, 2);
}

inline SystemModel saved_and_loaded(const SystemModel& model) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("model"), model.system, model.answer));
  return value_or_throw(load_system(folder.file("model")));
}

inline std::string bytes_of_saved(const SystemModel& model) {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_system(folder.file("model"), model.system, model.answer));
  return bytes_of(folder.file("model"));
}

}  // namespace somato::testing
