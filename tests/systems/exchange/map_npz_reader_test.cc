#include "systems/exchange/map_npz_reader.h"

#include <gtest/gtest.h>

#include <array>
#include <map>

#include "base/archives/made_zip.h"
#include "base/arrays/npy_numbers.h"
#include "base/arrays/npy_texts.h"
#include "base/support/damaged_files.h"
#include "base/support/temporary_folder.h"
#include "systems/exchange/map_npz_writer.h"
#include "systems/exchange/parameters_json.h"

namespace somato {
namespace {

SomParameters one_by_two() {
  SomParameters parameters;
  parameters.rows = 1;
  parameters.columns = 2;
  return resolve(parameters, 4, 3).value();
}

using Members = std::map<std::string, std::string>;

template <typename T>
std::string npy(const std::vector<T>& numbers, const std::vector<std::size_t>& shape) {
  return npy_of_numbers<T>(numbers, shape);
}

// The arrays of a map of two neurons for three features, as numpy would write them.
Members whole_map() {
  return {{"file_format", npy_of_texts({"somato map 1"}, {})},
          {"parameters", npy_of_texts({parameters_to_json(one_by_two())}, {})},
          {"weights", npy<float>({0, 1, 2, 3, 4, 5}, {1, 2, 3})},
          {"feature_names", npy_of_texts({"x", "y", "z"})},
          {"mean", npy<double>({1, 2, 3}, {3})},
          {"scale", npy<double>({0.5, 0, 2}, {3})},
          {"class_names", npy_of_texts({"ball", "cube"})},
          {"labels", npy<std::int64_t>({-1, 1}, {1, 2})}};
}

Result<SomModel> read(const Members& members) {
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& [name, content] : members) files.emplace_back(name + ".npy", content);
  return map_in_npz(made_zip(files, true), "map.npz");
}

TEST(MapNpzReader, ReadsAMapThatNumpyHasCompressed) {
  const auto map = read(whole_map());
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->som.weights().to_matrix(), Matrix<float>(2, 3, {0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(map->features, (std::vector<std::string>{"x", "y", "z"}));
  EXPECT_EQ(map->standardization->means, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(map->standardization->deviations, (std::vector<double>{0.5, 0, 2}));
  EXPECT_EQ(map->classes, (std::vector<std::string>{"ball", "cube"}));
  EXPECT_EQ(map->labels, NeuronLabels({std::nullopt, 1}));
}

TEST(MapNpzReader, ReadsRelevancesWithTheWeightsThatTheyMultiply) {
  Members members = whole_map();
  members["relevances"] = npy<double>({0.25, 1, 4}, {3});
  const auto map = read(members);
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->som.parameters().relevances, (std::vector<double>{0.25, 1, 4}));
  EXPECT_EQ(map->som.weights().to_matrix(), Matrix<float>(2, 3, {0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(map->som.weight(1, 0), 6.0F);
  EXPECT_EQ(map->som.weight(1, 2), 2.5F);
}

void expect_array_refused(const std::string& name, const std::string& content,
                          const std::string& message) {
  Members members = whole_map();
  if (content.empty()) {
    members.erase(name);
  } else {
    members[name] = content;
  }
  const auto map = read(members);
  ASSERT_FALSE(map) << name << ": " << message;
  const std::string text = to_string(map.error());
  EXPECT_EQ(map.error().kind, ErrorKind::kData) << text;
  EXPECT_NE(text.find("map.npz"), std::string::npos) << text;
  EXPECT_NE(text.find(message), std::string::npos) << text;
}

std::string parameters_with(const std::string& key, const std::string& value) {
  std::string json = parameters_to_json(one_by_two());
  const std::size_t start = json.find("\"" + key + "\":") + key.size() + 3;
  return npy_of_texts({json.replace(start, json.find_first_of(",}", start) - start, value)}, {});
}

TEST(MapNpzReader, SaysWhatIsWrongWithEachArray) {
  expect_array_refused("file_format", "", "'file_format' is missing");
  expect_array_refused("file_format", npy_of_texts({"somato map 2"}, {}),
                       "newer version of Somato (format 2, supported is 1)");
  expect_array_refused("file_format", npy_of_texts({"somato map 0"}, {}), "file_format");
  expect_array_refused("file_format", npy_of_texts({"other"}, {}), "file_format");
  expect_array_refused("file_format", npy<float>({1}, {1}), "not a list of texts");
  expect_array_refused("weights", "", "'weights' is missing");
  expect_array_refused("weights", npy<float>({0, 1, 2, 3, 4, 5}, {2, 1, 3}), "does not fit");
  expect_array_refused("weights", npy<float>({0, 1, 2, 3}, {1, 2, 2}), "one name for each");
  expect_array_refused("weights", npy<float>({0, 1, 2, 3, 4, NAN}, {1, 2, 3}), "nan");
  expect_array_refused("weights", npy<double>({0, 1, 2, 3, 4, 1e300}, {1, 2, 3}), "1e+300");
  expect_array_refused("weights", npy_of_texts({"a", "b"}), "not supported");
  expect_array_refused("parameters", npy_of_texts({"{"}, {}), "not valid JSON");
  expect_array_refused("parameters", npy_of_texts({"[]"}, {}), "not a JSON object");
  expect_array_refused("parameters", npy_of_texts({R"({"rows":[1]})"}, {}), "rows");
  expect_array_refused("parameters", npy_of_texts({"{}"}, {}), "does not fit");
  expect_array_refused("parameters", parameters_with("rows", "-1"), "rows");
  expect_array_refused("parameters", parameters_with("rows", "18446744073709551615"), "rows");
  expect_array_refused("parameters", parameters_with("lattice", "\"round\""), "lattice");
  expect_array_refused("parameters", parameters_with("radius_start", "\"automatic\""),
                       "still automatic");
  expect_array_refused("mean", "", "both 'mean' and 'scale'");
  expect_array_refused("mean", npy<double>({1, 2}, {2}), "as many columns");
  expect_array_refused("scale", npy<double>({1, 2, -1}, {3}), "deviations of at least 0");
  expect_array_refused("scale", npy<double>({1, 2, INFINITY}, {3}), "deviations of at least 0");
  expect_array_refused("fill_values", npy<double>({1, 2, NAN}, {3}), "finite");
  expect_array_refused("labels", "", "a label or none");
  expect_array_refused("labels", npy<std::int64_t>({-1, 2}, {2}), "no name");
  expect_array_refused("labels", npy<std::int64_t>({-1, -1}, {2}), "needs a neuron with a label");
  expect_array_refused("labels", npy<std::int64_t>({-2, 1}, {2}), "-2");
  expect_array_refused("labels", npy<double>({0.5, 1}, {2}), "0.5");
  expect_array_refused("labels", npy<std::int64_t>({1}, {1}), "1 numbers for 2 neurons");
  expect_array_refused("class_names", "", "without classes");
  expect_array_refused("elements", npy<std::int64_t>({0, 3}, {2}), "outside the input");
  expect_array_refused("elements", npy<std::int64_t>({0, 1}, {2}), "not in 'elements'");
  expect_array_refused("elements", npy<std::int64_t>({0, 1, 2, 2}, {4}), "ascending");
  expect_array_refused("elements", npy<std::int64_t>({2, 1, 0}, {3}), "ascending");
  expect_array_refused("samples_seen", npy<std::int64_t>({-1}, {1}), "samples_seen");
  expect_array_refused("other", npy<double>({1}, {1}), "other");
}

TEST(MapNpzReader, RefusesRelevancesThatCannotBe) {
  expect_array_refused("relevances", npy<double>({1, 1}, {2}), "not relevances");
  expect_array_refused("relevances", npy<double>({1, 0, 1}, {3}), "not relevances");
}

TEST(MapNpzReader, RefusesGraphsThatCannotBe) {
  Members members = whole_map();
  members["weights"] = npy<float>({0, 1, 2, 3, 4, 5}, {2, 3});
  ASSERT_TRUE(read(members));
  EXPECT_NE(read(members)->som.grid().graph(), nullptr);
  for (const std::vector<std::int64_t>& edges :
       {std::vector<std::int64_t>{0, 2}, {1, 0}, {0, 1, 0, 1}, {-1, 1}}) {
    members["edges"] = npy<std::int64_t>(edges, {edges.size() / 2, 2});
    EXPECT_FALSE(read(members)) << edges[0] << edges[1];
  }
}

// Bits that do not matter to a ZIP archive, such as dates, may be turned; no other ones.
TEST(MapNpzReader, RefusesOrIgnoresEveryTurnedBitAndRefusesEveryTruncation) {
  const TemporaryFolder folder;
  const std::string path = folder.file("map.npz");
  const auto model = read(whole_map()).value();
  ASSERT_TRUE(save_map_npz(path, model));
  const std::string whole = bytes_of(path);
  const std::string wanted = encode_som_model(model);
  for (std::size_t bit = 0; bit < 8 * whole.size(); bit += 59) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    const auto read_back = map_in_npz(damaged, path);
    if (read_back) {
      EXPECT_TRUE(encode_som_model(*read_back) == wanted) << bit;
    }
  }
  for (std::size_t size = 0; size < whole.size(); size += 59) {
    EXPECT_FALSE(map_in_npz(whole.substr(0, size), path)) << size;
  }
}

TEST(MapNpzReader, KnowsItsFiles) {
  EXPECT_FALSE(is_map_npz(""));
  EXPECT_FALSE(is_map_npz("PK\3\4"));
  EXPECT_FALSE(is_map_npz(made_zip({{"weights.npy", npy<float>({1}, {1})}}, false)));
  EXPECT_TRUE(is_map_npz(made_zip({{"file_format.npy", ""}}, false)));
}

}  // namespace
}  // namespace somato
