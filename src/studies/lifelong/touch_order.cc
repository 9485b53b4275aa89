#include "studies/lifelong/touch_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "base/core/threads.h"
#include "base/core/values_at.h"
#include "maps/training/batch_training.h"
#include "somato/codes/standardization.h"
#include "somato/core/random.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_training.h"
#include "somato/studies/next_grasp.h"
#include "studies/description/exploration_samples.h"
#include "studies/description/folds.h"
#include "studies/folds/tally.h"
#include "studies/lifelong/grasp_vectors.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

const std::vector<std::string> kOrders{"chosen", "fixed", "random"};

// The data that all trainings share.
struct Problem {
  const TouchOrderParameters& parameters;
  Classes classes;
  std::vector<Samples> vectors;  // of each grasp, for all explorations
};

// The names that a map, trained on explorations of one grasp, reads for others.
Result<Numbers> readings(const Problem& problem, std::size_t grasp, const Fold& fold,
                         std::uint64_t seed) {
  const Samples& vectors = problem.vectors[grasp];
  const Samples training = vectors.subset(fold.training);
  SOMATO_TRY(const auto standardization, Standardization::fit(training, {ConstantColumns::kZero}));
  SomParameters parameters;
  parameters.rows = problem.parameters.rows;
  parameters.columns = problem.parameters.columns;
  parameters.iterations = problem.parameters.iterations;
  parameters.seed = seed;
  const Samples inputs = standardization.apply(training);
  SOMATO_TRY(const auto som, train_som(parameters, inputs));
  const NeuronLabels labels =
      NeuronLabels::by_majority(winners_of(som, inputs, 1),
                                values_at(problem.classes.of_sample, fold.training), som.neurons());
  return labels.classify(som, standardization.apply(vectors.subset(fold.test)));
}

// Counted on held-out training explorations.
Result<ReadingProbabilities> reading_probabilities(const Problem& problem, std::size_t grasp,
                                                   const Numbers& training, std::uint64_t seed) {
  const std::size_t classes = problem.classes.names.size();
  ReadingProbabilities shares(classes, std::vector<double>(classes, 1.0));
  for (const Fold& part : folds_among(training, problem.classes.of_sample,
                                      problem.parameters.calibration_folds, seed)) {
    SOMATO_TRY(const auto names, readings(problem, grasp, part, seed));
    for (std::size_t i = 0; i < names.size(); ++i) {
      shares[problem.classes.of_sample[part.test[i]]][names[i]] += 1.0;
    }
  }
  for (std::vector<double>& of_class : shares) {
    const double sum = std::accumulate(of_class.begin(), of_class.end(), 0.0);
    for (double& share : of_class) share /= sum;
  }
  return shares;
}

// The state of knowledge about a fold before the first grasp of a test exploration.
struct LearnedGrasps {
  std::vector<ReadingProbabilities> probabilities;  // of each grasp
  std::vector<Numbers> names;                       // of each grasp, for the test explorations
};

Result<LearnedGrasps> learn_grasps(const Problem& problem, const Fold& fold, std::uint64_t seed) {
  LearnedGrasps learned;
  for (std::size_t grasp = 0; grasp < problem.vectors.size(); ++grasp) {
    SOMATO_TRY(auto names, readings(problem, grasp, fold, seed));
    SOMATO_TRY(auto shares, reading_probabilities(problem, grasp, fold.training, seed));
    learned.names.push_back(std::move(names));
    learned.probabilities.push_back(std::move(shares));
  }
  return learned;
}

// Sums over explorations, by the number of grasps.
struct OrderSums {
  explicit OrderSums(std::size_t grasps) : right(grasps, 0.0), certainty(grasps, 0.0) {}

  std::vector<double> right;
  std::vector<double> certainty;
  double stopped_grasps = 0.0;
  double stopped_right = 0.0;
};

// One test exploration, read grasp by grasp. The grasps in `left` are taken in their order, unless
// they are chosen.
void read_in_order(const LearnedGrasps& learned, std::size_t test, std::size_t label, Numbers left,
                   bool is_chosen, double certain, OrderSums& sums) {
  const std::size_t classes = learned.probabilities.front().size();
  std::vector<double> belief(classes, 1.0 / static_cast<double>(classes));
  bool is_stopped = false;
  for (std::size_t taken = 0; !left.empty(); ++taken) {
    const std::size_t grasp =
        is_chosen ? next_grasp(belief, learned.probabilities, left) : left.front();
    std::erase(left, grasp);
    belief = updated_belief(belief, learned.probabilities[grasp], learned.names[grasp][test]);
    const auto best = std::max_element(belief.begin(), belief.end());
    const double right = best - belief.begin() == static_cast<std::ptrdiff_t>(label) ? 1.0 : 0.0;
    sums.right[taken] += right;
    sums.certainty[taken] += *best;
    if (is_stopped || (*best < certain && !left.empty())) continue;
    is_stopped = true;
    sums.stopped_grasps += static_cast<double>(taken + 1);
    sums.stopped_right += right;
  }
}

// All orders of one seed.
Result<std::vector<OrderSums>> read_seed(const Problem& problem, std::uint64_t seed) {
  const std::size_t grasps = problem.vectors.size();
  Numbers fixed(grasps);
  std::iota(fixed.begin(), fixed.end(), std::size_t{0});
  FoldSamples samples{problem.classes.of_sample.size()};
  samples.classes = problem.classes.of_sample;
  samples.folds = problem.parameters.folds;
  samples.seed = seed;
  Random random(seed, Stream::kGroupings);
  std::vector<OrderSums> sums(kOrders.size(), OrderSums(grasps));
  for (const Fold& fold : folds(Protocol::kFolds, samples)) {
    SOMATO_TRY(const auto learned, learn_grasps(problem, fold, seed));
    for (std::size_t test = 0; test < fold.test.size(); ++test) {
      const std::size_t label = problem.classes.of_sample[fold.test[test]];
      const double certain = problem.parameters.certainty;
      read_in_order(learned, test, label, fixed, true, certain, sums[0]);
      read_in_order(learned, test, label, fixed, false, certain, sums[1]);
      read_in_order(learned, test, label, random_order(grasps, random), false, certain, sums[2]);
    }
  }
  return sums;
}

