#pragma once

#include <initializer_list>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/files/toml_file.h"
#include "somato/core/random.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system.h"
#include "somato/graph/system_training.h"
#include "somato/recording/recording.h"

namespace somato::testing {

/// A channel of random values in [0, 1).
inline Channel random_channel(const std::string& name, std::vector<std::size_t> shape,
                              std::size_t frames, Random& random) {
  std::size_t elements = 1;
  for (const std::size_t length : shape) elements *= length;
  Matrix<float> values(frames, elements);
  for (float& value : values.values()) value = static_cast<float>(random.uniform());
  return {name, "", {}, std::move(values), {}, 0.0, std::move(shape), {}};
}

/// Explorations of 2 to 5 frames of the channels height and wrist (one number each), joints (3) and
/// touch (2 x 2), and 16 to 20 frames of sound (one number, 100 Hz).
inline Recording hand_recording(std::size_t explorations, std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t i = 0; i < explorations; ++i) {
    const std::size_t frames = 2 + random.below(4);
    recording.explorations.push_back(
        {{{"object", i % 2 == 0 ? "ball" : "cube"}},
         "trial " + std::to_string(i + 1),
         {random_channel("height", {1}, frames, random),
          random_channel("wrist", {1}, frames, random),
          random_channel("joints", {3}, frames, random),
          random_channel("touch", {2, 2}, frames, random),
          random_channel("sound", {1}, 16 + random.below(5), random)}});
    recording.explorations.back().channels.back().rate = 100.0;
  }
  return recording;
}

/// The table of a module as TOML.
inline std::string module(const std::string& name, const std::string& type,
                          const std::string& settings) {
  return "[module." + name + "]\ntype = \"" + type + "\"\n" + settings + "\n";
}

/// A module for each of these channels, named as the channel.
inline std::string channels(std::initializer_list<const char*> names = {"height", "wrist", "joints",
                                                                        "touch"}) {
  std::string text;
  for (const char* name : names) {
    text += module(name, "channel", "channel = \"" + std::string(name) + "\"");
  }
  return text;
}

/// The system of that text for recordings like that one.
inline Result<System> try_build(const std::string& text, const Recording& recording) {
  return parse_toml(text, "system.toml")
      .and_then([](const Table& table) { return read_system(table); })
      .and_then([&](SystemDescription description) {
        return System::build(std::move(description), layout_of(recording));
      });
}

template <typename T>
T value_or_throw(Result<T> result) {
  if (!result) throw std::runtime_error(to_string(result.error()));
  return std::move(*result);
}

inline System build(const std::string& text, const Recording& recording) {
  return value_or_throw(try_build(text, recording));
}

inline std::vector<std::size_t> first_explorations(std::size_t count) {
  std::vector<std::size_t> explorations(count);
  std::iota(explorations.begin(), explorations.end(), std::size_t{0});
  return explorations;
}

/// Trains on the first `count` explorations.
inline Result<void> try_train(System& system, const Recording& recording, std::size_t count,
                              const SystemTraining& training = {}) {
  auto activations = evaluate_fixed(system, recording, {}, training.threads);
  if (!activations) return fail(std::move(activations.error()));
  return train_system(system, recording, first_explorations(count), training, *activations);
}

/// The same system, trained; throws when it cannot be.
inline System trained(System system, const Recording& recording, std::size_t count,
                      std::uint64_t seed = 1) {
  const auto result = try_train(system, recording, count, {seed, 1, {}});
  if (!result) throw std::runtime_error(to_string(result.error()));
  return system;
}

/// The output of the module of that name for an exploration.
inline Result<Sequence> try_output(const System& system, const Recording& recording,
                                   const std::string& module, std::size_t exploration) {
  const auto number = system.find(module);
  if (!number) return fail(number.error());
  Activations activations(system.modules().size(), recording.explorations.size());
  const std::vector<std::size_t> explorations{exploration};
  auto evaluated = evaluate(system, recording, explorations, {*number}, 1, activations);
  if (!evaluated) return fail(std::move(evaluated.error()));
  return *activations.find(*number, exploration);
}

inline Sequence output_of(const System& system, const Recording& recording,
                          const std::string& module, std::size_t exploration) {
  return value_or_throw(try_output(system, recording, module, exploration));
}

/// All values of a sequence, zeros written out, a row each.
inline Matrix<float> dense(const Sequence& sequence) {
  Matrix<float> rows(sequence.values.count(), sequence.values.size());
  for (std::size_t i = 0; i < rows.rows(); ++i) write_dense(sequence.values[i], rows.row(i));
  return rows;
}

/// A channel of an exploration as recorded.
inline const Matrix<float>& frames_of(const Recording& recording, const std::string& channel,
                                      std::size_t exploration) {
  return (*find_channel(recording.explorations[exploration], channel))->frames;
}

}  // namespace somato::testing
