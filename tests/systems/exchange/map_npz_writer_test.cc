#include "systems/exchange/map_npz_writer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/arrays/npz_arrays.h"
#include "base/support/temporary_folder.h"
#include "maps/support/saved_maps.h"
#include "somato/core/check.h"
#include "systems/exchange/map_npz_reader.h"

namespace somato {
namespace {

const std::vector<std::string> kOddNames{"",           "a\nb", "\"", "\xF0\x9F\x96\x90 \xC3\xA4",
                                         "\t\x01\x7F", "x",    "x",  std::string("nul\0nul", 7)};

std::vector<std::string> odd_names(std::size_t count, Random& random) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(kOddNames[random.below(kOddNames.size())]);
  }
  return names;
}

// A model with those of its parts that the bits of `which` choose.
SomModel odd_model(const Som& som, unsigned which, Random& random) {
  SomModel model{som, {}, {}, {}, {}, {}};
  const std::size_t size = som.input_size();
  if (which & 1U) model.features = odd_names(size, random);
  if (which & 2U) model.standardization = Standardization{};
  for (std::size_t d = 0; d < size; ++d) {
    if (which & 4U) model.means.push_back(random.normal() * 1e300);
    if (!model.standardization) continue;
    model.standardization->means.push_back(d == 0 ? -0.0 : random.normal() * 1e9 / 3.0);
    model.standardization->deviations.push_back(d == 0 ? 0.0 : random.uniform() * 1e-300);
  }
  if (which & 8U) {
    model.classes = odd_names(1 + random.below(4), random);
    std::vector<std::optional<std::size_t>> labels(som.neurons());
    labels.back() = model.classes.size() - 1;
    model.labels = NeuronLabels(std::move(labels));
  }
  if (which & 1U && som.parameters().training == Training::kOnline)
    model.samples_seen = 12345678901;
  return model;
}

void expect_identity(const SomModel& model, const TemporaryFolder& folder) {
  const std::string path = folder.file("map.npz");
  const auto saved = save_map_npz(path, model);
  ASSERT_TRUE(saved) << to_string(saved.error());
  const auto loaded = map_in_npz(bytes_of(path), path);
  ASSERT_TRUE(loaded) << to_string(loaded.error());
  EXPECT_EQ(encode_som_model(*loaded), encode_som_model(model));
  EXPECT_EQ(loaded->som.products(), nullptr);
}

TEST(MapNpzWriter, KeepsEveryBitOfEveryKindOfModel) {
  const TemporaryFolder folder;
  Random random(8);
  for (const testing::Variant& variant : testing::variants_in_pairs()) {
    for (const unsigned which : {0U, 1U, 6U, 9U, 15U}) {
      const Som som = testing::trained_som(variant, 1 + random.below(5), random);
      expect_identity(odd_model(som, which, random), folder);
    }
  }
}

SomParameters of_sides(std::size_t rows, std::size_t columns) {
  SomParameters parameters;
  parameters.rows = rows;
  parameters.columns = columns;
  return resolve(parameters, 4, 3).value();
}

TEST(MapNpzWriter, WritesAllColumnsOfAMapThatStoresSome) {
  const TemporaryFolder folder;
  const Matrix<float> stored(2, 2, {1, 2, 3, 4});
  const SomModel model{
      Som(of_sides(1, 2), LaneMatrix<float>(stored), StoredElements(5, {1, 4})), {}, {}, {}, {}};
  expect_identity(model, folder);
  const std::string bytes = bytes_of(folder.file("map.npz"));
  const auto arrays = NpzArrays::open(bytes, "map.npz").value();
  EXPECT_EQ(arrays.numbers("weights").value(), (std::vector<double>{0, 1, 0, 0, 2, 0, 3, 0, 0, 4}));
  EXPECT_EQ(arrays.numbers("elements").value(), (std::vector<double>{1, 4}));
}

TEST(MapNpzWriter, KeepsLayers) {
  const TemporaryFolder folder;
  SomParameters parameters = of_sides(1, 2);
  parameters.layers = {{"a", 0, 2, Similarity::kEuclidean, 1.0, 0.5},
                       {"b=;", 2, 1, Similarity::kManhattan, 2.0, 3.0}};
  expect_identity({Som(parameters, Matrix<float>(2, 3, {0, 1, 2, 3, 4, 5})), {}, {}, {}, {}},
                  folder);
}

TEST(MapNpzWriter, WritesTheEdgesOfAMapThatGrows) {
  const TemporaryFolder folder;
  const Matrix<float> weights(3, 1, {1, 2, 3});
  using Edges = std::vector<NeuronGraph::Edge>;
  for (const Edges& edges : {Edges{{0, 1}, {1, 2}}, Edges{}}) {
    const auto graph = std::make_shared<const NeuronGraph>(3, edges);
    expect_identity({Som(of_sides(1, 3), weights, graph), {"x"}, {}, {}, {}}, folder);
  }
}

TEST(MapNpzWriter, WritesPositionsOnAHexagonalLattice) {
  const TemporaryFolder folder;
  SomParameters parameters = of_sides(2, 2);
  parameters.lattice = Lattice::kHexagonal;
  const SomModel model{Som(parameters, Matrix<float>(4, 1, {1, 2, 3, 4})), {}, {}, {}, {}};
  expect_identity(model, folder);
  const std::string bytes = bytes_of(folder.file("map.npz"));
  const auto positions = NpzArrays::open(bytes, "map.npz").value().numbers("positions").value();
  const double height = std::numbers::sqrt3 / 2.0;
  const std::vector<double> expected{0, 0, 1, 0, 0.5, height, 1.5, height};
  ASSERT_EQ(positions.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_DOUBLE_EQ(positions[i], expected[i]);
}

TEST(MapNpzWriter, RefusesWhatNumpyWouldLose) {
  const TemporaryFolder folder;
  SomModel model{Som(of_sides(1, 2), Matrix<float>(2, 1, {1, 2})), {}, {}, {}, {}};
  model.features = {std::string("x\0", 2)};
  const auto saved = save_map_npz(folder.file("a"), model);
  ASSERT_FALSE(saved);
  EXPECT_EQ(saved.error().kind, ErrorKind::kData);
  model.features = {"x", "y"};
  EXPECT_THROW((void)save_map_npz(folder.file("a"), model), InvalidArgument);
  model.features = {"\xFF"};
  EXPECT_THROW((void)save_map_npz(folder.file("a"), model), InvalidArgument);
  model.features.clear();
  model.standardization = Standardization{{1.0}, {std::nan("")}};
  EXPECT_THROW((void)save_map_npz(folder.file("a"), model), InvalidArgument);
  EXPECT_EQ(folder.count(), 0);
}

TEST(MapNpzWriter, RefusesWeightsOfFourGibibytes) {
  const TemporaryFolder folder;
  const Matrix<float> stored(2, 1, {1, 2});
  const SomModel model{
      Som(of_sides(1, 2), LaneMatrix<float>(stored), StoredElements(std::size_t{1} << 31, {7})),
      {},
      {},
      {},
      {}};
  const auto saved = save_map_npz(folder.file("a"), model);
  ASSERT_FALSE(saved);
  EXPECT_NE(to_string(saved.error()).find("4 GiB"), std::string::npos) << to_string(saved.error());
}

}  // namespace
}  // namespace somato