TouchOrderResult result_of(std::size_t order, const std::vector<std::vector<OrderSums>>& seeds,
                           std::size_t grasps, std::size_t explorations) {
  TouchOrderResult result{kOrders[order],
                          std::vector<Metric>(grasps, Metric{"accuracy", {}}),
                          std::vector<Metric>(grasps, Metric{"certainty", {}}),
                          {"stopped_grasps", {}},
                          {"stopped_accuracy", {}}};
  const auto count = static_cast<double>(explorations);
  for (const std::vector<OrderSums>& seed : seeds) {
    const OrderSums& sums = seed[order];
    for (std::size_t taken = 0; taken < grasps; ++taken) {
      result.accuracy[taken].values.push_back(sums.right[taken] / count);
      result.certainty[taken].values.push_back(sums.certainty[taken] / count);
    }
    result.stopped_grasps.values.push_back(sums.stopped_grasps / count);
    result.stopped_accuracy.values.push_back(sums.stopped_right / count);
  }
  return result;
}

Result<Problem> problem_of(const Recording& recording, const TouchOrderParameters& parameters) {
  SOMATO_TRY_VOID(validate(recording));
  SOMATO_TRY(const auto names, labels_of(recording, parameters.label));
  SOMATO_TRY(auto vectors, grasp_vectors(recording, {parameters.pose, parameters.pose_tolerance,
                                                     parameters.channels}));
  Problem problem{parameters, Classes::from_names(names), std::move(vectors)};
  if (problem.vectors.size() < 2) {
    return fail(ErrorKind::kData, "the explorations have fewer than two grasps", {},
                "name the channels in which grasps differ with 'pose'");
  }
  if (problem.classes.names.size() < 2) {
    return fail(ErrorKind::kData,
                fmt::format("every exploration has the same '{}'", parameters.label), {},
                "there are no classes to distinguish; use another label");
  }
  if (names.size() < 2 * parameters.folds) {
    return fail(ErrorKind::kData,
                fmt::format("{} explorations cannot be divided into {} parts of two", names.size(),
                            parameters.folds),
                {}, "use a smaller number of 'folds', or more explorations");
  }
  return problem;
}

}  // namespace

const Declarations<TouchOrderParameters>& TouchOrderParameters::declarations() {
  using P = TouchOrderParameters;
  static const auto declared =
      Declarations<P>()
          .add("label", &P::label, "", Range::any(), "Label whose values are the names to be read.")
          .add("pose", &P::pose, "", Range::any(),
               "Channels that state the pose of the hand; a grasp ends where one of them changes.")
          .add("pose_tolerance", &P::pose_tolerance, "", Range::at_least(0),
               "Change of such a channel, in its unit, within one grasp; not given in the paper.")
          .add("channels", &P::channels, "", Range::any(),
               "Channels that are read in the last frame of each grasp.")
          .add("rows", &P::rows, "neurons", Range::between(1, 1000),
               "Rows of the map of each grasp; not given in the paper.")
          .add("columns", &P::columns, "neurons", Range::between(1, 1000),
               "Columns of the map of each grasp; not given in the paper.")
          .add("iterations", &P::iterations, "samples drawn", Range::between(1, 1e9),
               "Iterations of each map; not given in the paper.")
          .add("folds", &P::folds, "", Range::between(2, 1e6),
               "Number of parts of the explorations, each read by maps trained on the others.")
          .add("calibration_folds", &P::calibration_folds, "", Range::between(2, 1000),
               "Number of parts of the training explorations, each read by further maps to count "
               "how probable readings are; not given in the paper.")
          .add("certainty", &P::certainty, "", Range::between(0, 1),
               "Probability of a name from which no further grasp is made; not given in the paper.")
          .add("seeds", &P::seeds, "", Range::between(1, 1e6),
               "Number of seeds; each has other maps, parts and random orders.")
          .add("first_seed", &P::first_seed, "", Range::between(0, 1e15),
               "The first seed; the others follow consecutively.");
  return declared;
}

Result<TouchOrders> compare_touch_orders(const Recording& recording,
                                         const TouchOrderParameters& parameters,
                                         const Progress& progress, std::size_t threads) {
  SOMATO_TRY(const auto problem, problem_of(recording, parameters));
  std::vector<std::vector<OrderSums>> seeds(parameters.seeds);
  Tally tally("the comparison", progress, parameters.seeds);
  for_each_task(parameters.seeds, threads, [&](std::size_t number) {
    if (tally.stopped()) return;
    auto sums = read_seed(problem, parameters.first_seed + number);
    if (!sums) return tally.failed(std::move(sums.error()));
    seeds[number] = std::move(*sums);
    tally.one_done();
  });
  if (tally.stopped()) return fail(tally.error());
  const std::size_t grasps = problem.vectors.size();
  const std::size_t explorations = recording.explorations.size();
  TouchOrders orders{explorations, problem.classes.names.size(), grasps, {}};
  for (std::size_t order = 0; order < kOrders.size(); ++order) {
    orders.orders.push_back(result_of(order, seeds, grasps, explorations));
  }
  return orders;
}

}  // namespace somato
