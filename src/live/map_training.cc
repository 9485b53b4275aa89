#include "live/map_training.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "live/viewed_system.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_training.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_learner.h"
#include "somato/maps/som_quality.h"
#include "somato/maps/som_training.h"

namespace somato::live {
namespace {

constexpr std::uint64_t kLooks = 100;
constexpr std::uint64_t kLooksAtLarge = 25;
constexpr std::size_t kLarge = std::size_t{1} << 22;  // weights
constexpr std::size_t kMostSamplesShown = 500;        // samples

tl::unexpected<Error> stopped() {
  return fail(ErrorKind::kInterrupted, "the training was stopped before its end");
}

class VisibleTraining {
 public:
  VisibleTraining(const ViewSystem& wanted, const Recording& recording, std::uint64_t seed,
                  const TrainingEyes& eyes, const std::function<bool()>& goes_on)
      : wanted_(wanted), recording_(recording), seed_(seed), eyes_(eyes), goes_on_(goes_on) {}

  Result<std::shared_ptr<const SystemModel>> train() {
    auto trained = build()
                       .and_then([&] { return learn_before_map(); })
                       .and_then([&] { return find_samples(); })
                       .and_then([&] { return alone_ ? learn_map() : Result<void>(); });
    if (!trained) return fail(std::move(trained.error()));
    return labelled();
  }

 private:
  Result<void> build() {
    std::vector<std::string> names;
    for (const Exploration& exploration : recording_.explorations) {
      auto name = find_label(exploration, wanted_.label);
      if (!name) return fail(std::move(name.error()));
      names.push_back(std::move(*name));
    }
    classes_ = Classes::from_names(names);
    if (classes_.names.size() < 2) {
      return fail(ErrorKind::kData, "there is nothing to tell apart yet", wanted_.label,
                  "let other things be explored too");
    }
    all_.resize(names.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    auto system = System::build(wanted_.description, layout_of(recording_));
    if (!system) return fail(std::move(system.error()));
    system_ = std::move(*system);
    auto map = answering_map(system_, wanted_.map);
    if (!map) return fail(std::move(map.error()));
    look_.module = std::move(*map);
    map_ = *system_.find(look_.module);
    alone_ = parameters_alone(system_, map_, seed_);
    if (alone_ && alone_->training != Training::kOnline) alone_.reset();
    return {};
  }

  // One exploration after the other: it may be told to stop in between.
  Result<void> evaluate_all(const std::vector<std::size_t>& wanted) {
    for (const std::size_t exploration : all_) {
      if (!goes_on_()) return stopped();
      const std::array<std::size_t, 1> one{exploration};
      auto evaluated = evaluate(system_, recording_, one, wanted, 1, activations_);
      if (!evaluated) return evaluated;
    }
    return {};
  }

  // All phases but that of a map that is looked at.
  Result<void> learn_before_map() {
    activations_ = Activations(system_.modules().size(), all_.size());
    if (auto fixed = evaluate_all(fixed_inputs(system_, {})); !fixed) return fixed;
    SystemTraining training;
    training.seed = seed_;
    training.progress = [&](std::uint64_t done, std::uint64_t total) {
      look_.step = done;
      look_.steps = total;
      return eyes_(look_);
    };
    if (alone_) training.without = map_;
    return train_system(system_, recording_, all_, training, activations_);
  }

  Result<void> find_samples() {
    const std::size_t input = system_.modules()[map_].inputs.front();
    if (system_.modules()[map_].output.rate == Rate::kFrame) {
      return fail(ErrorKind::kUsage, "the map that answers has frames coming in");
    }
    if (auto seen = evaluate_all({input}); !seen) return seen;
    std::vector<Signal> signals;
    signals.reserve(all_.size());
    for (const std::size_t exploration : all_) {
      signals.push_back(Signal::copy_of(activations_.find(input, exploration)->values[0]));
    }
    samples_ = Samples::from_signals(signals);
    return {};
  }

  Result<void> learn_map() {
    auto untrained = untrained_som(*alone_, samples_);
    if (!untrained) return fail(std::move(untrained.error()));
    Som som = std::move(*untrained);
    const SomParameters parameters = som.parameters();
    const std::uint64_t steps = parameters.iterations.value_or(0);
    DrawSequence order(parameters.draws, samples_.count(), parameters.seed);
    const bool is_large = som.neurons() * som.elements().count() > kLarge;
    const std::uint64_t looks = is_large ? kLooksAtLarge : kLooks;
    SomLearner learner(som);
    for (std::uint64_t step = 0; step < steps; ++step) {
      const double rate = parameters.learning_rate().at(step);
      const double radius = parameters.radius().at(step);
      learner.learn(samples_[order.next()], rate, radius);
      if ((step + 1) * looks / steps == step * looks / steps) continue;
      learner.settle();
      if (!look_at(som, step + 1, steps, rate, radius)) return stopped();
    }
    learner.settle();
    set_map(system_, map_, std::move(som));
    return {};
  }

  bool look_at(const Som& som, std::uint64_t step, std::uint64_t steps, double rate,
               double radius) {
    look_.step = step;
    look_.steps = steps;
    look_.learning_rate = rate;
    look_.radius = radius;
    look_.u_matrix = u_matrix(som);
    look_.winners.clear();
    look_.classes.clear();
    SomWorkspace workspace;
    for (std::size_t i = 0; i < std::min(samples_.count(), kMostSamplesShown); ++i) {
      look_.winners.push_back(som.winner(samples_[i], workspace));
      look_.classes.push_back(classes_.names[classes_.of_sample[i]]);
    }
    return eyes_(look_);
  }

  Result<std::shared_ptr<const SystemModel>> labelled() {
    const Som& som = *som_of(system_, map_);
    SomWorkspace workspace;
    std::vector<std::size_t> winners;
    winners.reserve(samples_.count());
    for (std::size_t i = 0; i < samples_.count(); ++i) {
      winners.push_back(som.winner(samples_[i], workspace));
    }
    look_.done = true;
    if (!look_at(som, look_.steps, look_.steps, look_.learning_rate, look_.radius))
      return stopped();
    auto labels = NeuronLabels::by_majority(winners, classes_.of_sample, som.neurons());
    SystemAnswer answer{look_.module, wanted_.label, classes_.names, std::move(labels)};
    return std::make_shared<const SystemModel>(SystemModel{std::move(system_), std::move(answer)});
  }

  const ViewSystem& wanted_;
  const Recording& recording_;
  std::uint64_t seed_;
  const TrainingEyes& eyes_;
  const std::function<bool()>& goes_on_;
  Classes classes_;
  std::vector<std::size_t> all_;
  System system_;
  std::size_t map_ = 0;
  std::optional<SomParameters> alone_;
  Activations activations_;
  Samples samples_;
  TrainingLook look_;
};

}  // namespace

Result<std::shared_ptr<const SystemModel>> train_visibly(const ViewSystem& system,
                                                         const Recording& recording,
                                                         std::uint64_t seed,
                                                         const TrainingEyes& eyes,
                                                         const std::function<bool()>& goes_on) {
  return VisibleTraining(system, recording, seed, eyes, goes_on).train();
}

}  // namespace somato::live
