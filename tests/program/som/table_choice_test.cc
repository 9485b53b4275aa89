#include <fstream>

#include "program/support/program_test.h"
#include "somato/files/npy.h"
#include "somato/graph/som_model.h"

namespace somato {
namespace {

Words with(Words words, const Words& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Tables that differ in what beside two features they hold; oracles are tables cut by hand.
class TableChoice : public ProgramTest {
 protected:
  static Words training(const Words& more) {
    return with({"som", "train", "--rows", "2", "--columns", "3", "--training", "batch", "--epochs",
                 "3", "-o", "x.map"},
                more);
  }

  // The map that training writes; the last words it said are in said_.
  std::string map_of(const Words& more) {
    said_ = output_of(training(more));
    return read("x.map");
  }

  void write_tables() const {
    write("wide.csv",
          "id,mass,fruit,length,note,slipped\n"
          "1,182,apple,75,red,0\n2,170,apple,72,,1\n3,195,apple,78,dark red,0\n"
          "4,118,banana,180,,1\n5,126,banana,187,long,0\n6,109,banana,174,,7\n");
    write("cut.csv",
          "mass,length,fruit\n182,75,apple\n170,72,apple\n195,78,apple\n"
          "118,180,banana\n126,187,banana\n109,174,banana\n");
    write("rows.csv", "182,75\n170,72\n195,78\n118,180\n126,187\n109,174\n");
  }

  std::string said_;
};

const std::string kTablePieces = "--memory=8B";

TEST_F(TableChoice, ColumnsLeftOutAreAsIfTheyWereNotThere) {
  write_tables();
  const std::string expected = map_of({"cut.csv", "--label-column", "fruit"});
  EXPECT_EQ(said_.find("left_out"), std::string::npos) << said_;
  for (const Words& choice : {Words{"--skip", "id,note,slipped"},
                              {"--skip", "id, note ,s*"},
                              {"--columns-to-use", "mass,length"},
                              {"--columns-to-use", "*s*,length", "--skip", "slipped"}}) {
    for (const Words& memory : {Words{}, {kTablePieces}}) {
      SCOPED_TRACE(::testing::PrintToString(choice));
      EXPECT_TRUE(map_of(with(with({"wide.csv", "--label-column", "fruit"}, choice), memory)) ==
                  expected);
      EXPECT_NE(said_.find("of 2 features\nfeatures mass, length\nlabel fruit\n"
                           "left_out id, note, slipped\n"),
                std::string::npos)
          << said_;
    }
  }
}

TEST_F(TableChoice, ColumnsWithoutNamesAreChosenByNumber) {
  write_tables();
  write("bare.csv", "1,182,a,75\n2,170,b,72\n3,195,c,78\n4,118,d,180\n5,126,e,187\n6,109,f,174\n");
  write("bare.npy",
        encode_npy(Matrix<float>(
            6, 3, {0, 182, 75, 0, 170, 72, 0, 195, 78, 0, 118, 180, 0, 126, 187, 0, 109, 174})));
  const std::string expected = map_of({"rows.csv"});
  EXPECT_NE(said_.find("\nfeatures 1, 2\n"), std::string::npos) << said_;
  EXPECT_TRUE(map_of({"bare.csv", "--skip", "1,3"}) == expected);
  EXPECT_NE(said_.find("\nfeatures 2, 4\nleft_out 1, 3\n"), std::string::npos) << said_;
  EXPECT_TRUE(map_of({"bare.csv", "--columns-to-use", "2,4", kTablePieces}) == expected);
  EXPECT_TRUE(map_of({"bare.npy", "--columns-to-use", "2..3"}) == expected);
  EXPECT_TRUE(map_of({"bare.npy", "--skip", "1", kTablePieces}) == expected);
  const ProgramRun mapped = run({"som", "map", "x.map", "bare.npy", "--columns-to-use", "2..3"});
  EXPECT_EQ(mapped.out, output_of({"som", "map", "x.map", "rows.csv"}));
  EXPECT_EQ(mapped.err, "somato: bare.npy: left out 1\n");
  expect_refused(1, {"som", "map", "x.map", "bare.npy"}, {"3 columns", "--columns-to-use"});
}

// Pandas writes its index without a name.
TEST_F(TableChoice, ColumnsWithoutNamesAreRefusedUnlessTheirNumberIsGiven) {
  write("index.csv", ",A,B\n0,1.5,2\n1,3,4\n2,5,6\n");
  write("plain.csv", "A,B\n1.5,2\n3,4\n5,6\n");
  const std::string expected = map_of({"plain.csv"});
  for (const Words& memory : {Words{}, {kTablePieces}}) {
    expect_refused(1, with(training({"index.csv"}), memory),
                   {"index.csv: column 1 has no name", "index=False", "--skip 1"});
    EXPECT_TRUE(map_of(with({"index.csv", "--skip", "1"}, memory)) == expected);
    EXPECT_NE(said_.find("\nfeatures A, B\nleft_out (column 1)\n"), std::string::npos) << said_;
    EXPECT_TRUE(map_of(with({"index.csv", "--columns-to-use", "A,B"}, memory)) == expected);
    const ProgramRun mapped = run(with({"som", "map", "x.map", "index.csv"}, memory));
    EXPECT_EQ(mapped.out, output_of({"som", "map", "x.map", "plain.csv"}));
    EXPECT_EQ(mapped.err, "somato: index.csv: left out (column 1)\n");
  }
  map_of({"index.csv", "--columns-to-use", "1,A,B"});
  EXPECT_NE(said_.find("of 3 features\nfeatures (column 1), A, B\n"), std::string::npos) << said_;
  EXPECT_EQ(output_of({"som", "quality", "x.map", "index.csv"}).substr(0, 10), "samples 3\n");
}

TEST_F(TableChoice, TheLineOfSpreadsheetsDeclaresTheSeparator) {
  write("plain.csv", "A,B\n1.5,2\n3,4\n");
  write("sheet.csv", "sep=;\r\nA;B\r\n1,5;2\r\n3;4\r\n");
  const std::string expected = map_of({"plain.csv"});
  for (const Words& memory : {Words{}, {kTablePieces}}) {
    EXPECT_TRUE(map_of(with({"sheet.csv", "--decimal", "comma"}, memory)) == expected);
  }
}

TEST_F(TableChoice, NumberedNamesAreListedInShort) {
  write("taxels.csv", "t8,t9,t10,t11,x_01,x_02,y\n1,2,3,4,5,6,7\n2,3,4,5,6,8,9\n");
  map_of({"taxels.csv"});
  EXPECT_NE(said_.find("\nfeatures t8..t11, x_01, x_02, y\n"), std::string::npos) << said_;
}

TEST_F(TableChoice, WeightsAreDrawnOnASkinOfColumns) {
  write_tables();
  map_of({"cut.csv", "--label-column", "fruit"});
  write("pad.toml",
        "[layout.touch]\nplaces = [[0, 0], [0, 5]]\nelements = [\"length\", \"mass\"]\n");
  const Words plot{"som", "plot", "x.map", "--layout", "pad.toml", "-o", "a.svg"};
  output_of(plot);
  const std::string all = read("a.svg");
  EXPECT_NE(all.find("row 2, column 3"), std::string::npos);
  output_of(with(plot, {"--neuron", "2,1"}));
  const std::string one = read("a.svg");
  EXPECT_NE(one.find("row 2, column 1"), std::string::npos);
  EXPECT_EQ(one.find("row 1, column 1"), std::string::npos);
  expect_refused(
      2, {{with(plot, {"--neuron", "3,1"}), {"--neuron", "'3,1'", "from 1,1 to 2,3"}},
          {with(plot, {"--neuron", "2"}), {"--neuron", "from 1,1 to 2,3"}},
          {with(plot, {"--panels", "hits"}), {"--panels", "no effect"}},
          {with(plot, {"cut.csv"}), {"shows no data"}},
          {{"som", "plot", "x.map", "--neuron", "1,1", "-o", "b.svg"}, {"--neuron", "--layout"}}});
  write("pad.toml", "[layout.touch]\nplaces = [[0, 0], [0, 5], [0, 9]]\n");
  expect_refused(2, plot, {"pad.toml:1", "3 places, but 'touch' has 2 elements"});
}

// The map knows what it learned: other tables are read by these names, in any order.
TEST_F(TableChoice, ATrainedMapPicksItsColumnsByName) {
  write_tables();
  map_of({"wide.csv", "--label-column", "fruit", "--skip", "id,note,slipped"});
  write("turned.csv", "length,extra,mass\n75,a,182\n180,b,118\n");
  write("plain.csv", "182,75\n118,180\n");
  const std::string expected = output_of({"som", "map", "x.map", "plain.csv"});
  for (const Words& memory : {Words{}, {kTablePieces}}) {
    const ProgramRun done = run(with({"som", "map", "x.map", "turned.csv"}, memory));
    EXPECT_EQ(done.out, expected);
    EXPECT_EQ(done.err, "somato: turned.csv: left out extra\n");
  }
  const std::string quality =
      output_of({"som", "quality", "x.map", "cut.csv", "--label-column", "fruit"});
  const ProgramRun wide = run({"som", "quality", "x.map", "wide.csv", "--label-column", "fruit"});
  EXPECT_EQ(wide.out, quality);
  EXPECT_EQ(wide.err, "somato: wide.csv: left out id, note, slipped\n");
  output_of({"som", "plot", "x.map", "cut.csv", "--label-column", "fruit", "-o", "a.svg"});
  const ProgramRun plot =
      run({"som", "plot", "x.map", "wide.csv", "--label-column", "fruit", "-o", "b.svg"});
  EXPECT_EQ(plot.err, wide.err);
  EXPECT_EQ(read("a.svg"), read("b.svg"));
  write("short.csv", "mass,lenght\n1,2\n3,4\n");
  for (const Words& command : {Words{"map"}, {"quality"}, {"plot", "-o", "c.svg"}}) {
    expect_refused(1, with(with({"som"}, command), {"x.map", "short.csv"}),
                   {"short.csv: column 'length' is required", "did you mean 'lenght'?"});
    expect_refused(1, with(with({"som"}, command), {"x.map", "cut.csv", "--skip", "mass"}),
                   {"column 'mass' is required, but is left out"});
  }
}

TEST_F(TableChoice, IsRefusedWhereItIsWrong) {
  write_tables();
  const auto train = [&](const Words& more) { return training(with({"wide.csv"}, more)); };
  const Words skip_all{"--skip", "*"};
  expect_refused(
      2, {{train({"--skip", "sliped"}), {"wide.csv: there is no column 'sliped'", "'slipped'?"}},
          {train({"--columns-to-use", "mas"}), {"no column 'mas'", "did you mean 'mass'?"}},
          {train(skip_all), {"no numeric column is left"}},
          {train({"--skip", "fruit", "--label-column", "fruit"}), {"contains the labels"}},
          {train({"--columns-to-use", "mass,id", "--skip", "id"}),
           {"'id' is both selected and skipped"}},
          {train({"--skip", "mass,,id"}), {"--skip: a name is empty"}},
          {train({"--skip", "2"}), {"select them by name"}},
          {train({"--missing", "men"}), {"--missing: ", "'men'", "did you mean 'mean'?"}},
          {train({"--decimal", ","}), {"--decimal: unknown decimal mark ','"}},
          {train({"--decimal", "comma"}), {"wide.csv:1: commas separate the fields"}}});
  for (const Words& memory : {Words{}, {kTablePieces}}) {
    expect_refused(
        1, with(train({}), memory),
        {"wide.csv:2:7: 'apple' is not a number", "--label-column", "--skip 'fruit,note'"});
  }
  map_of({"cut.csv", "--label-column", "fruit"});
  for (const Words& flag : {Words{"--skip", "x"}, {"--missing", "mean"}, {"--header", "no"}}) {
    expect_refused(2, with({"som", "plot", "x.map", "-o", "p.svg"}, flag),
                   {flag[0] + ": has no effect without data"});
  }
}

TEST_F(TableChoice, OfStandardInputIsTheSame) {
  write_tables();
  const std::string expected = map_of({"wide.csv", "--skip", "fruit,note"});
  std::string command;
  for (const std::string& word : with({program()}, training({"-", "--skip", "fruit,note"}))) {
    command += "'" + word + "' ";
  }
  ProgramWorld world;
  world.folder = path("");
  const ProgramRun piped = run_program({"/bin/sh", "-c", "cat wide.csv | " + command}, world);
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_TRUE(read("x.map") == expected);
}

TEST_F(TableChoice, DecimalCommasAreReadWhenTheyAreAnnounced) {
  write("point.csv", "a,b\n1.5,2\n3,-4.25\n0.5,1e2\n");
  write("comma.csv", "a;b\n1,5;2\n3;-4,25\n,5;1,0e2\n");
  write("thousands.csv", "a;b\n1.000,5;2\n3;4\n");
  write("quoted.csv", "a,b\n\"1,000\",2\n3,4\n");
  const std::string expected = map_of({"point.csv"});
  for (const Words& memory : {Words{}, {kTablePieces}}) {
    EXPECT_TRUE(map_of(with({"comma.csv", "--decimal", "comma"}, memory)) == expected);
    EXPECT_EQ(output_of(with({"som", "map", "x.map", "comma.csv", "--decimal", "comma"}, memory)),
              output_of({"som", "map", "x.map", "point.csv"}));
    expect_refused(1, with(training({"comma.csv"}), memory),
                   {"comma.csv:2:1: '1,5' is not a number", "--decimal comma"});
    expect_refused(1, with(training({"quoted.csv"}), memory),
                   {"quoted.csv:2:1: '1,000' is not a number", "thousands without a separator"});
    expect_refused(1, with(training({"thousands.csv", "--decimal", "comma"}), memory),
                   {"thousands.csv:2:1: '1.000,5' is not a number", "without a point"});
  }
  write("a.npy", encode_npy(Matrix<float>(2, 2, {1, 2, 3, 4})));
  expect_refused(2, training({"a.npy", "--decimal", "comma"}), {"no decimal comma"});
}

}  // namespace
}  // namespace somato
