#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "somato/core/parameter.h"
#include "somato/core/progress.h"
#include "somato/core/result.h"
#include "somato/recording/recording.h"
#include "somato/studies/results.h"

namespace somato {

/// Parameters of the comparison of orders of grasps.
struct TouchOrderParameters {
  std::string label = "object";
  std::vector<std::string> pose{"height", "wrist"};
  double pose_tolerance = 0.5;
  std::vector<std::string> channels{"joints", "touch"};
  std::size_t rows = 6;
  std::size_t columns = 6;
  std::uint64_t iterations = 2000;
  std::size_t folds = 5;
  std::size_t calibration_folds = 4;
  double certainty = 0.95;
  std::size_t seeds = 20;
  std::uint64_t first_seed = 1;

  static const Declarations<TouchOrderParameters>& declarations();
};

/// The readings after 1, 2, ... grasps in one order; one value per seed.
struct TouchOrderResult {
  std::string order;              ///< "chosen", "fixed" or "random".
  std::vector<Metric> accuracy;   ///< Share of right names, by the number of grasps.
  std::vector<Metric> certainty;  ///< Mean probability of the name, by the number of grasps.
  Metric stopped_grasps;          ///< Mean number of grasps until the name is certain, or all.
  Metric stopped_accuracy;        ///< Share of right names then.
};

struct TouchOrders {
  std::size_t explorations = 0;
  std::size_t classes = 0;
  std::size_t grasps = 0;  ///< The number in each exploration.
  std::vector<TouchOrderResult> orders;
};

/// Compares orders of the grasps of recorded explorations: as recorded, at random, and always the
/// one after which the least entropy of the name is to be expected (next_grasp()).
///
/// For each fold and grasp, a map of the standardized vectors of that grasp is trained on the
/// training explorations; its reading is the name of the most similar labelled neuron. The
/// probabilities of readings are counted on training explorations that were held out of further
/// maps, each count increased by 1 (Laplace's rule of succession). All classes are equally probable
/// at first; grasps are taken as independent of each other. Nothing is learned from test
/// explorations.
///
/// Errors: those of grasp_vectors(); an unknown label (kUsage); one class, fewer than two grasps,
/// or more folds than explorations (kData); kInterrupted.
Result<TouchOrders> compare_touch_orders(const Recording& recording,
                                         const TouchOrderParameters& parameters,
                                         const Progress& progress = {}, std::size_t threads = 1);

}  // namespace somato
