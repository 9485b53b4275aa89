#include "studies/lifelong/object_after_object.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

#include "base/core/values_at.h"
#include "maps/reading/sample_reader.h"
#include "somato/core/random.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "somato/maps/som_training.h"
#include "studies/lifelong/replayed_samples.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// One object: the numbers of its samples among the inputs of the map.
struct MetObject {
  std::size_t the_class = 0;
  Numbers training;
  Numbers test;
};

// Vectors with their classes.
struct LearnedVectors {
  Samples samples;
  Numbers classes;
};

// The objects in their order; `inputs` has the input of the map for every sample of the fold.
std::vector<MetObject> objects_in_order(const Classes& classes, const Fold& fold,
                                        const ExplorationValues& inputs, const Numbers& order) {
  std::vector<MetObject> objects;
  objects.reserve(order.size());
  const auto of_class = [&](const Numbers& samples, std::size_t the_class) {
    Numbers chosen;
    std::copy_if(samples.begin(), samples.end(), std::back_inserter(chosen),
                 [&](std::size_t sample) { return classes.of_sample[sample] == the_class; });
    return inputs.places_of(chosen);
  };
  for (const std::size_t one : order) {
    objects.push_back({one, of_class(fold.training, one), of_class(fold.test, one)});
  }
  return objects;
}

// The training samples of one object, and the rest of the fold as a test.
Fold fold_of_first(const Classes& classes, const Fold& fold, std::size_t first) {
  Fold one;
  for (const std::size_t sample : fold.training) {
    (classes.of_sample[sample] == first ? one.training : one.test).push_back(sample);
  }
  one.test.insert(one.test.end(), fold.test.begin(), fold.test.end());
  std::sort(one.test.begin(), one.test.end());
  return one;
}

// A map that learns sets of vectors one after another, whose neurons are named by votes.
class LearningMap {
 public:
  using Learn = std::function<Result<NeuronOrigins>(const LearnedVectors&)>;
  using Map = std::function<const Som&()>;

  LearningMap(Learn learn, Map map) : learn_(std::move(learn)), map_(std::move(map)) {}

  Result<void> learn(const LearnedVectors& learned) {
    SOMATO_TRY(const auto origins, learn_(learned));
    votes_ = votes_.neurons() == 0 ? NeuronVotes(origins.size()) : votes_.moved_to(origins);
    Numbers all(learned.classes.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    votes_.add_all(winners(learned.samples, all), learned.classes);
    return {};
  }

  Numbers classify(const Samples& inputs, const Numbers& places) const {
    const NeuronLabels labels = votes_.labels();
    return labels.classify(map(), inputs.subset(places));
  }

  Numbers winners(const Samples& inputs, const Numbers& places) const {
    return first_winners(SampleReader(map()).read(inputs, places));
  }

  const Som& map() const { return map_(); }
  const NeuronVotes& votes() const { return votes_; }

 private:
  Learn learn_;
  Map map_;
  NeuronVotes votes_;
};

NeuronOrigins new_neurons(std::size_t count) {
  return NeuronOrigins(count);
}

// A SOM with default parameters, of the size that is automatic for `samples` samples; it learns
// each object with a schedule of its own.
class PlainSom {
 public:
  PlainSom(std::size_t samples, std::uint64_t seed, Progress progress)
      : progress_(std::move(progress)) {
    decide_size(parameters_, samples);
    parameters_.seed = seed;
  }

  Result<NeuronOrigins> learn(const Samples& samples) {
    TrainingOptions options{1, progress_, {}, {}};
    if (som_) options.start = &*som_;
    SOMATO_TRY(auto trained, train_som(parameters_, samples, options));
    NeuronOrigins origins = new_neurons(trained.neurons());
    if (som_) {
      for (std::size_t neuron = 0; neuron < origins.size(); ++neuron) origins[neuron] = neuron;
    }
    som_ = std::move(trained);
    return origins;
  }

  const Som& map() const { return *som_; }

 private:
  SomParameters parameters_;
  Progress progress_;
  std::optional<Som> som_;
};

// Counts what is named rightly after each object.
class Tests {
 public:
  Tests(const Samples& inputs, const std::vector<MetObject>& objects)
      : inputs_(inputs), objects_(objects) {}

