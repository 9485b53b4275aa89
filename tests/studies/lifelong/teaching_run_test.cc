#include "studies/lifelong/teaching_run.h"

#include <gtest/gtest.h>

#include <optional>

#include "recordings/support/made_recording.h"
#include "somato/core/random.h"
#include "somato/graph/further_learning.h"
#include "somato/graph/system_model.h"
#include "studies/lifelong/novelty_run.h"
#include "studies/support/made_study.h"
#include "studies/support/study_results.h"

namespace somato {
namespace {

using testing::json_of;
using testing::objects_apart;
using testing::outcome_of;
using testing::study_from;
using testing::system_of;
using testing::values_of;
using Numbers = std::vector<std::size_t>;

constexpr std::size_t kTrials = 8;
const Progress kTaughtOn = [](std::uint64_t, std::uint64_t) { return true; };

StudyDescription teaching_study(const std::string& kind, const std::string& settings = "") {
  return study_from(
      "[study]\nname = 'teaching'\nseeds = 2\nprotocols = ['leave_class_out']\nfolds = 4\n"
      "whitening_shrinkage = 1\n"
      "false_alarm_rate = 0.2\ntaught_per_class = 3\n" +
      settings +
      "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
      "[module.map]\ntype = '" +
      kind + "'\ninput = 'closed'\n" +
      (kind == "som" ? "rows = 5\ncolumns = 5\niterations = 300\n"
                     : "most_neurons = 40\nhabituation_threshold = 2.0\ninsertion_share = 1.0\n"
                       "distance_unit = 50.0\n"));
}

std::string name_of(const Recording& recording, std::size_t exploration) {
  return recording.explorations[exploration].labels.front().value;
}

// The same system, taught from the recording as a saved model is, and its answers counted by
// searching all neurons.
class Oracle {
 public:
  Oracle(const StudyDescription& description, const Recording& recording,
         const PreparedStudy& prepared, const Fold& fold, std::uint64_t seed)
      : recording_(recording), fold_(fold), learned_(fold.training) {
    auto trained = train_fold(description, prepared, fold, seed, kTaughtOn).value();
    novelty_ = find_novelty(description, prepared, trained, fold.training, seed, kTaughtOn).value();
    outcome_ = test_fold(trained, prepared, fold, {});
    trained_ = train_fold(description, prepared, fold, seed, kTaughtOn).value();
    model_.emplace(std::move(trained.system), answer());
    Random random(seed, Stream::kDesign);
    Numbers shuffled;
    for (const std::size_t place : random_order(fold.test.size(), random)) {
      shuffled.push_back(fold.test[place]);
    }
    named_.assign(shuffled.begin(), shuffled.begin() + 3);
    others_.assign(shuffled.begin() + 3, shuffled.end());
  }

  TeachingOutcome taught() {
    TeachingOutcome expected;
    expected.taught_tested = others_.size();
    expected.known_tested = fold_.known.size();
    expected.names = 3;
    const std::vector<std::string> at_first = answers(fold_.known);
    expected.stages.push_back(stage(at_first));
    for (const std::size_t one : named_) {
      if (!teach(*model_, recording_, one, name_of(recording_, one))) ++expected.refused;
      learned_.push_back(one);
      expected.stages.push_back(stage(at_first));
    }
    return expected;
  }

  // Can be taken once; test_teaching() needs it.
  TrainedFold take_trained() { return std::move(*trained_); }
  const Novelty& novelty() const { return novelty_; }
  const Numbers& winners() const { return outcome_.training_winners; }

 private:
  // With the classes of the training only, as a study saves it.
  SystemAnswer answer() {
    std::vector<std::string> names;
    NeuronVotes votes(som_of(trained_->system, 2)->neurons());
    Novelty novelty = novelty_;
    novelty.scales.clear();
    for (std::size_t i = 0; i < fold_.training.size(); ++i) {
      const std::string name = name_of(recording_, fold_.training[i]);
      if (names.empty() || names.back() != name) {
        names.push_back(name);
        novelty.scales.push_back(novelty_.scales[fold_.training[i] / kTrials]);
      }
      votes.add(outcome_.training_winners[i], names.size() - 1);
    }
    return {"map", "object", names, votes.labels(), votes, novelty};
  }

  SignalView input(std::size_t exploration) const {
    return SignalView::dense(recording_.explorations[exploration].channels[0].frames.row(
        recording_.explorations[exploration].channels[0].frames.rows() - 1));
  }

  // Name and most similar class.
  std::pair<std::string, std::string> read(std::size_t exploration) const {
    const SystemAnswer& answer = *model_->answer;
    const Som& som = *som_of(model_->system, 2);
    SomWorkspace workspace;
    double least = 0.0;
    std::optional<std::size_t> label;
    for (std::size_t neuron = 0; neuron < som.neurons(); ++neuron) {
      if (!answer.labels[neuron]) continue;
      const double distance = som.distance(input(exploration), neuron, workspace);
      if (label && distance >= least) continue;
      least = distance;
      label = answer.labels[neuron];
    }
    const bool is_far = least > answer.novelty->threshold * answer.novelty->scales[*label];
    return {is_far ? "unknown" : answer.classes[*label], answer.classes[*label]};
  }

  std::vector<std::string> answers(const Numbers& explorations) const {
    std::vector<std::string> names;
    for (const std::size_t one : explorations) names.push_back(read(one).first);
    return names;
  }

