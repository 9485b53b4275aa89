#pragma once

#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/maps/labels.h"
#include "somato/maps/novelty.h"
#include "somato/maps/refinement.h"
#include "somato/recording/format.h"

namespace somato {

/// The output of a trained system for an exploration: the output map, and the classes of its
/// neurons.
struct SystemAnswer {
  std::string map;                   ///< Name of a module of type `som`.
  std::string label;                 ///< The label that is predicted, such as "object".
  std::vector<std::string> classes;  ///< Names of the classes.
  NeuronLabels labels;               ///< One class per labelled neuron.
  NeuronVotes votes = {};  ///< The votes that gave the labels; empty in files of earlier versions.
  std::optional<Novelty> novelty = {};  ///< When an input is unknown; empty: never.
};

/// The answer of the map of a trained system whose neurons are named by the samples that they win;
/// sample i has the class `of_samples[i]` of `classes` and the winner `winners[i]`.
SystemAnswer answer_of(const System& system, std::size_t map, std::string label,
                       std::vector<std::string> classes, const std::vector<std::size_t>& winners,
                       const std::vector<std::size_t>& of_samples,
                       std::optional<Novelty> novelty = {});

/// A trained system with its output, and how its data were read: other tables are read likewise.
struct SystemModel {
  System system;
  std::optional<SystemAnswer> answer;
  RecordingParameters recording = {};
};

/// How the system reads the data at `path`: a table like that of its training, with columns
/// selected by the names of the system's elements; other data with the default settings.
RecordingParameters recording_for(const SystemModel& model, const std::string& path);

/// Saves description, layout, and all learned values in one file, atomically (see save_whole);
/// docs/formats/model-file.md describes it. Throws InvalidArgument if the answer does not fit the
/// system. Every learning module must be trained.
Result<void> save_system(const std::string& path, const System& system,
                         const std::optional<SystemAnswer>& answer = {});

/// The same with all parts of a model.
Result<void> save_system(const std::string& path, const SystemModel& model);

/// The same model, bit by bit, as if it had been saved and loaded.
SystemModel copy_of(const SystemModel& model);

/// Reads the same system, bit by bit. Errors: kSystem for a file that cannot be read, kData for one
/// that is damaged or contains something else.
Result<SystemModel> load_system(const std::string& path);

/// The map of a module; nullptr if the module is not of type `som`.
const Som* som_of(const System& system, std::size_t module);

/// The order of that map before and after its refinement; nullptr unless it was refined in this
/// process, since model files do not contain it.
const RefinedOrder* refined_order_of(const System& system, std::size_t module);

/// The grid of that map, also before training. Throws InvalidArgument for another module.
Grid grid_of(const System& system, std::size_t module);

}  // namespace somato
