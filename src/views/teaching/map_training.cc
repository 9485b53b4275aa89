#include "views/teaching/map_training.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include "maps/reading/sample_reader.h"
#include "somato/graph/evaluation.h"
#include "somato/graph/system_training.h"
#include "somato/maps/labels.h"
#include "somato/maps/som_quality.h"
#include "systems/walk/labelled_map.h"
#include "views/session/viewed_system.h"
#include "views/teaching/held_out_parts.h"

namespace somato::live {
namespace {

constexpr std::uint64_t kLooksAtLarge = 25;
constexpr std::size_t kLarge = std::size_t{1} << 22;  // weights
constexpr std::size_t kMostSamplesShown = 500;        // samples
constexpr std::size_t kHeldOutParts = 3;              // one more training each

tl::unexpected<Error> stopped() {
  return fail(ErrorKind::kInterrupted, "the training was stopped before its end");
}

class VisibleTraining {
 public:
  VisibleTraining(const ViewSystem& wanted, const Recording& recording, std::uint64_t seed,
                  const SnapshotObserver& observer, const std::function<bool()>& should_continue)
      : wanted_(wanted),
        recording_(recording),
        seed_(seed),
        observer_(observer),
        should_continue_(should_continue) {}

  Result<std::shared_ptr<const SystemModel>> train() {
    auto trained = build()
                       .and_then([&] { return learn(); })
                       .and_then([&] { return find_samples(); })
                       .and_then([&] { return find_novelty(); });
    if (!trained) return fail(std::move(trained.error()));
    return labelled();
  }

 private:
  Result<void> build() {
    std::vector<std::string> names;
    for (const Exploration& exploration : recording_.explorations) {
      SOMATO_TRY(auto name, find_label(exploration, wanted_.label));
      names.push_back(std::move(name));
    }
    classes_ = Classes::from_names(names);
    if (classes_.names.size() < 2) {
      return fail(ErrorKind::kData,
                  "training needs explorations with at least two values of the label",
                  wanted_.label, "explore other objects or materials first");
    }
    all_.resize(names.size());
    std::iota(all_.begin(), all_.end(), std::size_t{0});
    SOMATO_TRY(auto system, System::build(wanted_.description, layout_of(recording_)));
    system_ = std::move(system);
    SOMATO_TRY(auto map, answering_map(system_, wanted_.map));
    look_.module = std::move(map);
    map_ = *system_.find(look_.module);
    return {};
  }

  // One exploration after the other, with checks for a stop in between.
  Result<void> evaluate_all(const std::vector<std::size_t>& wanted) {
    for (const std::size_t exploration : all_) {
      if (!should_continue_()) return stopped();
      const std::array<std::size_t, 1> one{exploration};
      auto evaluated = evaluate(system_, recording_, one, wanted, 1, activations_);
      if (!evaluated) return evaluated;
    }
    return {};
  }

  Result<void> learn() {
    activations_ = Activations(system_.modules().size(), all_.size());
    SOMATO_TRY_VOID(evaluate_all(fixed_inputs(system_, {})));
    fixed_ = activations_;
    SystemTraining training;
    training.seed = seed_;
    training.classes = classes_.of_sample;
    training.progress = [&](std::uint64_t done, std::uint64_t total) {
      if (sees_map_) return should_continue_();
      look_.step = done;
      look_.steps = total;
      return observer_(look_);
    };
    training.observer = [&](std::size_t module, const TrainingMoment& moment) {
      return module != map_ || see(moment);
    };
    return train_system(system_, recording_, all_, training, activations_);
  }

  bool see(const TrainingMoment& moment) {
    sees_map_ = moment.step < moment.steps;
    if (moment.weights > kLarge && !is_seldom(moment)) return true;
    look_.step = moment.step;
    look_.steps = moment.steps;
    look_.learning_rate = moment.learning_rate;
    look_.radius = moment.radius;
    if (samples_.count() == 0) samples_ = activations_.values_of(input_of_map()).samples;
    return look_at(moment.map());
  }

  static bool is_seldom(const TrainingMoment& moment) {
    return moment.step * kLooksAtLarge / moment.steps !=
           (moment.step - 1) * kLooksAtLarge / moment.steps;
  }

  std::size_t input_of_map() const { return system_.modules()[map_].inputs.front(); }

