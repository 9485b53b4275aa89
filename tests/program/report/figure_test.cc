#include <string>
#include <vector>

#include "program/support/program_test.h"

namespace somato {
namespace {

// All of this is refused before the results are read. The tests of the pages save figures.
using Figure = ProgramTest;

Words saving(const std::string& file, const Words& more = {}) {
  Words words{"figure", "none.json", "map", "-o", file};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

TEST_F(Figure, NamesTheFormatsOfItsFile) {
  for (const char* file : {"map", "map.jpg", "map.PDF", "pdf"}) {
    expect_refused(2, saving(file), {file, "known are: .svg, .pdf, .png, .tex, .csv, .txt, .bib"});
  }
}

TEST_F(Figure, RefusesAnImpossibleWidth) {
  for (const char* width : {"85", "mm", "85 mm", "85px", "-85mm", "nanmm", "1e2", "0x55mm"}) {
    expect_refused(2, saving("map.pdf", {"--width", width}), {"--width", "85mm, 8.5cm or 3.3in"});
  }
  for (const char* width : {"19.9mm", "500.1mm", "1.9cm", "20in", "infmm"}) {
    expect_refused(2, saving("map.pdf", {"--width", width}), {width, "is not from 20 to 500 mm"});
  }
}

TEST_F(Figure, AcceptsWidthsInThreeUnits) {
  for (const char* width : {"20mm", "8.5cm", "3.3in", "500mm"}) {
    expect_refused(1, saving("map.pdf", {"--width", width}), {"none.json"});
  }
}

TEST_F(Figure, RefusesFlagsWithoutEffect) {
  expect_refused(2, {{{"figure", "none.json", "map"}, {"a file is missing", "-o figure.pdf"}},
                     {{"figure", "none.json", "-o", "map.pdf"}, {"--output", "NAME"}},
                     {{"figure", "none.json", "--width", "85mm"}, {"--width", "NAME"}},
                     {{"figure", "none.json", "--selection", "run=2"}, {"--selection", "NAME"}},
                     {saving("map.pdf", {"--json"}), {"--json", "NAME"}},
                     {saving("systems.tex", {"--width", "85mm"}), {"--width", ".tex"}},
                     {saving("systems.csv", {"--caption"}), {"--caption", ".csv"}},
                     {{"figure"}, {"RESULTS is required"}}});
}

TEST_F(Figure, NamesTheBrowserThatItRequires) {
  write_study("1");
  output_of({"run", "study.toml", "--data", kTrials, "--out", "out"});
  ProgramWorld world;
  world.environment = {{"PATH", path("")}};
  const ProgramRun done = run({"figure", "out/results.json", "map", "-o", "map.pdf"}, world);
  if (has_no_pages(done)) GTEST_SKIP() << "the program was built without npm";
  EXPECT_EQ(done.exit_code, 1);
  EXPECT_NE(done.err.find("sudo apt-get install chromium"), std::string::npos) << done.err;
  EXPECT_FALSE(std::filesystem::exists(path("map.pdf")));
}

}  // namespace
}  // namespace somato
