#include "studies/lifelong/teaching_run.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/core/values_at.h"
#include "somato/core/random.h"
#include "somato/graph/answers.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "studies/measures/nearest_neighbour.h"

namespace somato {
namespace {

using Numbers = std::vector<std::size_t>;

// The class left out gets the scale that a new name has.
Novelty without_class(Novelty novelty, std::size_t left_out) {
  Novelty others = novelty;
  others.scales.erase(others.scales.begin() + static_cast<std::ptrdiff_t>(left_out));
  others.add_classes(novelty.scales.size());
  novelty.scales[left_out] = others.scales.back();
  return novelty;
}

// The explorations of the class left out: those that are named, and the others.
struct Division {
  Numbers named;
  Numbers tested;
};

Division divide(const Numbers& explorations, std::size_t named, std::uint64_t seed) {
  Random random(seed, Stream::kDesign);
  Division division;
  for (const std::size_t place : random_order(explorations.size(), random)) {
    Numbers& part = division.named.size() < named ? division.named : division.tested;
    part.push_back(explorations[place]);
  }
  std::sort(division.tested.begin(), division.tested.end());
  return division;
}

// A system that is given names, and its tests.
class TaughtSystem {
 public:
  TaughtSystem(const PreparedStudy& prepared, const Fold& fold, Division left_out,
               TrainedFold trained, SystemAnswer answer)
      : prepared_(prepared),
        fold_(fold),
        left_out_(std::move(left_out)),
        inputs_(std::move(trained.inputs)),
        vectors_(std::move(trained.vectors)),
        model_{std::move(trained.system), std::move(answer)},
        learned_(fold.training) {
    outcome_.taught_tested = left_out_.tested.size();
    outcome_.known_tested = fold.known.size();
    first_answers_ = answers(fold_.known);
    test();
  }

  Result<void> teach() {
    for (const std::size_t exploration : left_out_.named) {
      SOMATO_TRY_VOID(teach(exploration));
      learned_.insert(std::upper_bound(learned_.begin(), learned_.end(), exploration), exploration);
      test();
    }
    return {};
  }

  const TeachingOutcome& outcome() const { return outcome_; }

 private:
  const std::string& name_of(std::size_t exploration) const {
    const Classes& classes = prepared_.classes();
    return classes.names[classes.of_sample[exploration]];
  }

  bool is_full() const {
    const NeuronLabels& labels = model_.answer->labels;
    return labels.labelled().size() == labels.neurons();
  }

  Result<void> teach(std::size_t exploration) {
    ++outcome_.names;
    const std::size_t place = inputs_.places_of({&exploration, 1}).front();
    const auto taught = somato::teach(model_, inputs_.samples[place], name_of(exploration));
    if (taught) return {};
    if (!is_full()) return fail(taught.error());
    ++outcome_.refused;
    return {};
  }

  std::vector<InputAnswer> answers(const Numbers& explorations) const {
    return answers_to(model_, inputs_.samples.subset(inputs_.places_of(explorations)));
  }

  std::string named(const InputAnswer& answer) const { return answer.name(model_.answer->classes); }

  RightNames right(const Numbers& explorations, const std::vector<InputAnswer>& given) const {
    const Numbers& classes = prepared_.classes().of_sample;
    const Numbers nearest = nearest_neighbours(vectors_.samples, vectors_.places_of(learned_),
                                               vectors_.places_of(explorations));
    RightNames counts;
    for (std::size_t i = 0; i < explorations.size(); ++i) {
      const std::size_t right = classes[explorations[i]];
      counts.answered += named(given[i]) == name_of(explorations[i]) ? 1 : 0;
      counts.nearest += given[i].nearest == right ? 1 : 0;
      counts.baseline += classes[vectors_.explorations[nearest[i]]] == right ? 1 : 0;
    }
    return counts;
  }

  void test() {
    const std::vector<InputAnswer> of_known = answers(fold_.known);
    TeachingStage stage{right(left_out_.tested, answers(left_out_.tested)),
                        right(fold_.known, of_known), 0};
    for (std::size_t i = 0; i < of_known.size(); ++i) {
      stage.known_changed += named(of_known[i]) != named(first_answers_[i]) ? 1 : 0;
    }
    outcome_.stages.push_back(stage);
  }

  const PreparedStudy& prepared_;
  const Fold& fold_;
  Division left_out_;
  ExplorationValues inputs_;
  ExplorationValues vectors_;
  SystemModel model_;
  Numbers learned_;  // trained on or named, ascending
  std::vector<InputAnswer> first_answers_;
  TeachingOutcome outcome_;
};

}  // namespace

Result<TeachingOutcome> test_teaching(const StudyParameters& study, const PreparedStudy& prepared,
                                      const Fold& fold, TrainedFold trained, const Numbers& winners,
                                      const Novelty& novelty, std::uint64_t seed) {
  const std::size_t left_out = prepared.classes().of_sample[fold.test.front()];
  SystemAnswer answer = answer_of(
      trained.system, prepared.map, study.label, prepared.classes().names, winners,
      values_at(prepared.classes().of_sample, fold.training), without_class(novelty, left_out));
  TaughtSystem system(prepared, fold, divide(fold.test, study.taught_per_class, seed),
                      std::move(trained), std::move(answer));
  SOMATO_TRY_VOID(system.teach());
  return system.outcome();
}

}  // namespace somato