  template <typename Classify>  // classes of the samples at places
  void add(std::size_t stage, const Classify& classify, LearnerTests& tests) const {
    Numbers right;
    for (std::size_t object = 0; object <= stage; ++object) {
      const Numbers named = classify(inputs_, objects_[object].test);
      right.push_back(static_cast<std::size_t>(
          std::count(named.begin(), named.end(), objects_[object].the_class)));
    }
    tests.right.push_back(std::move(right));
  }

  // The nearest of the kept samples of all objects so far names a sample; `kept` has those of each
  // object.
  LearnerTests of_nearest(const std::vector<Numbers>& kept) const {
    LearnerTests tests;
    std::vector<std::pair<std::size_t, std::size_t>> known;  // place, class
    for (std::size_t stage = 0; stage < objects_.size(); ++stage) {
      for (const std::size_t place : kept[stage]) {
        known.emplace_back(place, objects_[stage].the_class);
      }
      std::sort(known.begin(), known.end());
      Numbers places;
      places.reserve(known.size());
      for (const auto& [place, the_class] : known) places.push_back(place);
      const auto classify = [&](const Samples& inputs, const Numbers& tested) {
        Numbers named = nearest_neighbours(inputs, places, tested);
        for (std::size_t& one : named) {
          one =
              std::lower_bound(known.begin(), known.end(), std::pair(one, std::size_t{0}))->second;
        }
        return named;
      };
      add(stage, classify, tests);
    }
    tests.vectors = known.size();
    return tests;
  }

 private:
  const Samples& inputs_;
  const std::vector<MetObject>& objects_;
};

// One fold: the map of the system and a plain SOM learn the same objects with the same replay.
class ObjectSequence {
 public:
  ObjectSequence(const StudyParameters& study, const Samples& inputs,
                 std::vector<MetObject> objects, std::uint64_t seed)
      : study_(study),
        inputs_(inputs),
        objects_(std::move(objects)),
        random_(seed, Stream::kDesign),
        tests_(inputs_, objects_) {}

  Result<void> learn(std::vector<LearningMap>& maps) {
    outcome_.learners.resize(maps.size());
    for (std::size_t stage = 0; stage < objects_.size(); ++stage) {
      for (std::size_t m = 0; m < maps.size(); ++m) {
        const LearnedVectors learned = vectors_for(stage, maps[m]);
        SOMATO_TRY_VOID(maps[m].learn(learned));
        tests_.add(
            stage,
            [&](const Samples& inputs, const Numbers& places) {
              return maps[m].classify(inputs, places);
            },
            outcome_.learners[m]);
      }
      keep(objects_[stage]);
    }
    for (std::size_t m = 0; m < maps.size(); ++m) {
      outcome_.learners[m].vectors = maps[m].map().neurons() + kept_.size();
    }
    return {};
  }

  // After learn(): the baselines, with all vectors or with as many as the first map.
  ObjectsOutcome outcome() {
    std::vector<Numbers> all;
    std::vector<Numbers> as_many;
    const std::size_t memory = outcome_.learners.front().vectors;
    for (std::size_t object = 0; object < objects_.size(); ++object) {
      const std::size_t share =
          memory / objects_.size() + (object < memory % objects_.size() ? 1 : 0);
      all.push_back(objects_[object].training);
      as_many.push_back(
          choose_samples(study_.replay_choice, share, inputs_, objects_[object].training, random_));
      outcome_.tested.push_back(objects_[object].test.size());
    }
    outcome_.learners.push_back(tests_.of_nearest(all));
    outcome_.learners.push_back(tests_.of_nearest(as_many));
    outcome_.elements = inputs_.size();
    return std::move(outcome_);
  }

