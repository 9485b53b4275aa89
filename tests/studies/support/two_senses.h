#pragma once

#include <string>

#include "somato/core/random.h"
#include "somato/recording/recording.h"
#include "studies/support/made_study.h"

namespace somato::testing {

/// `trials` explorations of each of `objects` objects, each of four frames of two channels: `seen`
/// with two elements and `felt` with three, of which one after the other is high, as high as the
/// object's number.
inline Recording two_senses(std::size_t objects, std::size_t trials, std::uint64_t seed) {
  Random random(seed);
  Recording recording;
  for (std::size_t object = 0; object < objects; ++object) {
    for (std::size_t trial = 0; trial < trials; ++trial) {
      const auto frames_of = [&](std::size_t elements) {
        Matrix<float> frames(4, elements);
        for (std::size_t frame = 0; frame < 4; ++frame) {
          for (std::size_t i = 0; i < elements; ++i) {
            const bool high = i == (object + frame) % elements;
            const double centre = high ? 1.0 + static_cast<double>(object) : 0.0;
            frames(frame, i) = static_cast<float>(centre + 0.4 * random.uniform());
          }
        }
        return frames;
      };
      Matrix<float> seen = frames_of(2);
      Matrix<float> felt = frames_of(3);
      recording.explorations.push_back(
          {{{"object", "object " + std::to_string(object + 1)},
            {"trial", "trial " + std::to_string(trial + 1)}},
           {},
           {{"seen", "", {}, std::move(seen), {}}, {"felt", "N", {}, std::move(felt), {}}}});
    }
  }
  return recording;
}

/// A map of each sense of two_senses(), that of touch with `side` x `side` neurons, and `called`:
/// the activity of `felt` called up by that of `seen_map`.
inline std::string two_senses_system(std::size_t side = 3) {
  const std::string size = std::to_string(side);
  return "[module.seen]\ntype = 'channel'\nchannel = 'seen'\n"
         "[module.seen_last]\ntype = 'last'\ninput = 'seen'\n"
         "[module.seen_map]\ntype = 'som'\ninput = 'seen_last'\nrows = 2\ncolumns = 3\n"
         "iterations = 200\n"
         "[module.feeling]\ntype = 'channel'\nchannel = 'felt'\n"
         "[module.felt_last]\ntype = 'last'\ninput = 'feeling'\n"
         "[module.felt]\ntype = 'som'\ninput = 'felt_last'\nrows = " +
         size + "\ncolumns = " + size +
         "\niterations = 200\n"
         "[module.called]\ntype = 'association'\ninput = 'seen_map'\ntarget = 'felt'\n"
         "iterations = 500\n";
}

/// One seed of two_senses_system() under leave_one_out, in which what was seen calls up what was
/// felt; `settings` are further lines of [study].
inline StudyDescription two_senses_study(const std::string& settings = "recall = 'called'\n") {
  return study_from("[study]\nname = 'senses'\nseeds = 1\nmap = 'felt'\n" + settings +
                    two_senses_system());
}

}  // namespace somato::testing
