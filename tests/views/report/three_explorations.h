#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <memory>
#include <string>

#include "views/report/evidence.h"

namespace somato::testing {

/// A part of results with its recording: explorations of "ball", "ball" and "cube", all of wood,
/// without channels.
class ThreeExplorations : public ::testing::Test {
 protected:
  ThreeExplorations() {
    results_.protocols.push_back({"train_is_test", "", "object", 3, {}, {}});
    results_.recordings.push_back({"made", "given", 0, "a hash", 3});
    evidence_.part = &results_;
    evidence_.explorations = {0, 1, 2};
    for (const std::string name : {"ball", "ball", "cube"}) {
      recording_->explorations.push_back({{{"object", name}, {"material", "wood"}}, "", {}});
    }
    evidence_.recording = recording_;
  }

  Exploration& exploration(std::size_t i) { return recording_->explorations[i]; }

  PartResults results_;
  std::shared_ptr<Recording> recording_ = std::make_shared<Recording>();
  detail::Evidence evidence_;
};

}  // namespace somato::testing