 private:
  // The object's own samples, those kept of earlier ones, and generated ones for these.
  LearnedVectors vectors_for(std::size_t stage, const LearningMap& map) {
    SampleCollector vectors;
    LearnedVectors learned;
    const auto add = [&](const SignalView& vector, std::size_t the_class) {
      vectors.add(vector);
      learned.classes.push_back(the_class);
    };
    for (const std::size_t place : objects_[stage].training) {
      add(inputs_[place], objects_[stage].the_class);
    }
    for (const auto& [place, the_class] : kept_) add(inputs_[place], the_class);
    for (std::size_t earlier = 0; earlier < stage && study_.generated_per_object > 0; ++earlier) {
      const Matrix<float> generated =
          generated_vectors(study_.generated_per_object, study_.generated_spread, map.map(),
                            map.votes(), objects_[earlier].the_class, random_);
      for (std::size_t row = 0; row < generated.rows(); ++row) {
        add(SignalView::dense(generated.row(row)), objects_[earlier].the_class);
      }
    }
    learned.samples = vectors.samples();
    return learned;
  }

  void keep(const MetObject& object) {
    for (const std::size_t place : choose_samples(study_.replay_choice, study_.replay_per_object,
                                                  inputs_, object.training, random_)) {
      kept_.emplace_back(place, object.the_class);
    }
  }

  const StudyParameters& study_;
  const Samples& inputs_;
  std::vector<MetObject> objects_;
  Random random_;
  Tests tests_;
  std::vector<std::pair<std::size_t, std::size_t>> kept_;  // place, class
  ObjectsOutcome outcome_;
};

// Describes the map of the system after the last object.
void describe_map(const LearningMap& map, const PreparedStudy& prepared, const Fold& fold,
                  const ExplorationValues& inputs, FoldOutcome& outcome) {
  const auto winners_of = [&](const Numbers& samples) {
    return map.winners(inputs.samples, inputs.places_of(samples));
  };
  outcome.map.grid = map.map().grid();
  outcome.training_winners = winners_of(fold.training);
  outcome.winners = winners_of(fold.test);
  outcome.objects.named = map.classify(inputs.samples, inputs.places_of(fold.test));
  outcome.objects.neurons = map.map().neurons();
  outcome.altered.resize(prepared.alterations.size());
}

}  // namespace

std::vector<std::size_t> order_of_objects(std::size_t objects, std::uint64_t seed) {
  Random random(seed, Stream::kSizeOrder);
  return random_order(objects, random);
}

Result<FoldOutcome> learn_object_after_object(
    const StudyDescription& description, const PreparedStudy& prepared, const Fold& fold,
    std::uint64_t seed, const Progress& progress,
    const std::function<Neighbours(const TrainedFold&)>& nearest) {
  const Classes& classes = prepared.classes();
  const std::set<std::size_t> objects(prepared.samples.classes.begin(),
                                      prepared.samples.classes.end());
  const Numbers order =
      values_at(Numbers(objects.begin(), objects.end()), order_of_objects(objects.size(), seed));
  SOMATO_TRY(auto trained, train_fold(description, prepared,
                                      fold_of_first(classes, fold, order.front()), seed, progress));
  const Samples& inputs = trained.inputs.samples;
  bool is_first = true;  // train_fold() has learned the first object
  const auto learn = [&](const LearnedVectors& learned) -> Result<NeuronOrigins> {
    if (std::exchange(is_first, false)) {
      return new_neurons(som_of(trained.system, prepared.map)->neurons());
    }
    return learn_further(trained.system, prepared.map, learned.samples,
                         {seed, progress, 1, learned.classes});
  };
  PlainSom plain(fold.training.size(), seed, progress);
  std::vector<LearningMap> maps;
  maps.emplace_back(learn, [&]() -> const Som& { return *som_of(trained.system, prepared.map); });
  maps.emplace_back([&](const LearnedVectors& learned) { return plain.learn(learned.samples); },
                    [&]() -> const Som& { return plain.map(); });
  ObjectSequence sequence(description.study, inputs,
                          objects_in_order(classes, fold, trained.inputs, order), seed);
  SOMATO_TRY_VOID(sequence.learn(maps));
  FoldOutcome outcome;
  outcome.objects = sequence.outcome();
  describe_map(maps.front(), prepared, fold, trained.inputs, outcome);
  if (nearest) outcome.nearest = nearest(trained);
  return outcome;
}

}  // namespace somato
