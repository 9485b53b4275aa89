#include "somato/studies/information.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "base/files/toml_file.h"
#include "recordings/support/made_recording.h"
#include "studies/support/made_study.h"

namespace somato {
namespace {

// Things on a line: three sizes of two kinds. Each was felt twice, `spread` apart.
struct Thing {
  std::string name, kind, size;
  float place;
};

const std::vector<Thing> kThings{{"a", "round", "10", 0.0F},  {"b", "round", "20", 10.0F},
                                 {"c", "round", "30", 20.0F}, {"d", "flat", "10", 100.0F},
                                 {"e", "flat", "20", 110.0F}, {"f", "flat", "30", 120.0F}};

Recording recording_of(const std::vector<Thing>& things, float spread = 2.0F) {
  Recording recording;
  for (const Thing& thing : things) {
    for (const float offset : {0.0F, spread}) {
      recording.explorations.push_back(
          {{{"object", thing.name}, {"kind", thing.kind}, {"size", thing.size}},
           {},
           {{"joints", "deg", {}, Matrix<float>(1, 2, {thing.place + offset, 7.0F}), {}}}});
    }
  }
  return recording;
}

StudyDescription raw_study() {
  return testing::small_study("none");
}

InformationParameters default_parameters(const std::string& order = {}) {
  InformationParameters parameters;
  parameters.labels = {"object", "kind"};
  parameters.individual = "object";
  parameters.order = order;
  parameters.within = order.empty() ? "" : "kind";
  return parameters;
}

Error error_of(const Recording& recording, const InformationParameters& parameters,
               const StudyDescription& study = raw_study()) {
  const auto information = measure_information(study, recording, parameters);
  return information ? Error{} : information.error();
}

// Two samples of a thing lie 2 apart, the next thing 8 or 10 away, the other kind 80 or more.
TEST(Information, MeasuresTheInformationInTheVectors) {
  const auto found =
      measure_information(raw_study(), recording_of(kThings), default_parameters()).value();
  EXPECT_EQ(found.study, "small");
  EXPECT_EQ(found.module, "closed");
  EXPECT_EQ(found.explorations, 12U);
  EXPECT_EQ(found.elements, 2U);
  EXPECT_FALSE(found.order.has_value());
  ASSERT_EQ(found.labels.size(), 2U);
  const LabelInformation& object = found.labels[0];
  EXPECT_EQ(object.label, "object");
  EXPECT_EQ(object.classes, 6U);
  EXPECT_DOUBLE_EQ(object.accuracy, 1.0);
  EXPECT_DOUBLE_EQ(object.chance, 1.0 / 11.0);
  EXPECT_FALSE(object.accuracy_new_individuals.has_value());
  EXPECT_FALSE(object.chance_new_individuals.has_value());
  const LabelInformation& kind = found.labels[1];
  EXPECT_EQ(kind.classes, 2U);
  EXPECT_DOUBLE_EQ(kind.chance, 5.0 / 11.0);
  EXPECT_DOUBLE_EQ(kind.accuracy_new_individuals.value(), 1.0);
  EXPECT_DOUBLE_EQ(kind.chance_new_individuals.value(), 0.4);
}

// a at 0 and 2, b at 10 and 12, both the only ones of their kind: within 2, between 8, 10, 10, 12.
TEST(Information, DividesDistancesBetweenByThoseWithin) {
  const Recording recording = recording_of({{"a", "x", "1", 0.0F}, {"b", "y", "2", 10.0F}});
  const auto found = measure_information(raw_study(), recording, default_parameters()).value();
  EXPECT_DOUBLE_EQ(found.labels[0].distance_ratio.value(), 5.0);
}

// A thing is nearest to itself; without itself it is nearest to one of the other kind.
TEST(Information, NewIndividualsMayBeTakenForAnotherKind) {
  const Recording recording = recording_of({{"a", "x", "1", 0.0F},
                                            {"b", "y", "1", 10.0F},
                                            {"c", "x", "1", 40.0F},
                                            {"d", "y", "1", 55.0F}});
  const auto found = measure_information(raw_study(), recording, default_parameters()).value();
  EXPECT_DOUBLE_EQ(found.labels[1].accuracy, 1.0);
  EXPECT_DOUBLE_EQ(found.labels[1].accuracy_new_individuals.value(), 0.0);
  EXPECT_DOUBLE_EQ(found.labels[1].chance_new_individuals.value(), 1.0 / 3.0);
}

TEST(Information, EachExplorationIsAnIndividualUnlessOneIsNamed) {
  InformationParameters single = default_parameters();
  single.individual.clear();
  const auto found = measure_information(raw_study(), recording_of(kThings), single).value();
  EXPECT_DOUBLE_EQ(found.labels[1].accuracy, 1.0);
  EXPECT_FALSE(found.labels[1].accuracy_new_individuals.has_value());
}

TEST(Information, OrdersMeansWithinEachGroup) {
  const auto found =
      measure_information(raw_study(), recording_of(kThings), default_parameters("size")).value();
  ASSERT_TRUE(found.order.has_value());
  ASSERT_EQ(found.order->groups.size(), 2U);
  EXPECT_EQ(found.order->groups[0].name, "flat");
  EXPECT_EQ(found.order->groups[0].individuals, 3U);
  EXPECT_DOUBLE_EQ(found.order->groups[0].correlation, 1.0);
  EXPECT_DOUBLE_EQ(found.order->correlation, 1.0);
  // Both groups of three come as high with 1/3 each; the absolute correlation is 2/3 by chance.
  EXPECT_NEAR(found.order->shuffled, 2.0 / 3.0, 0.03);
  EXPECT_NEAR(found.order->shuffled_share, 1.0 / 9.0, 0.04);
}

// The same places, the middle one with the greatest number: ranks 1, 3, 2 along 1, 2, 3.
TEST(Information, SeesThatNumbersAreOutOfOrder) {
  std::vector<Thing> things = kThings;
  things[1].size = "30";
  things[2].size = "20";
  const auto found =
      measure_information(raw_study(), recording_of(things), default_parameters("size")).value();
  EXPECT_DOUBLE_EQ(found.order->groups[1].correlation, 0.5);
  EXPECT_DOUBLE_EQ(found.order->correlation, 0.75);
}

// Samples overlap so that each lies nearest to another thing, but the means are in order.
TEST(Information, OrderIsThatOfTheMeans) {
  const auto found =
      measure_information(raw_study(), recording_of(kThings, 300.0F), default_parameters("size"))
          .value();
  EXPECT_LT(found.labels[0].accuracy, 0.1);
  EXPECT_DOUBLE_EQ(found.order->correlation, 1.0);
}

// The mean of b's three samples is 20, between the others.
TEST(Information, AMeanIsThatOfAllSamplesHoweverMany) {
  Recording recording;
  for (const auto& [object, size, place] :
       std::vector<std::tuple<std::string, std::string, float>>{{"a", "1", 10.0F},
                                                                {"b", "2", -50.0F},
                                                                {"b", "2", 90.0F},
                                                                {"b", "2", 20.0F},
                                                                {"c", "3", 30.0F}}) {
    Exploration exploration = testing::exploration_of(object, {place, 7.0F});
    exploration.labels.push_back({"size", size});
    recording.explorations.push_back(std::move(exploration));
  }
  InformationParameters parameters = default_parameters("size");
  parameters.labels = {"object"};
  parameters.within.clear();
  const auto found = measure_information(raw_study(), recording, parameters).value();
  EXPECT_DOUBLE_EQ(found.order->correlation, 1.0);
}

TEST(Information, AGroupOfTwoNumbersHasNoOrder) {
  std::vector<Thing> things = kThings;
  things[2].size = "20";
  const auto found =
      measure_information(raw_study(), recording_of(things), default_parameters("size")).value();
  ASSERT_EQ(found.order->groups.size(), 1U);
  EXPECT_EQ(found.order->groups[0].name, "flat");
  things[5].size = "20";
  EXPECT_NE(error_of(recording_of(things), default_parameters("size")).what.find("no group has 3"),
            std::string::npos);
}

// As a study's baseline does: the standardization learns and is left out.
TEST(Information, LooksBeforeAStandardization) {
  const auto raw =
      measure_information(raw_study(), recording_of(kThings), default_parameters()).value();
  const auto standardized = measure_information(testing::small_study("constant_columns = 'zero'\n"),
                                                recording_of(kThings), default_parameters())
                                .value();
  EXPECT_EQ(standardized.module, "closed");
  EXPECT_EQ(to_json(standardized), to_json(raw));
}

TEST(Information, IsTheSameForAnyNumberOfThreads) {
  const Recording recording = recording_of(kThings);
  const auto one =
      measure_information(raw_study(), recording, default_parameters("size"), 1).value();
  const auto three =
      measure_information(raw_study(), recording, default_parameters("size"), 3).value();
  EXPECT_EQ(to_json(one), to_json(three));
}

const std::string kTwoMaps =
    "[module.second]\ntype = 'som'\ninput = 'joints_last'\nrows = 2\ncolumns = 2\niterations = 9\n"
    "[module.joints_last]\ntype = 'last'\ninput = 'joints'\n"
    "[module.after]\ntype = 'som'\ninput = 'second'\nrows = 2\ncolumns = 2\niterations = 9\n";

StudyDescription study_with(const std::string& modules) {
  return testing::study_from("[study]\nname = 's'\nmap = 'map'\n" + testing::joints_system("none") +
                             modules);
}

TEST(Information, RequiresTheNameOfOneOfTheFirstMaps) {
  const Error error = error_of(recording_of(kThings), default_parameters(), study_with(kTwoMaps));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_EQ(error.advice, "set 'map' to one of map, second");
  InformationParameters second = default_parameters();
  second.map = "second";
  const auto found =
      measure_information(study_with(kTwoMaps), recording_of(kThings), second).value();
  EXPECT_EQ(found.module, "joints_last");
}

// The order of the description does not matter.
TEST(Information, FindsAMapThatIsDescribedFirst) {
  const auto study = testing::study_from(
      "[study]\nname = 's'\n"
      "[module.map]\ntype = 'som'\ninput = 'closed'\nrows = 2\ncolumns = 2\n"
      "[module.joints]\ntype = 'channel'\nchannel = 'joints'\n"
      "[module.closed]\ntype = 'last'\ninput = 'joints'\n");
  const auto found = measure_information(study, recording_of(kThings), default_parameters());
  ASSERT_TRUE(found) << to_string(found.error());
  EXPECT_EQ(found->module, "closed");
}

TEST(Information, RefusesVectorsThatLearningModulesGive) {
  InformationParameters parameters = default_parameters();
  parameters.map = "after";
  const Error error = error_of(recording_of(kThings), parameters, study_with(kTwoMaps));
  EXPECT_EQ(error.kind, ErrorKind::kUsage);
  EXPECT_NE(error.what.find("depend on modules that learn: 'second'"), std::string::npos)
      << error.what;
  EXPECT_NE(error.where.find("'after'"), std::string::npos) << error.where;
  // All that learns before the map is named: two one-hot codes without ranges and a T-MPSOM.
  const Error many =
      error_of(testing::grasps(3, 3, 4), {{"object"}, {}, {}, {}, {}}, testing::learning_study());
  EXPECT_NE(many.what.find("'fingers_code', 'wrist_code', 'binding'"), std::string::npos)
      << many.what;
}

TEST(Information, RefusesMapsThatAreNone) {
  InformationParameters parameters = default_parameters();
  parameters.map = "closed";
  EXPECT_NE(error_of(recording_of(kThings), parameters).what.find("'closed' is not a map"),
            std::string::npos);
  parameters.map = "mpa";
  EXPECT_EQ(error_of(recording_of(kThings), parameters).advice, "did you mean 'map'?");
}

TEST(Information, RefusesLabelsThatTellNothing) {
  InformationParameters parameters = default_parameters();
  parameters.labels = {"objcet"};
  EXPECT_EQ(error_of(recording_of(kThings), parameters).advice, "did you mean 'object'?");
  const Recording of_one = recording_of({kThings[0], kThings[1]});
  EXPECT_EQ(error_of(of_one, default_parameters()).what, "every exploration has the same 'kind'");
  const Recording one_thing = recording_of({kThings[0]});
  EXPECT_EQ(error_of(one_thing, default_parameters()).what,
            "every exploration has the same 'object'");
}

TEST(Information, RefusesOrdersThatCannotBe) {
  EXPECT_EQ(error_of(recording_of(kThings), default_parameters("object")).what,
            "the label 'object' is 'a', which is not a number");
  std::vector<Thing> measured = kThings;
  measured[0].size = "10 mm";
  EXPECT_EQ(error_of(recording_of(measured), default_parameters("size")).what,
            "the label 'size' is '10 mm', which is not a number");
  InformationParameters parameters = default_parameters("size");
  parameters.individual = "kind";
  EXPECT_EQ(error_of(recording_of(kThings), parameters).what,
            "explorations with the same 'kind' differ in 'size'");
  std::vector<Thing> things = kThings;
  things[3].name = "a";  // of the same size, but of another kind
  EXPECT_EQ(error_of(recording_of(things), default_parameters("size")).what,
            "explorations with the same 'object' differ in 'kind'");
}

TEST(Information, RefusesASingleExploration) {
  Recording one = recording_of({kThings[0]});
  one.explorations.pop_back();
  InformationParameters parameters = default_parameters();
  parameters.individual.clear();
  EXPECT_EQ(error_of(one, parameters).what, "the recording has only one exploration");
}

TEST(Information, StandsInJson) {
  const auto found =
      measure_information(raw_study(), recording_of(kThings), default_parameters("size")).value();
  const auto json = nlohmann::json::parse(to_json(found));
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["module"], "closed");
  EXPECT_EQ(json["explorations"], 12);
  EXPECT_EQ(json["parameters"]["individual"], "object");
  EXPECT_EQ(json["parameters"]["shuffles"], 1000);
  EXPECT_EQ(json["labels"][0]["label"], "object");
  EXPECT_TRUE(json["labels"][0]["accuracy_new_individuals"].is_null());
  EXPECT_EQ(json["labels"][1]["accuracy_new_individuals"], 1.0);
  EXPECT_EQ(json["order"]["correlation"], 1.0);
  EXPECT_EQ(json["order"]["groups"][1]["group"], "round");
}

// As results.json: a level a blank deeper, and text as people write it.
TEST(Information, StandsInJsonThatPeopleRead) {
  StudyDescription study = raw_study();
  study.study.name = "gr\u00f6\u00dfe";
  const std::string json =
      to_json(measure_information(study, recording_of(kThings), default_parameters()).value());
  EXPECT_TRUE(json.starts_with("{\n \"version\": 1,\n \"study\": \"gr\u00f6\u00dfe\",\n"));
  EXPECT_TRUE(json.ends_with("\n}\n"));
}

TEST(Information, WorksWithoutShuffles) {
  const auto table = parse_toml("shuffles = 0\nseed = 0\n", "parameters");
  const auto parameters = read_parameters<InformationParameters>(*table);
  ASSERT_TRUE(parameters) << to_string(parameters.error());
  EXPECT_EQ(parameters->shuffles, 0U);
}

}  // namespace
}  // namespace somato
