#include "studies/run/reproduction_run.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>
#include <vector>

#include "base/files/toml_file.h"
#include "recordings/explorations/content_hash.h"
#include "studies/support/made_study.h"

namespace somato {
namespace {

using testing::grasps;

std::shared_ptr<const PairedRecording> paired(const std::string& name, Recording recording) {
  RecordingInfo info{name, "made", 3, content_hash(recording), recording.explorations.size()};
  return std::make_shared<const PairedRecording>(
      PairedRecording{std::move(info), std::move(recording)});
}

// As many recordings of grasps as a test wants.
class MadeRecordings : public RecordingSource {
 public:
  MadeRecordings(std::size_t count, bool given) : given_(given) {
    for (std::size_t i = 0; i < count; ++i) {
      recordings_.push_back(paired("r" + std::to_string(i), grasps(2, 3, i + 1)));
    }
  }

  bool is_given() const override { return given_; }
  Result<std::size_t> count(const ReproductionPart& part) const override {
    if (!recordings_.empty()) return recordings_.size();
    return fail(ErrorKind::kUsage, "there are none", part.system, "give some");
  }
  Result<std::shared_ptr<const PairedRecording>> get(const ReproductionPart&,
                                                     std::size_t index) override {
    return recordings_[index];
  }
  Result<std::string> identity(const ReproductionPart&, std::size_t index) override {
    return recordings_[index]->info.hash;
  }

