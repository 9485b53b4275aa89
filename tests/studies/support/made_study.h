#pragma once

#include <string>

#include "base/files/toml_file.h"
#include "somato/core/random.h"
#include "somato/recording/recording.h"
#include "somato/studies/study_parameters.h"

namespace somato::testing {

/// A description from its text, which must be right.
inline StudyDescription study_from(const std::string& toml) {
  return read_study(parse_toml(toml, "study.toml").value()).value();
}

/// A map of 5 x 5 neurons on the joints of the last frame; `standardization` holds lines of that
/// module, or "none" for a map of the joints as they are.
inline std::string joints_system(const std::string& standardization = "") {
  const bool raw = standardization == "none";
  return "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
         "[module.closed]\ntype = 'last'\ninput = 'joints'\n" +
         (raw ? std::string()
              : "[module.standardized]\ntype = 'standardization'\ninput = 'closed'\n" +
                    standardization) +
         "[module.map]\ntype = 'som'\ninput = '" + (raw ? "closed" : "standardized") +
         "'\nrows = 5\ncolumns = 5\niterations = 300\n";
}

/// Two seeds, from 5, of joints_system().
inline StudyDescription small_study(const std::string& standardization = "") {
  return study_from("[study]\nname = 'small'\nseeds = 2\nfirst_seed = 5\n" +
                    joints_system(standardization));
}

/// A system where everything that can learn does: ranges of one-hot codes, a T-MPSOM beside a
/// tensor product, a standardization, a map. For recordings of grasps().
inline std::string learning_system() {
  return "[module.fingers]\ntype = 'channel'\nchannel = 'joints'\nelements = ['1', '2']\n"
         "[module.wrist]\ntype = 'channel'\nchannel = 'joints'\nelements = ['3']\n"
         "[module.fingers_code]\ntype = 'one_hot'\ninput = 'fingers'\nelements = 4\n"
         "outside = 'clamp'\n"
         "[module.wrist_code]\ntype = 'one_hot'\ninput = 'wrist'\nelements = 5\n"
         "outside = 'clamp'\n"
         "[module.product]\ntype = 'tensor_product'\ninputs = ['fingers_code', 'wrist_code']\n"
         "[module.memory]\ntype = 'accumulate'\ninput = 'product'\n"
         "[module.binding]\ntype = 't_mpsom'\ninputs = ['fingers_code', 'wrist_code']\n"
         "shape = [4, 5]\niterations = 60\n"
         "[module.bound]\ntype = 'accumulate'\ninput = 'binding'\n"
         "[module.both]\ntype = 'concatenation'\ninputs = ['memory', 'bound']\n"
         "[module.scaled]\ntype = 'standardization'\ninput = 'both'\nconstant_columns = 'zero'\n"
         "[module.map]\ntype = 'som'\ninput = 'scaled'\nrows = 4\ncolumns = 4\niterations = 100\n";
}

/// Two seeds, from 5, of learning_system().
inline StudyDescription learning_study() {
  return study_from("[study]\nname = 'learning'\nseeds = 2\nfirst_seed = 5\n" + learning_system());
}

/// `trials` explorations of each of `objects` objects, each of four frames of three joints that
/// close around the object, more or less. With labels `object` and `trial`.
inline Recording grasps(std::size_t objects, std::size_t trials, std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t object = 0; object < objects; ++object) {
    for (std::size_t trial = 0; trial < trials; ++trial) {
      Matrix<float> frames(4, 3);
      for (std::size_t frame = 0; frame < 4; ++frame) {
        for (std::size_t joint = 0; joint < 3; ++joint) {
          const auto closed = static_cast<double>(10 * frame * (1 + (object + joint) % 3));
          frames(frame, joint) = static_cast<float>(closed + 15.0 * random.uniform());
        }
      }
      recording.explorations.push_back({{{"object", "object " + std::to_string(object + 1)},
                                         {"trial", "trial " + std::to_string(trial + 1)}},
                                        {},
                                        {{"joints", "deg", {}, std::move(frames), {}}}});
    }
  }
  return recording;
}

}  // namespace somato::testing