  Result<void> find_samples() {
    if (system_.modules()[map_].output.rate == Rate::kFrame) {
      return fail(
          ErrorKind::kUsage,
          "the output map receives one input per frame; training needs one per exploration");
    }
    SOMATO_TRY_VOID(evaluate_all({input_of_map()}));
    samples_ = activations_.values_of(input_of_map()).samples;
    return {};
  }

  // Without enough explorations, or where they do not differ, nothing is unknown.
  Result<void> find_novelty() {
    std::vector<double> scores;
    for (const HeldOutPart& part :
         held_out_parts(classes_.of_sample, kHeldOutParts, Novelty{}.false_alarm_rate)) {
      auto held_out = scores_of(part);
      if (!held_out && held_out.error().kind == ErrorKind::kInterrupted) return stopped();
      if (!held_out) return {};
      scores.insert(scores.end(), held_out->begin(), held_out->end());
    }
    if (scores.empty()) return {};
    const ExplorationValues& inputs = activations_.values_of(input_of_map());
    auto novelty =
        labelled_map(system_, inputs, all_).novelty(std::move(scores), Novelty{}.false_alarm_rate);
    if (novelty) novelty_ = std::move(*novelty);
    return {};
  }

  // By a system that has not learned from these explorations.
  Result<std::vector<double>> scores_of(const HeldOutPart& part) {
    SOMATO_TRY(auto system, System::build(wanted_.description, layout_of(recording_)));
    Activations activations = fixed_;
    SystemTraining training;
    training.seed = seed_;
    training.classes = classes_.of_sample;
    training.progress = [&](std::uint64_t, std::uint64_t) { return should_continue_(); };
    SOMATO_TRY_VOID(train_system(system, recording_, part.training, training, activations));
    SOMATO_TRY_VOID(evaluate(system, recording_, all_, {input_of_map()}, 1, activations));
    return labelled_map(system, activations.values_of(input_of_map()), part.training)
        .held_out_scores(part.held_out);
  }

  LabelledMap labelled_map(const System& system, const ExplorationValues& inputs,
                           const std::vector<std::size_t>& training) const {
    return {*som_of(system, map_), inputs,   classes_.of_sample,
            classes_.names.size(), training, std::nullopt};
  }

  bool look_at(const Som& som) {
    look_.u_matrix = u_matrix(som);
    look_.winners.clear();
    look_.classes.clear();
    SomWorkspace workspace;
    for (std::size_t i = 0; i < std::min(samples_.count(), kMostSamplesShown); ++i) {
      look_.winners.push_back(som.winner(samples_[i], workspace));
      look_.classes.push_back(classes_.names[classes_.of_sample[i]]);
    }
    return observer_(look_);
  }

  Result<std::shared_ptr<const SystemModel>> labelled() {
    const Som& som = *som_of(system_, map_);
    const std::vector<std::size_t> winners = first_winners(SampleReader(som).read(samples_));
    look_.done = true;
    look_.step = look_.steps;
    if (!look_at(som)) return stopped();
    NeuronVotes votes(som.neurons());
    votes.add_all(winners, classes_.of_sample);
    SystemAnswer answer{look_.module,   wanted_.label,    classes_.names,
                        votes.labels(), std::move(votes), novelty_};
    return std::make_shared<const SystemModel>(SystemModel{std::move(system_), std::move(answer)});
  }

  const ViewSystem& wanted_;
  const Recording& recording_;
  std::uint64_t seed_;
  const SnapshotObserver& observer_;
  const std::function<bool()>& should_continue_;
  Classes classes_;
  std::vector<std::size_t> all_;
  System system_;
  std::size_t map_ = 0;
  Activations activations_;
  Activations fixed_;  // what no training changes
  std::optional<Novelty> novelty_;
  Samples samples_;
  TrainingSnapshot look_;
  bool sees_map_ = false;  // it learns now, and is looked at
};

}  // namespace

Result<std::shared_ptr<const SystemModel>> train_visibly(
    const ViewSystem& system, const Recording& recording, std::uint64_t seed,
    const SnapshotObserver& observer, const std::function<bool()>& should_continue) {
  return VisibleTraining(system, recording, seed, observer, should_continue).train();
}

}  // namespace somato::live
