#include <fmt/format.h>

#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

// Rows around four centres, whose columns are shifted by an offset.
class Offsets : public ProgramTest {
 protected:
  static double value(int row, int column) {
    return (row % 4 == column ? 1.0 : 0.0) + 0.0625 * ((row * 7 + column * 3) % 8);
  }

  void write_tables(double offset) const {
    std::string near = "a,b\n";
    std::string far = "a,b\n";
    std::vector<double> numbers;
    for (int row = 0; row < 40; ++row) {
      near += fmt::format("{:.4f},{:.4f}\n", value(row, 0), value(row, 1));
      far += fmt::format("{:.4f},{:.4f}\n", offset + value(row, 0), value(row, 1));
    }
    write("near.csv", near);
    write("far.csv", far);
  }

  static Words training(const std::string& data, const std::string& map) {
    return {"som", "train", data, "--standardize", "--rows", "3", "--columns", "3", "-o", map};
  }

  // The winner of each row, as `som map` prints it.
  std::string winners(const std::string& map, const std::string& data) const {
    return output_of({"som", "map", map, data});
  }
};

TEST_F(Offsets, OfStandardizedColumnsAreSubtractedBeforeNumbersAreRounded) {
  for (const double offset : {1e6, 1.7e9, -1e8}) {
    write_tables(offset);
    output_of(training("near.csv", "near.map"));
    output_of(training("far.csv", "far.map"));
    EXPECT_EQ(winners("far.map", "far.csv"), winners("near.map", "near.csv")) << offset;
    const auto model = load_som_model(path("far.map"));
    const auto plain = load_som_model(path("near.map"));
    EXPECT_NEAR(model->standardization->means[0] - offset, plain->standardization->means[0], 1e-6);
    EXPECT_NEAR(model->standardization->deviations[0], plain->standardization->deviations[0], 1e-6);
    for (std::size_t neuron = 0; neuron < 9; ++neuron) {
      EXPECT_NEAR(model->som.weight(neuron, 0), plain->som.weight(neuron, 0), 1e-4);
    }
    EXPECT_EQ(output_of({"som", "quality", "far.map", "far.csv"}).substr(0, 40),
              output_of({"som", "quality", "near.map", "near.csv"}).substr(0, 40));
  }
}

// Numbers near a million are 1/16 apart in single precision.
TEST_F(Offsets, WithoutStandardizationAreReportedIfRoundingLosesSomething) {
  write_tables(0.0);
  std::string third = "a,b\n";
  for (int row = 0; row < 40; ++row) {
    third += fmt::format("{:.4f},{:.4f}\n", 1e6 + value(row, 0) * 4 / 3, value(row, 1));
  }
  write("third.csv", third);
  const std::string warning = "third.csv: column 1 ('a') is rounded";
  const Words sizes{"--rows", "3", "--columns", "3", "-o", "plain.map"};
  const auto trained = [&](Words words) {
    words.insert(words.end(), sizes.begin(), sizes.end());
    return run(words).err;
  };
  EXPECT_NE(trained({"som", "train", "third.csv"}).find(warning), std::string::npos);
  EXPECT_NE(trained({"som", "train", "near.csv", "third.csv"}).find("column 1 ('a') is rounded"),
            std::string::npos);
  EXPECT_EQ(trained({"som", "train", "near.csv"}), "");
  EXPECT_EQ(trained({"som", "train", "third.csv", "--quiet"}), "");
  EXPECT_EQ(trained({"som", "train", "third.csv", "--standardize"}), "");
}

TEST_F(Offsets, OfDataOnStandardInputAreSubtracted) {
  write_tables(1.7e9);
  output_of(training("far.csv", "far.map"));
  ProgramWorld world;
  world.folder = path("");
  const std::string command =
      "cat far.csv | '" + program() + "' som train - --standardize --rows 3 --columns 3 -o x.map";
  const ProgramRun piped = run_program({"/bin/sh", "-c", command}, world);
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_TRUE(read("x.map") == read("far.map"));
}

TEST_F(Offsets, OfFilesInPartsAndOfMissingValuesAreSubtracted) {
  write_tables(1.7e9);
  Words whole = training("far.csv", "whole.map");
  Words parts = training("far.csv", "parts.map");
  for (Words* words : {&whole, &parts}) {
    words->insert(words->end(), {"--training", "batch", "--epochs", "3", "--missing", "mean"});
  }
  parts.insert(parts.end(), {"--memory", "8B"});
  output_of(whole);
  output_of(parts);
  EXPECT_TRUE(read("whole.map") == read("parts.map"));
  write("holes.csv", "a,b\n,0.5\n1700000000.25,\n");
  EXPECT_EQ(run({"som", "map", "whole.map", "holes.csv", "--missing", "mean"}).exit_code, 0);
  const auto model = load_som_model(path("whole.map"));
  EXPECT_NEAR(model->means[0], model->standardization->means[0], 1e-3);
}

TEST_F(Offsets, WithoutAStandardizationAreRefused) {
  write_tables(1.7e9);
  expect_refused(1, {"som", "train", "far.csv", "-o", "x.map"},
                 {"far.csv: column 1 ('a') loses precision"});
}

// One row has no deviation; with that of the map, the loss is known.
TEST_F(Offsets, OfOneRowAreRefusedByAMapOfSmallNumbers) {
  write_tables(0.0);
  output_of({"som", "train", "near.csv", "--rows", "3", "--columns", "3", "-o", "near.map"});
  write("one.csv", "a,b\n100000003,0.5\n");
  expect_refused(1, {"som", "map", "near.map", "one.csv"},
                 {"one.csv: column 1 ('a') loses precision"});
}

}  // namespace
}  // namespace somato
