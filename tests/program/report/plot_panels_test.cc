#include <fmt/format.h>

#include <regex>

#include "program/support/program_test.h"

namespace somato {
namespace {

// Pictures of a map of two groups of points in a plane, with hostile names.
class PlotPanels : public ProgramTest {
 protected:
  static Words with(Words words, const Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
  }

  void SetUp() override {
    ProgramTest::SetUp();
    std::string table = "x,a & <b>,class\n";
    for (int i = 0; i < 12; ++i) {
      table +=
          fmt::format("{},{},{}\n", i % 3 + (i % 2) * 10, i, i % 2 == 0 ? "<even>" : "odd & \"1\"");
    }
    write("t.csv", table);
    output_of({"som", "train", "t.csv", "--label-column", "class", "-o", "t.somato", "--rows", "3",
               "--columns", "4", "--iterations", "200"});
  }

  std::string drawn(const Words& flags) {
    output_of(with({"som", "plot", "t.somato", "t.csv", "--label-column", "class", "-o", "p.svg"},
                   flags));
    return read("p.svg");
  }
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(PlotPanels, EveryPanelIsDrawnByItsName) {
  const std::pair<std::string, std::string> titles[] = {{"u_matrix_edges", ">U-matrix with edges<"},
                                                        {"label_text", ">Label text<"},
                                                        {"pies", ">Classes<"},
                                                        {"clusters", ">Clusters<"},
                                                        {"dendrogram", ">Dendrogram<"},
                                                        {"projection", ">Projection<"},
                                                        {"trajectory", ">Trajectory<"}};
  for (const auto& [panel, title] : titles) {
    const std::string svg = drawn({"--panels", panel});
    EXPECT_TRUE(has(svg, title)) << panel;
    EXPECT_FALSE(has(svg, ">U-matrix<")) << panel;
  }
}

TEST_F(PlotPanels, UsualPanelsAreThoseOfBefore) {
  const std::string svg = drawn({});
  for (const char* title : {">U-matrix<", ">Hits<", ">Labels<", ">x<", ">a &amp; &lt;b&gt;<"}) {
    EXPECT_TRUE(has(svg, title)) << title;
  }
  for (const char* title : {">Classes<", ">Projection<", "outlines"}) {
    EXPECT_FALSE(has(svg, title)) << title;
  }
}

TEST_F(PlotPanels, ClustersAreOutlinedInAllPanels) {
  const std::string svg = drawn({"--panels", "u_matrix,hits,pies", "--clusters", "ward:2"});
  std::size_t outlines = 0;
  for (std::size_t at = svg.find("\"outlines\""); at != std::string::npos;
       at = svg.find("\"outlines\"", at + 1)) {
    ++outlines;
  }
  EXPECT_EQ(outlines, 3U);
}

TEST_F(PlotPanels, NamesOfTheMapAreWrittenWithoutData) {
  output_of({"som", "plot", "t.somato", "--panels", "label_text,projection", "-o", "p.svg"});
  EXPECT_TRUE(has(read("p.svg"), "&lt;even&gt;"));
}

TEST_F(PlotPanels, ATrajectoryHasTheChosenRows) {
  const std::regex line_break("</text>\\s*<text[^>]*>");
  const std::string svg = std::regex_replace(
      drawn({"--panels", "trajectory", "--trajectory", "3..7"}), line_break, " ");
  EXPECT_TRUE(has(svg, "Samples 3 (black circle) to 7 (black square)"));
}

TEST_F(PlotPanels, PlanesMayHaveOneScale) {
  const Words planes{"--panels", "components", "--component-order", "likeness"};
  const std::string own = drawn(planes);
  const std::string common = drawn(with(planes, {"--component-scale", "common"}));
  EXPECT_NE(own, common);
}

TEST_F(PlotPanels, WhatCannotBeDrawnIsRefused) {
  const Words plot{"som", "plot", "t.somato", "t.csv", "--skip", "class", "-o", "p.svg"};
  const auto of = [&](const Words& flags) { return with(plot, flags); };
  expect_refused(
      2,
      {{of({"--panels", "pies"}), {"--panels: pies cannot be drawn without labelled data"}},
       {of({"--panels", "dendrogram", "--clusters", "k_means:2"}), {"--clusters", "hierarchical"}},
       {of({"--clusters", "wart"}), {"--clusters", "did you mean 'ward'?"}},
       {of({"--clusters", "ward:0"}), {"--clusters", "not a number of clusters"}},
       {of({"--clusters", "ward:99"}), {"--clusters"}},
       {of({"--trajectory", "1..2"}), {"--trajectory", "no effect without the panel trajectory"}},
       {of({"--panels", "trajectory", "--trajectory", "0..2"}), {"--trajectory", "FIRST..LAST"}},
       {of({"--panels", "trajectory", "--trajectory", "5..2"}), {"--trajectory", "FIRST..LAST"}},
       {of({"--panels", "trajectory", "--trajectory", "2..13"}), {"12 rows, not 13"}},
       {of({"--panels", "hits", "--size-by-hits"}), {"--size-by-hits", "pies"}},
       {of({"--component-order", "size"}), {"--component-order", "size"}},
       {{"som", "plot", "t.somato", "--panels", "trajectory", "-o", "p.svg"},
        {"trajectory cannot be drawn without data"}}});
}

}  // namespace
}  // namespace somato