  std::string nearest_learned(std::size_t exploration) const {
    double least = 0.0;
    std::optional<std::size_t> nearest;
    for (const std::size_t one : learned_) {
      double sum = 0.0;
      for (std::size_t d = 0; d < input(one).values.size(); ++d) {
        const double difference =
            double{input(one).values[d]} - double{input(exploration).values[d]};
        sum += difference * difference;
      }
      if (nearest && sum >= least) continue;
      least = sum;
      nearest = one;
    }
    return name_of(recording_, *nearest);
  }

  RightNames right(const Numbers& explorations) const {
    RightNames counts;
    for (const std::size_t one : explorations) {
      const std::string name = name_of(recording_, one);
      counts.answered += read(one).first == name ? 1 : 0;
      counts.nearest += read(one).second == name ? 1 : 0;
      counts.baseline += nearest_learned(one) == name ? 1 : 0;
    }
    return counts;
  }

  TeachingStage stage(const std::vector<std::string>& at_first) const {
    TeachingStage stage{right(others_), right(fold_.known), 0};
    for (std::size_t i = 0; i < fold_.known.size(); ++i) {
      stage.known_changed += read(fold_.known[i]).first != at_first[i] ? 1 : 0;
    }
    return stage;
  }

  const Recording& recording_;
  const Fold& fold_;
  std::optional<TrainedFold> trained_;
  Novelty novelty_;
  FoldOutcome outcome_;
  std::optional<SystemModel> model_;
  Numbers named_;
  Numbers others_;
  Numbers learned_;
};

// Noise so large that objects overlap, so that teaching changes other answers.
TEST(TeachingRun, CountsWhatAModelAnswersThatIsTaught) {
  const Recording recording = objects_apart(4, kTrials, 300.0, 3);
  for (const std::string kind : {"som", "growing_when_required"}) {
    const StudyDescription description = teaching_study(kind);
    const auto prepared = prepare_study(description, recording, nullptr, 1).value();
    std::vector<TeachingOutcome> sums(2);
    for (std::size_t s = 0; s < 2; ++s) {
      for (const Fold& fold : folds(Protocol::kLeaveClassOut, prepared.samples)) {
        Oracle oracle(description, recording, prepared, fold, 1 + s);
        const auto taught = test_teaching(description.study, prepared, fold, oracle.take_trained(),
                                          oracle.winners(), oracle.novelty(), 1 + s);
        EXPECT_EQ(taught.value(), oracle.taught()) << kind;
        sums[s].add(*taught);
      }
      EXPECT_GT(sums[s].stages.back().known_changed, 0U) << kind;
      EXPECT_GT(sums[s].stages.back().taught.answered, 0U) << kind;
    }
    const StudyOutcome outcome = outcome_of(description, recording);
    const ProtocolResults& results = system_of(outcome, "leave_class_out");
    for (const Metric& metric : teaching_metrics(sums)) {
      EXPECT_EQ(values_of(results, metric.name), metric.values) << metric.name;
    }
  }
}

TEST(TeachingRun, ObjectsApartAreKnownAfterOneName) {
  const StudyOutcome outcome =
      outcome_of(teaching_study("som"), objects_apart(4, kTrials, 20.0, 3));
  const ProtocolResults& results = system_of(outcome, "leave_class_out");
  for (const double share : values_of(results, "taught_accuracy_of_nearest_after_1")) {
    EXPECT_EQ(share, 1.0);
  }
  for (const double share : values_of(results, "known_changed_after_3")) EXPECT_EQ(share, 0.0);
}

// A map whose neurons all have names cannot learn another one.
TEST(TeachingRun, CountsRefusedNames) {
  const Recording recording = objects_apart(3, kTrials, 20.0, 3);
  const StudyDescription small = study_from(
      "[study]\nname = 'small'\nseeds = 1\nprotocols = ['leave_class_out']\nfolds = 4\n"
      "false_alarm_rate = 0.2\ntaught_per_class = 2\n"
      "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.closed]\ntype = 'last'\ninput = 'joints'\n"
      "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 1\ncolumns = 2\n");
  const StudyOutcome outcome = outcome_of(small, recording);
  EXPECT_EQ(values_of(system_of(outcome, "leave_class_out"), "names_refused"),
            (std::vector<double>{1.0}));
}

std::string problem_of(const StudyDescription& description, const Recording& recording) {
  const auto outcome = run_study(description, recording, {});
  return outcome ? "" : to_string(outcome.error());
}

TEST(TeachingRun, NeedsExplorationsThatAreNotNamed) {
  const std::string problem = problem_of(teaching_study("som"), objects_apart(4, 3, 20.0, 3));
  EXPECT_NE(problem.find("3 would be named"), std::string::npos) << problem;
  EXPECT_NE(problem.find("taught_per_class"), std::string::npos) << problem;
}

TEST(TeachingRun, ResultsDoNotDependOnThreads) {
  const Recording recording = objects_apart(4, kTrials, 300.0, 3);
  const StudyDescription description = teaching_study("growing_when_required");
  StudyOptions threads;
  threads.threads = 2;
  EXPECT_EQ(json_of(outcome_of(description, recording, threads)),
            json_of(outcome_of(description, recording)));
}

}  // namespace
}  // namespace somato
