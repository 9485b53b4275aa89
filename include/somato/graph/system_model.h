#pragma once

#include <optional>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/graph/system.h"
#include "somato/maps/labels.h"

namespace somato {

/// What a trained system says about an exploration: which map answers, and what its neurons stand
/// for.
struct SystemAnswer {
  std::string map;                   ///< Name of a module of type `som`.
  std::string label;                 ///< What is asked, such as "object".
  std::vector<std::string> classes;  ///< Names of the classes.
  NeuronLabels labels;               ///< A class a neuron, of those that have one.
};

/// A trained system with its answer.
struct SystemModel {
  System system;
  std::optional<SystemAnswer> answer;
};

/// Saves description, layout, and all that was learned in one file, wholly or not at all (see
/// save_whole); docs/formats/model-file.md describes it. Throws InvalidArgument when the answer
/// does not fit the system. Every learning module must have learned.
Result<void> save_system(const std::string& path, const System& system,
                         const std::optional<SystemAnswer>& answer = {});

/// The same system, bit by bit. Errors: kSystem for a file that cannot be read, kData for one that
/// is damaged or holds something else.
Result<SystemModel> load_system(const std::string& path);

/// The map that a module holds; nullptr when the module is none of type `som`.
const Som* som_of(const System& system, std::size_t module);

/// The grid of that map, also before it has learned. Throws InvalidArgument for another module.
Grid grid_of(const System& system, std::size_t module);

}  // namespace somato