  std::vector<std::shared_ptr<const PairedRecording>> recordings_;
  bool given_;
};

ReproductionPart part(const std::string& name, const std::string& channel = "joints") {
  const Table file =
      parse_toml("[study]\nname = '" + name + "'\nprotocols = ['train_is_test']\n" +
                     "wrong_groupings = 2\n[module.joints]\ntype = 'channel'\nchannel = '" +
                     channel + "'\n[module.closed]\ntype = 'last'\ninput = 'joints'\n" +
                     "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 2\ncolumns = 2\n" +
                     "iterations = 20\n[explore]\nbody = 'lucs2'\n[explore.plan]\nnoise = 0.5\n",
                 "file")
          .value();
  ReproductionPlan plan;
  EXPECT_TRUE(add_to_plan({name, file}, {}, plan));
  return plan.parts.front();
}

PartEvents quiet() {
  return {[](std::size_t, std::size_t) { return Progress(); },
          [](std::size_t) { return std::string(); }};
}

Results reproduced(const ReproductionPlan& plan, MadeRecordings& recordings,
                   const PairOptions& options) {
  PartRunner runner(options, recordings);
  return run_reproduction(plan, runner, true, [](std::size_t) { return quiet(); }).value();
}

TEST(PartRunner, SpreadsPairsOverRecordingsAndFindsWhatStudiesFind) {
  MadeRecordings recordings(2, false);
  const PairOptions options{3, 40};
  PartRunner runner(options, recordings);
  std::vector<std::size_t> studied;
  PartEvents events = quiet();
  events.studied = [&](std::size_t index, const StudyDescription&, const StudyOutcome&,
                       PartResults& found) {
    studied.push_back(index);
    EXPECT_EQ(found.recordings.size(), index + 1);
    found.model = ModelFile{"kept.somato", "", 40};
    return Result<void>();
  };
  const PartRun run = runner.run(part("small"), events).value();
  EXPECT_FALSE(run.misfit);
  EXPECT_EQ(studied, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(run.results.model->path, "kept.somato");
  ASSERT_EQ(run.results.pairs.size(), 3U);
  const std::vector<std::pair<std::size_t, std::uint64_t>> expected{{0, 40}, {0, 41}, {1, 42}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(run.results.pairs[i].recording, expected[i].first);
    EXPECT_EQ(run.results.pairs[i].seed, expected[i].second);
    StudyDescription single = part("small").description;
    single.study.first_seed = expected[i].second;
    single.study.seeds = 1;
    const auto study = run_study(single, recordings.recordings_[expected[i].first]->recording);
    EXPECT_EQ(run.results.protocols[0].runs[i].winners,
              study->results.protocols[0].runs[0].winners);
  }
  EXPECT_EQ(run.results.recordings[1], recordings.recordings_[1]->info);
}

TEST(PartRunner, APartMayWantFewerPairsThanThereAreRecordings) {
  MadeRecordings recordings(3, false);
  ReproductionPart few = part("small");
  few.pairs = 1;
  const PairOptions options{10, 1};
  const PartRun run = PartRunner(options, recordings).run(few, quiet()).value();
  EXPECT_EQ(run.results.recordings.size(), 1U);
  EXPECT_EQ(run.results.pairs.size(), 1U);
}

TEST(PartRunner, SaysHowItExploredUnlessRecordingsWereGiven) {
  const PairOptions options{1, 1};
  for (const bool given : {false, true}) {
    MadeRecordings recordings(1, given);
    const PartResults found =
        PartRunner(options, recordings).run(part("small"), quiet()).value().results;
    EXPECT_EQ(found.parameters.back().part == "explore.plan", !given);
    EXPECT_EQ(found.study.ends_with("[explore.plan]\nnoise = 0.5\n"), !given);
    ReproductionPart as_it_stands = part("small");
    as_it_stands.description.text = "# a file";
    EXPECT_EQ(PartRunner(options, recordings).run(as_it_stands, quiet()).value().results.study,
              "# a file");
  }
}

TEST(PartRunner, NamesTheRecordingsItTestsWith) {
  MadeRecordings recordings(2, false);
  PairOptions options{2, 1};
  options.test_data = paired("test", grasps(2, 2, 9));
  const auto found = PartRunner(options, recordings).run(part("small"), quiet()).value().results;
  ASSERT_EQ(found.test_recordings.size(), 2U);
  EXPECT_EQ(found.test_recordings[1].name, "test");
  EXPECT_EQ(found.protocols.back().protocol, "test_data");
  EXPECT_EQ(found.protocols.back().samples, 4U);
}

TEST(PartRunner, AnotherPartOrOtherPairsHaveAnotherIdentity) {
  MadeRecordings recordings(2, false);
  MadeRecordings others(1, false);
  PairOptions tested{2, 1};
  tested.test_data = paired("test", grasps(2, 2, 9));
  ReproductionPart varied = part("small");
  varied.variation = "other";
  const auto identity = [](const PairOptions& options, MadeRecordings& source,
                           const ReproductionPart& of) {
    return PartRunner(options, source).identity(of).value();
  };
  const std::set<std::string> all{
      identity({2, 1}, recordings, part("small")), identity({3, 1}, recordings, part("small")),
      identity({2, 2}, recordings, part("small")), identity({2, 1}, others, part("small")),
      identity({2, 1}, recordings, part("large")), identity({2, 1}, recordings, varied),
      identity(tested, recordings, part("small"))};
  EXPECT_EQ(all.size(), 7U);
  EXPECT_EQ(identity({2, 1}, recordings, part("small")),
            identity({2, 1, 4}, recordings, part("small")));
}

TEST(RunReproduction, JudgesClaimsAndListsWhatDoesNotFit) {
  MadeRecordings given(2, true);
  ReproductionPlan plan{{part("small"), part("deaf", "sound")}, {}};
  plan.claims.push_back({});
  plan.claims[0].system = "small";
  plan.claims[0].metric = "accuracy";
  plan.claims[0].at_least = 0.0;
  const Results results = reproduced(plan, given, {2, 1});
  ASSERT_EQ(results.parts.size(), 1U);
  EXPECT_EQ(results.parts[0].system, "small");
  ASSERT_EQ(results.claims.size(), 1U);
  EXPECT_EQ(results.claims[0].values.size(), 2U);
  ASSERT_EQ(results.not_applicable.size(), 1U);
  EXPECT_EQ(results.not_applicable[0].system, "deaf");
  EXPECT_NE(results.not_applicable[0].reason.find("unknown channel 'sound'"), std::string::npos);
  MadeRecordings none(0, true);
  EXPECT_EQ(reproduced(plan, none, {2, 1}).not_applicable.size(), 2U);
}

// The recording that a part explored for itself must fit it, and a named recording must be run.
TEST(RunReproduction, AMisfitIsAnErrorWhereNothingIsPassedOver) {
  const ReproductionPlan plan{{part("deaf", "sound")}, {}};
  const PairOptions options{2, 1};
  const auto events = [](std::size_t) { return quiet(); };
  MadeRecordings given(1, true);
  PartRunner of_given(options, given);
  EXPECT_FALSE(run_reproduction(plan, of_given, false, events));
  MadeRecordings explored(1, false);
  PartRunner of_explored(options, explored);
  EXPECT_FALSE(run_reproduction(plan, of_explored, true, events));
}

TEST(TitleOf, HasQuestionAndVariation) {
  ReproductionPart one = part("small");
  EXPECT_EQ(title_of(one), "small");
  one.question = "why";
  one.variation = "wide";
  EXPECT_EQ(title_of(one), "why: small, wide");
}

}  // namespace
}  // namespace somato
