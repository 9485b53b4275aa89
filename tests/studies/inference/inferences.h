#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "somato/core/random.h"
#include "studies/inference/inference.h"
#include "studies/sweep/sweep_points.h"
#include "studies/sweep/sweeps.h"

namespace somato::test {

/// A range of rates and two orders of drawing, all at once.
inline std::string swept_at_once(std::size_t points) {
  return "[sweep]\ndesign = 'sobol'\npoints = " + std::to_string(points) + "\npairs = 2\n" +
         rate() + kDraws;
}

inline const std::string kTarget =
    "[[target]]\ntext = 'Half are named.'\nsystem = 'press'\nmetric = 'accuracy'\nobserved = "
    "0.5\nscale = 0.1\n";

inline Result<Targets> targets_of(const std::string& toml) {
  return read_targets(parse_toml(toml, "targets.toml").value());
}

/// Results of a sweep in which the accuracy of each pair is the learning rate with some noise,
/// whatever the order of drawing; the small map has the accuracy 0.
inline SweepResults rates_as_accuracies(std::size_t points, const Targets& targets,
                                        double noise = 0.02) {
  SweepResults results{planned(swept_at_once(points)).value(), {}};
  EXPECT_TRUE(add_targets(targets, results.sweep));
  Random random(4);
  for (const SweepPoint& point : sweep_points(results.sweep.sweep)) {
    const double learning_rate = std::get<double>(point[0]->value.content);
    std::vector<PartResults> parts(2);
    for (PartResults& part : parts) {
      part.system = "press";
      part.protocols.push_back({"train_is_test", {}, "material", 8, {}, {}});
    }
    parts[1].variation = "small";
    parts[0].protocols[0].metrics.push_back(
        {"accuracy",
         {learning_rate + noise * random.normal(), learning_rate + noise * random.normal()}});
    parts[1].protocols[0].metrics.push_back({"accuracy", {0.0, 0.0}});
    results.points.push_back(judge_point(results.sweep, point, parts));
  }
  return results;
}

}  // namespace somato::test
