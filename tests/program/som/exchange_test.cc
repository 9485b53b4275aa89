#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

class SomExchange : public ProgramTest {
 protected:
  // Thirty rows with labels, a column far from 0 and a missing value.
  void SetUp() override {
    std::string rows = "time,length,fruit\n";
    for (int i = 0; i < 30; ++i) {
      rows += std::to_string(1700000000 + i * i) + "," +
              (i == 7 ? std::string("NA") : std::to_string(i % 5)) + "," +
              (i % 2 == 0 ? "apple" : "\"pear, green\"") + "\n";
    }
    write("rows.csv", rows);
  }

  std::string winners(const std::string& map) const {
    const ProgramRun done =
        run({"som", "map", map, "rows.csv", "--label-column", "fruit", "--missing", "mean"});
    EXPECT_EQ(done.exit_code, 0) << done.err;
    return done.out;
  }
};

TEST_F(SomExchange, ExportAndImportAreTheIdentity) {
  for (const Words& more : {Words{"--standardize"}, Words{"--standardize", "--lattice", "hexagonal",
                                                          "--training", "batch"}}) {
    Words words{"som",       "train", "rows.csv",  "--label-column", "fruit", "--rows", "2",
                "--columns", "3",     "--missing", "mean",           "-o",    "a.map"};
    words.insert(words.end(), more.begin(), more.end());
    output_of(words);
    EXPECT_NE(output_of({"som", "export", "a.map", "-o", "a.npz"}).find("6 neurons, 2 features"),
              std::string::npos);
    output_of({"som", "import", "a.npz", "-o", "b.map"});
    EXPECT_EQ(bytes_of(path("b.map")), bytes_of(path("a.map")));
    EXPECT_EQ(winners("b.map"), winners("a.map"));
  }
}

TEST_F(SomExchange, MapsOfOtherProgramsAreReadDrawnAndMeasured) {
  write("lab.cod", "2 hexa 2 1 gaussian\n#n mass length\n1 2 apple ripe\n4 5 pear\n");
  write("lab.csv", "length,mass\n5,4\n2,1\n2,2\n");  // the names select the columns
  const ProgramRun done = run({"som", "import", "lab.cod", "-o", "lab.map"});
  EXPECT_EQ(done.exit_code, 0);
  EXPECT_NE(done.err.find("lab.cod: units with several labels: 1"), std::string::npos) << done.err;
  EXPECT_EQ(output_of({"som", "map", "lab.map", "lab.csv"}),
            "sample,winner,row,column,distance,label\n"
            "1,1,0,1,0,pear\n2,0,0,0,0,apple\n3,0,0,0,1,apple\n");
  EXPECT_NE(output_of({"som", "quality", "lab.map", "lab.csv"}).find("quantization_error 0.333333"),
            std::string::npos);
  output_of({"som", "plot", "lab.map", "-o", "lab.svg"});
  EXPECT_NE(bytes_of(path("lab.svg")).find("mass"), std::string::npos);
}

TEST_F(SomExchange, SaysWhatIsWrongAndWhatToDo) {
  ASSERT_TRUE(write_npy(path("flat.npy"), Matrix<float>(6, 2, std::vector<float>(12, 0.5F))));
  expect_refused(2, {"som", "import", "flat.npy", "-o", "x"}, {"flat.npy: ", "--rows"});
  expect_refused(2, {"som", "import", "flat.npy", "--rows", "4", "-o", "x"}, {"6 neurons"});
  expect_refused(2, {"som", "import", "flat.npy", "--rows", "2", "--features", "a", "-o", "x"},
                 {"1 names for 2 features"});
  expect_refused(1, {"som", "import", "rows.csv", "-o", "x"}, {"no map that is known", ".cod"});
  expect_refused(1, {"som", "import", "none", "-o", "x"}, {"none"});
  expect_refused(1, {"som", "export", "rows.csv", "-o", "x"}, {"rows.csv"});
  output_of({"som", "import", "flat.npy", "--rows", "2", "--features", "a,b", "-o", "flat.map"});
  output_of({"som", "export", "flat.map", "-o", "flat.npz"});
  expect_refused(2, {"som", "export", "flat.map", "--module", "map", "-o", "x"}, {"--module: "});
  expect_refused(2, {"som", "import", "flat.npz", "--topology", "torus", "-o", "x"},
                 {"--topology", "no effect"});
  expect_refused(2, {"som", "import", "flat.npz", "--variable", "weights", "-o", "x"},
                 {"variable", "no effect"});
}

}  // namespace
}  // namespace somato
