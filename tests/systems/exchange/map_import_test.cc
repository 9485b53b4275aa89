#include "systems/exchange/map_import.h"

#include <gtest/gtest.h>

#include <array>

#include "base/archives/made_zip.h"
#include "base/arrays/npy_numbers.h"
#include "base/support/temporary_folder.h"
#include "systems/exchange/map_npz_writer.h"

namespace somato {
namespace {

std::string weights_file() {
  const std::vector<double> weights{1, 2, 3, 4};
  return npy_of_numbers<double>(weights, std::array<std::size_t, 3>{1, 2, 2});
}

MapImportOptions giving(const std::string& name, const Value& value) {
  MapImportOptions options;
  options.given.entries.push_back({name, "--" + name, value});
  return options;
}

TEST(MapImport, FindsTheFormatInTheFile) {
  const TemporaryFolder folder;
  const auto map = import_map(folder.with("w.npy", weights_file()));
  ASSERT_TRUE(map) << to_string(map.error());
  const std::string wanted = encode_som_model(map->model);
  ASSERT_TRUE(save_som_model(folder.file("model"), map->model));
  ASSERT_TRUE(save_map_npz(folder.file("exported"), map->model));
  (void)folder.with("w.npz", made_zip({{"w.npy", weights_file()}}, true));
  (void)folder.with("cod", "2 rect 2 1 gaussian\n1 2\n3 4\n");
  for (const std::string name : {"model", "exported", "w.npz", "cod"}) {
    const auto same = import_map(folder.file(name));
    ASSERT_TRUE(same) << to_string(same.error());
    EXPECT_EQ(encode_som_model(same->model), wanted) << name;
    EXPECT_TRUE(same->notes.empty());
  }
}

TEST(MapImport, TakesParametersNamesAndTheArrayOfSeveral) {
  const TemporaryFolder folder;
  MapImportOptions options = giving("lattice", {std::string("hexagonal")});
  options.features = {"x", "y"};
  options.variable = "b";
  const auto map = import_map(
      folder.with("w.npz", made_zip({{"a.npy", "no array"}, {"b.npy", weights_file()}}, false)),
      options);
  ASSERT_TRUE(map) << to_string(map.error());
  EXPECT_EQ(map->model.som.grid().lattice(), Lattice::kHexagonal);
  EXPECT_EQ(map->model.features, options.features);
}

TEST(MapImport, RefusesOptionsWithoutEffect) {
  const TemporaryFolder folder;
  const auto map = import_map(folder.with("w.npy", weights_file()));
  ASSERT_TRUE(save_map_npz(folder.file("exported"), map->model));
  (void)folder.with("cod", "2 rect 2 1 gaussian\n1 2\n3 4\n");
  const auto refused = [&](const std::string& file, const MapImportOptions& options) {
    const auto read = import_map(folder.file(file), options);
    return !read && read.error().kind == ErrorKind::kUsage;
  };
  MapImportOptions variable;
  variable.variable = "weights";
  MapImportOptions features;
  features.features = {"x", "y"};
  EXPECT_TRUE(refused("exported", giving("topology", {std::string("torus")})));
  EXPECT_TRUE(refused("exported", features));
  EXPECT_TRUE(refused("exported", variable));
  EXPECT_TRUE(refused("w.npy", variable));
  EXPECT_TRUE(refused("w.npy", giving("lattice", {std::string("round")})));
  EXPECT_TRUE(refused("cod", giving("lattice", {std::string("hexagonal")})));
  (void)folder.with("named", "2 rect 2 1 gaussian\n#n a b\n1 2\n3 4\n");
  EXPECT_TRUE(refused("named", features));
  const auto named = import_map(folder.file("cod"), features);
  ASSERT_TRUE(named) << to_string(named.error());
  EXPECT_EQ(named->model.features, features.features);
  features.features.emplace_back("z");
  EXPECT_TRUE(refused("cod", features));
  EXPECT_FALSE(refused("cod", giving("topology", {std::string("torus")})));
}

TEST(MapImport, RefusesOtherFiles) {
  const TemporaryFolder folder;
  EXPECT_EQ(import_map(folder.file("none")).error().kind, ErrorKind::kSystem);
  for (const std::string& bytes : {std::string(), std::string("1,2\n"), std::string("PK\3\4"),
                                   std::string("\x93NUMPY"), weights_file().substr(0, 90)}) {
    const auto map = import_map(folder.with("f", bytes));
    ASSERT_FALSE(map) << bytes;
    EXPECT_EQ(map.error().kind, ErrorKind::kData);
    EXPECT_FALSE(map.error().advice.empty());
  }
}

}  // namespace
}  // namespace somato
