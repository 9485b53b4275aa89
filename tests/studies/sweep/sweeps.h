#pragma once

#include <string>

#include "base/files/toml_file.h"
#include "studies/sweep/sweep_plan.h"

namespace somato::test {

/// A system of one map, with a claim about itself and one about a variation.
inline const std::string kSweptSystem = R"([study]
name = "press"
label = "material"
protocols = ["train_is_test"]

[module.potentiometer]
type = "channel"
channel = "potentiometer"
shape = [1]

[module.reading]
type = "last"
input = "potentiometer"

[module.map]
type = "som"
input = "reading"
rows = 5

[explore]
body = "hardness"

[variation.small]
module.map.columns = 2

[variation.not_requested]
module.map.columns = 3

[[claim]]
text = "All materials are named."
metric = "accuracy"
at_least = 0.5

[[claim]]
text = "A small one is worse."
variation = "small"
than_system = "press"
metric = "accuracy"
at_most = 0
)";

inline std::string sweep_toml(const std::string& design, const std::string& unknowns) {
  return "[sweep]\ndesign = '" + design + "'\n" + unknowns;
}

/// A range of learning rates from 0.1 to 0.9, with more keys.
inline std::string rate(const std::string& more = "") {
  return "[unknown.rate]\nkey = 'module.map.learning_rate_start'\ntext = 'Not given.'\n"
         "low = 0.1\nhigh = 0.9\n" +
         more;
}

/// Two orders of drawing.
inline const std::string kDraws =
    "[unknown.draws]\nkey = 'module.map.draws'\ntext = 'Not given.'\n"
    "values = ['with_replacement', 'without_replacement']\n";

inline Result<SweepDescription> read(const std::string& toml) {
  return read_sweep(parse_toml(toml, "sweep.toml").value());
}

inline Result<SystemSweep> planned(const std::string& sweep,
                                   const std::string& system = kSweptSystem) {
  return read(sweep).and_then([&](const SweepDescription& description) {
    return plan_sweep(description, {{"press", parse_toml(system, "press.toml").value()}},
                      {{"explore.explorations", "5"}, {"explore.press.step", "0.5"}});
  });
}

}  // namespace somato::test
