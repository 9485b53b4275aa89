#include "somato/graph/som_model.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/archives/archive.h"
#include "base/support/damaged_files.h"
#include "maps/support/saved_maps.h"
#include "somato/core/check.h"

namespace somato {
namespace {

using testing::with_part;
using testing::without_part;

using Texts = std::vector<std::string>;

const Texts kHostileNames{"",
                          "a\nb",
                          "\"quoted\"",
                          "'",
                          "back\\slash",
                          "\t\r\x01\x7F",
                          "]]\n[x]",
                          "\xF0\x9F\x96\x90",
                          std::string("nul\0nul", 7),
                          "= # not a comment"};

Texts hostile_names(std::size_t count, std::size_t first) {
  Texts names;
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(kHostileNames[(first + i) % kHostileNames.size()]);
  }
  return names;
}

// The first two neurons, if there are two, stand for the first and the last class.
NeuronLabels some_labels(std::size_t neurons, std::size_t classes) {
  std::vector<std::optional<std::size_t>> labels(neurons);
  labels.back() = classes - 1;
  labels.front() = 0;
  return NeuronLabels(labels);
}

// A model with those of its parts that the bits of `which` choose.
SomModel model_of(const Som& som, unsigned which, Random& random) {
  SomModel model{som, {}, {}, {}, {}, {}};
  const std::size_t size = som.input_size();
  if (which & 1U) model.features = hostile_names(size, random.below(10));
  if (which & 2U) {
    model.standardization = Standardization{};
    for (std::size_t d = 0; d < size; ++d) {
      model.standardization->means.push_back(random.normal() * 1e10);
      model.standardization->deviations.push_back(d == 0 ? 0.0 : random.uniform());
    }
  }
  if (which & 8U) {
    for (std::size_t d = 0; d < size; ++d) model.means.push_back(random.normal() * 1e10);
  }
  if (which & 4U) {
    model.classes = hostile_names(1 + random.below(6), random.below(10));
    model.labels = some_labels(som.neurons(), model.classes.size());
  }
  return model;
}

void expect_same(const SomModel& loaded, const SomModel& model) {
  EXPECT_EQ(loaded.som.weights(), model.som.weights());
  EXPECT_EQ(parameters_to_toml(loaded.som.parameters()),
            parameters_to_toml(model.som.parameters()));
  EXPECT_EQ(loaded.features, model.features);
  ASSERT_EQ(loaded.standardization.has_value(), model.standardization.has_value());
  if (model.standardization) {
    EXPECT_EQ(loaded.standardization->means, model.standardization->means);
    EXPECT_EQ(loaded.standardization->deviations, model.standardization->deviations);
  }
  EXPECT_EQ(loaded.classes, model.classes);
  EXPECT_EQ(loaded.labels, model.labels);
  EXPECT_EQ(loaded.means, model.means);
}

TEST(SomModel, IsTheSameWhenLoaded) {
  const TemporaryFolder folder;
  Random random(3);
  for (const testing::Variant& variant : testing::variants_in_pairs()) {
    for (unsigned which = 0; which < 16; ++which) {
      const Som som = testing::trained_som(variant, 1 + random.below(5), random);
      const SomModel model = model_of(som, which, random);
      ASSERT_TRUE(save_som_model(folder.file("a"), model));
      const auto loaded = load_som_model(folder.file("a"));
      ASSERT_TRUE(loaded) << to_string(loaded.error());
      expect_same(*loaded, model);
      ASSERT_TRUE(save_som_model(folder.file("b"), *loaded));
      EXPECT_EQ(bytes_of(folder.file("b")), bytes_of(folder.file("a")));
      EXPECT_EQ(encode_som_model(model), bytes_of(folder.file("a")));
      expect_same(decode_som_model(encode_som_model(model), "bytes").value(), model);
    }
  }
}

SomModel small_model() {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  return {Som(resolve(parameters, 4, 3).value(), Matrix<float>(2, 3, {0, 1, 2, 3, 4, 5})),
          {"x", "y", "z"},
          Standardization{{1, 2, 3}, {0.5, 0, 2}},
          {"ball", "cube"},
          NeuronLabels({std::nullopt, 1})};
}

// A map of a system that grows, which another program has given as a map of a table.
TEST(SomModel, OfAGraphIsTheSameWhenLoaded) {
  const auto graph =
      std::make_shared<const NeuronGraph>(3, std::vector<NeuronGraph::Edge>{{0, 1}, {1, 2}});
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 3;
  const SomModel model{
      Som(resolve(parameters, 4, 1).value(), Matrix<float>(3, 1, {0, 1, 2}), graph),
      {"x"},
      {},
      {},
      {}};
  const auto loaded = decode_som_model(encode_som_model(model), "bytes");
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  ASSERT_NE(loaded->som.grid().graph(), nullptr);
  EXPECT_EQ(loaded->som.grid().graph()->edges(), graph->edges());
}

TEST(SomModel, PreparesSamplesAsItWasTrained) {
  const Samples samples(Matrix<float>(1, 3, {2, 7, 7}));
  const Samples prepared = small_model().prepare(samples);
  EXPECT_EQ(std::vector<float>(prepared[0].values.begin(), prepared[0].values.end()),
            (std::vector<float>{2, 0, 2}));
  SomModel plain = small_model();
  plain.standardization.reset();
  const Samples same = plain.prepare(samples);
  EXPECT_EQ(std::vector<float>(same[0].values.begin(), same[0].values.end()),
            (std::vector<float>{2, 7, 7}));
  EXPECT_THROW((void)small_model().prepare(Samples(Matrix<float>(1, 2))), InvalidArgument);
}

TEST(SomModel, FillsWithItsMeansOrThoseOfItsStandardization) {
  SomModel model = small_model();
  EXPECT_EQ(model.fill_values(), (std::vector<double>{1, 2, 3}));
  model.means = {4, 5, 6};
  EXPECT_EQ(model.fill_values(), (std::vector<double>{4, 5, 6}));
  model.standardization.reset();
  EXPECT_EQ(model.fill_values(), (std::vector<double>{4, 5, 6}));
  model.means.clear();
  EXPECT_TRUE(model.fill_values().empty());
}

TEST(SomModel, IsSavedWithTheSamplesItHasSeenUnlessTheseAreItsIterations) {
  SomModel model = small_model();
  const std::uint64_t iterations = *model.som.parameters().iterations;
  const std::string whole = encode_som_model(model);
  EXPECT_EQ(model.seen(), iterations);
  model.samples_seen = iterations;
  EXPECT_EQ(encode_som_model(model), whole);  // as files of earlier versions
  for (const std::uint64_t seen : {std::uint64_t{0}, iterations - 1, iterations + 1}) {
    model.samples_seen = seen;
    EXPECT_EQ(decode_som_model(encode_som_model(model), "bytes")->seen(), seen);
  }
}

TEST(SomModel, KnowsTheScalesOfItsColumns) {
  SomModel model = small_model();
  model.standardization = Standardization{{1, 2000, 3}, {0.5, 0.25, 2}};
  model.means = {4, 2001, 6};
  EXPECT_EQ(model.scales()[0].offset, 0.0);
  EXPECT_EQ(model.scales()[1].offset, 2000.0);
  EXPECT_EQ(model.scales()[1].deviation, 0.25);
  model.subtract_offsets();
  EXPECT_EQ(model.standardization->means, (std::vector<double>{1, 0, 3}));
  EXPECT_EQ(model.means, (std::vector<double>{4, 1, 6}));
  model.standardization.reset();
  EXPECT_EQ(model.scales()[0].offset, 0.0);
  EXPECT_EQ(model.scales()[0].deviation, 4 * 1.5);  // four times that of the weights 0 and 3
}

// A constant column of online training: its weights are a few units in the last place apart.
TEST(SomModel, KnowsNoDeviationOfAColumnWhoseWeightsDifferByRounding) {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  const float near = std::nextafter(std::nextafter(9.81F, 10.0F), 10.0F);
  const SomModel model{
      Som(resolve(parameters, 4, 2).value(), Matrix<float>(2, 2, {9.81F, 0.0F, near, 1e-6F})),
      {},
      {},
      {},
      {}};
  EXPECT_EQ(model.scales()[0].deviation, 0.0);
  EXPECT_NEAR(model.scales()[1].deviation, 4 * 5e-7, 1e-11);
}

TEST(SomModel, RefusesToSaveWhatCouldNotBeLoaded) {
  const TemporaryFolder folder;
  const auto refused = [&](const auto& spoil) {
    SomModel model = small_model();
    spoil(model);
    EXPECT_THROW((void)save_som_model(folder.file("a"), model), InvalidArgument);
  };
  refused([](SomModel& m) { m.features.pop_back(); });
  refused([](SomModel& m) { m.features[0] = "\xFF"; });
  refused([](SomModel& m) { m.standardization->means.pop_back(); });
  refused([](SomModel& m) { m.standardization->deviations.pop_back(); });
  refused([](SomModel& m) { m.labels = {}; });
  refused([](SomModel& m) { m.labels = NeuronLabels({2, 1}); });
  refused([](SomModel& m) { m.labels = NeuronLabels({{}, {}}); });
  refused([](SomModel& m) { m.classes.clear(); });
  refused([](SomModel& m) { m.means = {1, 2}; });
  EXPECT_EQ(folder.count(), 0);
}

TEST(SomModel, RefusesEveryTruncationAndEveryTurnedBit) {
  const TemporaryFolder folder;
  const std::string path = folder.file("model.somato");
  ASSERT_TRUE(save_som_model(path, small_model()));
  testing::expect_damage_refused(path, load_som_model);
}

Archive saved_archive() {
  const TemporaryFolder folder;
  EXPECT_TRUE(save_som_model(folder.file("a"), small_model()));
  return load_archive(folder.file("a")).value();
}

// Saved with a checksum that is right.
void expect_refused(const Archive& archive, const std::string& because) {
  const TemporaryFolder folder;
  const std::string path = folder.file("hostile.somato");
  ASSERT_TRUE(save_archive(path, archive));
  const auto model = load_som_model(path);
  ASSERT_FALSE(model) << because;
  EXPECT_EQ(model.error().kind, ErrorKind::kData);
  EXPECT_TRUE(model.error().where.starts_with(path)) << to_string(model.error());
  EXPECT_NE(model.error().what.find(because), std::string::npos) << to_string(model.error());
}

void expect_part_refused(const std::string& name, Archive::Content content,
                         const std::string& because) {
  expect_refused(with_part(saved_archive(), name, std::move(content)), because);
}

TEST(SomModel, RefusesAnotherKindOfFile) {
  Archive other("t_mpsom");
  const Archive archive = saved_archive();
  for (const Archive::Entry& entry : archive.entries()) other.add(entry.name, entry.content);
  expect_refused(other, "the file contains 't_mpsom', not 'som'");
  expect_refused(Archive("som"), "is missing");
}

TEST(SomModel, RefusesPartsItDoesNotKnow) {
  expect_part_refused("notes", std::string("hello"), "unknown part 'notes'");
  expect_part_refused("som.bias", Array<float>{{1}, {0}}, "unknown part 'som.bias'");
}

TEST(SomModel, RefusesPartsThatAreMissing) {
  const Archive archive = saved_archive();
  for (const char* name : {"som.parameters", "som.weights", "labels"}) {
    expect_refused(without_part(archive, name), "'" + std::string(name) + "' is missing");
  }
  expect_refused(without_part(archive, "classes"), "label of an unknown class");
}

TEST(SomModel, RefusesAMapThatCannotBe) {
  expect_part_refused("som.weights", Array<float>{{3, 3}, std::vector<float>(9)}, "do not fit");
  expect_part_refused("som.weights", Array<float>{{2, 3}, {0, 1, 2, 3, 4, std::nanf("")}},
                      "not finite");
  expect_part_refused("som.parameters", std::string("rows = 1\ncolumns = 2\n"), "still automatic");
  expect_part_refused("som.parameters", std::string("rows = -1\n"), "'rows' must be");
  expect_part_refused("som.parameters", std::string("rows"), "");
}

TEST(SomModel, RefusesNamesThatCannotBe) {
  for (const char* part : {"features", "classes"}) {
    for (const char* text : {"", "names = []\n", "names = 3\n", "names = [1, 2, 3]\n",
                             "names = \"x\"\n", "[names]\nx = 1\n", "name = [\"x\"]\n",
                             "names = [[\"x\"], [\"y\"], [\"z\"]]\n", "names = [\"x\"\n"}) {
      expect_part_refused(part, std::string(text), "is not a list of names");
    }
    expect_part_refused(part, Array<float>{{1}, {0}}, "another type");
  }
  expect_part_refused("features", std::string("names = [\"x\", \"y\"]\n"), "do not fit the map");
}

TEST(SomModel, RefusesMeansThatCannotBe) {
  expect_part_refused("means", Array<double>{{2}, {1, 2}}, "the means do not fit");
  expect_part_refused("means", Array<double>{{1, 3}, {1, 2, 3}}, "the means do not fit");
  expect_part_refused("means", Array<double>{{3}, {1, 2, std::nan("")}}, "an invalid number");
  expect_part_refused("means", Array<float>{{3}, {1, 2, 3}}, "another type");
}

TEST(SomModel, RefusesNumbersOfSamplesThatCannotBe) {
  const auto iterations = static_cast<std::int64_t>(*small_model().som.parameters().iterations);
  expect_part_refused("samples_seen", Array<std::int64_t>{{2}, {1, 2}}, "does not fit the map");
  expect_part_refused("samples_seen", Array<std::int64_t>{{1}, {-1}}, "does not fit the map");
  expect_part_refused("samples_seen", Array<std::int64_t>{{1}, {iterations}}, "of the parameters");
  expect_part_refused("samples_seen", Array<double>{{1}, {1}}, "another type");
}

TEST(SomModel, RefusesAStandardizationThatCannotBe) {
  using Numbers = std::vector<double>;
  const double nan = std::nan("");
  const double infinity = std::numeric_limits<double>::infinity();
  for (const Numbers& numbers :
       {Numbers{nan, 0, 0, 1, 1, 1}, Numbers{infinity, 0, 0, 1, 1, 1}, Numbers{0, 0, 0, 1, 1, nan},
        Numbers{0, 0, 0, 1, 1, infinity}, Numbers{0, 0, 0, -1, 1, 1}}) {
    expect_part_refused("standardization", Array<double>{{2, 3}, numbers}, "invalid number");
  }
  expect_part_refused("standardization", Array<double>{{3, 2}, Numbers(6)}, "does not fit the map");
  expect_part_refused("standardization", Array<double>{{6}, Numbers(6)}, "does not fit the map");
  expect_part_refused("standardization", Array<double>{{2, 2}, Numbers(4)}, "does not fit the map");
  expect_part_refused("standardization", Array<float>{{2, 3}, std::vector<float>(6)},
                      "another type");
}

TEST(SomModel, RefusesLabelsThatCannotBe) {
  using Labels = Array<std::int64_t>;
  expect_part_refused("labels", Labels{{2}, {0, 2}}, "label of an unknown class");
  expect_part_refused("labels", Labels{{2}, {-2, 0}}, "label of an unknown class");
  expect_part_refused("labels", Labels{{2}, {0, std::numeric_limits<std::int64_t>::max()}},
                      "label of an unknown class");
  expect_part_refused("labels", Labels{{2}, {-1, -1}}, "no neuron has a label");
  expect_part_refused("labels", Labels{{1}, {0}}, "do not fit the map");
  expect_part_refused("labels", Labels{{2, 1}, {0, 1}}, "do not fit the map");
  expect_part_refused("labels", std::string("0 1"), "another type");
}

TEST(SomModel, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  const auto model = load_som_model(folder.file("missing.somato"));
  ASSERT_FALSE(model);
  EXPECT_EQ(model.error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
