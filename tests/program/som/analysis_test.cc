#include "program/support/program_test.h"

namespace somato {
namespace {

// A map of eight rows in two groups, and one of equal rows.
class Analysis : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    write("data.csv", "a,b,kind\n0,0,x\n1,0,x\n0,1,x\n1,1,x\n9,9,y\n8,9,y\n9,8,y\n8,8,y\n");
    write("equal.csv", "2,3\n2,3\n2,3\n2,3\n");
    output_of({"som", "train", "data.csv", "--label-column", "kind", "--rows", "2", "--columns",
               "3", "-o", "a.map"});
    output_of({"som", "train", "equal.csv", "--keep-constant-columns", "--rows", "2", "--columns",
               "2", "-o", "equal.map"});
  }
};

TEST_F(Analysis, MeasuresAreAddedToTheDefaultOutput) {
  const std::string plain = output_of({"som", "quality", "a.map", "data.csv", "--quiet"});
  const std::string more = output_of({"som", "quality", "a.map", "data.csv", "--quiet",
                                      "--measures", "explained_variance,neurons"});
  EXPECT_TRUE(more.starts_with(plain)) << more;
  EXPECT_NE(more.find("\nexplained_variance 0.9"), std::string::npos) << more;
  EXPECT_NE(more.find("\nneuron 5, row 1, column 2, samples "), std::string::npos) << more;
  EXPECT_EQ(more.find("trustworthiness"), std::string::npos);
}

TEST_F(Analysis, MeasuresOfEqualRowsAreNotANumberWhereTheyAreNotDefined) {
  const std::string text =
      output_of({"som", "quality", "equal.map", "equal.csv", "--measures", "all"});
  EXPECT_NE(text.find("explained_variance nan\n"), std::string::npos) << text;
  const std::string json =
      output_of({"som", "quality", "equal.map", "equal.csv", "--measures", "all", "--json"});
  EXPECT_NE(json.find("\"explained_variance\": null"), std::string::npos) << json;
  EXPECT_EQ(output_of({"som", "cluster", "equal.map"}),
            "neuron,row,column,cluster\n0,0,0,0\n1,0,1,0\n2,1,0,0\n3,1,1,0\n");
}

TEST_F(Analysis, MeasuresThatCannotBeAreRefused) {
  const auto refused = [&](Words more, const Words& texts) {
    more.insert(more.begin(), {"som", "quality", "a.map", "data.csv"});
    expect_refused(2, more, texts);
  };
  refused({"--measures", "trust"}, {"--measures", "trustworthiness"});
  refused({"--measures", "classes"}, {"--measures", "without labels", "--label-column"});
  refused({"--shuffles", "1"}, {"--shuffles", "without --measures"});
  for (const char* flag : {"--neighbours", "--ranked-samples", "--seed"}) {
    refused({"--measures", "explained_variance,neurons", flag, "3"}, {flag, "no effect"});
  }
  refused({"--measures", "neurons", "--shuffles", "3"}, {"--shuffles", "no effect"});
  refused({"--measures", "all", "--neighbours", "0"}, {"--neighbours", "1 to 1000000000"});
}

TEST_F(Analysis, ClustersAreNamedBySamplesOrByTheMap) {
  const std::string summary = output_of({"som", "cluster", "a.map", "data.csv", "--label-column",
                                         "kind", "--count", "2", "-o", "clusters.csv"});
  EXPECT_NE(summary.find("4 samples, x, purity 1\n"), std::string::npos) << summary;
  EXPECT_NE(summary.find("4 samples, y, purity 1\n"), std::string::npos) << summary;
  const std::string named = output_of({"som", "cluster", "a.map", "--count", "2"});
  EXPECT_TRUE(named.starts_with("neuron,row,column,cluster,name\n0,0,0,0,")) << named;
}

TEST_F(Analysis, ClustersThatCannotBeAreRefused) {
  const auto refused = [&](Words more, const Words& texts) {
    more.insert(more.begin(), {"som", "cluster", "a.map"});
    expect_refused(2, more, texts);
  };
  refused({"--count", "7"}, {"--count", "only 6 neurons"});
  refused({"--by-hits", "true"}, {"--by-hits", "without data"});
  refused({"--samples", "samples.csv"}, {"--samples", "without data"});
  refused({"--method", "k_means", "--merges", "m.csv"}, {"--merges", "ward"});
  refused({"--method", "k_means", "--connected", "true"}, {"--connected", "k_means"});
  refused({"--count", "2", "--most-clusters", "4"}, {"--most-clusters", "number is given"});
}

TEST_F(Analysis, FeaturesOfANeuronWithoutSamplesAreRefused) {
  write("one.csv", "a,b\n0,0\n");
  expect_refused(1, {"som", "features", "a.map", "one.csv", "--neuron", "2,3"},
                 {"--neuron", "wins no sample"});
  expect_refused(2, {"som", "features", "a.map", "one.csv", "--neuron", "3,1"}, {"--neuron"});
}

}  // namespace
}  // namespace somato
