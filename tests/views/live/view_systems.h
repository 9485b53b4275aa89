#pragma once

#include <memory>
#include <string>

#include "base/files/toml_file.h"
#include "systems/support/systems.h"
#include "views/session/view_source.h"
#include "views/teaching/map_training.h"

namespace somato::testing {

/// Codes of the hand crossed with touch, summed over the exploration: it runs live.
inline std::string crossed_system() {
  return channels({"joints", "touch"}) +
         module("code", "one_hot", "input = 'joints'\nlow = 0\nhigh = 1\nelements = 4") +
         module("crossed", "tensor_product", "inputs = ['code', 'touch']") +
         module("memory", "accumulate", "input = 'crossed'") +
         module("unit", "normalization", "input = 'memory'") +
         module("map", "som", "input = 'unit'\nrows = 3\ncolumns = 4\niterations = 200");
}

/// The spectrum of the sound: it needs explorations as a whole.
inline std::string sound_system() {
  return channels({"sound"}) +
         module("spectrum", "spectrum", "input = 'sound'\nsegment_length = 8\nbands = 0") +
         module("map", "som", "input = 'spectrum'\nrows = 3\ncolumns = 3\niterations = 200");
}

/// Two maps, of which the second has the output of the first as input.
inline std::string two_maps_system() {
  return channels({"height", "joints"}) + module("rest", "last", "input = 'joints'") +
         module("high", "last", "input = 'height'") +
         module("first", "som", "input = 'rest'\nrows = 3\ncolumns = 3\niterations = 100") +
         module("both", "concatenation", "inputs = ['first', 'high']") +
         module("map", "som", "input = 'both'\nrows = 2\ncolumns = 3\niterations = 100");
}

/// To be trained on a recording with labels `object`.
inline ViewSystem view_system(const std::string& text, const std::string& name = "system") {
  ViewSystem system;
  system.name = name;
  system.text = "A system.";
  system.description =
      value_or_throw(parse_toml(text, "system.toml").and_then([](const Table& table) {
        return read_system(table);
      }));
  system.label = "object";
  return system;
}

inline std::shared_ptr<const SystemModel> trained_model(const std::string& text,
                                                        const Recording& recording) {
  return value_or_throw(live::train_visibly(
      view_system(text), recording, 1, [](const auto&) { return true; }, [] { return true; }));
}

}  // namespace somato::testing
