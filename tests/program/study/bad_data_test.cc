#include <limits>

#include "program/support/program_test.h"
#include "somato/core/matrix.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

class BadData : public ProgramTest {
 protected:
  // Every command that reads data refuses it alike.
  void expect_unusable(const std::string& name, const Words& says) const {
    expect_refused(1, {{{"som", "train", name, "-o", "x"}, says},
                       {{"som", "map", "good.map", name, "-o", "x", "--activity", "y"}, says},
                       {{"som", "quality", "good.map", name}, says},
                       {{"som", "plot", "good.map", name, "-o", "x"}, says}});
  }
};

// An NPY file with this header and these bytes, by the format's description.
std::string npy(std::string header, const std::string& values) {
  header.resize(118, ' ');
  header.back() = '\n';
  return std::string("\x93NUMPY\x01\x00\x76\x00", 10) + header + values;
}

TEST_F(BadData, InText) {
  train();
  const std::vector<std::pair<std::string, Words>> cases{
      {"1,2,3\n4,nan,6\n", {"bad:2:3", "'nan'", "not a finite number", "leave the row out"}},
      {"1,2,3\n4,5,inf\n", {"bad:2:5", "'inf'"}},
      {"1,2,3\n-Infinity,5,6\n", {"bad:2:1", "'-Infinity'"}},
      {"1,2,3\n4,,6\n", {"bad:2:3", "empty"}},
      {"1,2,3\n4,5,six\n", {"bad:2:5", "'six' is not a number"}},
      {"1,2,3\n4,5,1e99\n", {"bad:2:5", "'1e99'", "scale"}},
      {"1;2;3\n4;5,5;6\n", {"bad:2:3", "'5,5'", "decimals with a point"}},
      {"1,2,3\n4,5\n", {"bad:2", "expected 3 fields, found 2"}},
      {"1,2,3\n4,5,6,7\n", {"bad:2", "expected 3 fields, found 4"}},
      {"", {"bad", "no rows of numbers"}},
      {"\n\n", {"bad", "no rows of numbers"}},
      {"a,b,c\n", {"bad", "no rows of numbers"}},
      {"1,2,3\n4,\"5,6\n", {"bad:2"}},
      {std::string("1,2,3\n4,\0,6\n", 12), {"bad"}},
      {"1,2,3\n4,\xff,6\n", {"bad"}}};
  for (const auto& [text, says] : cases) {
    write("bad", text);
    expect_unusable("bad", says);
  }
}

TEST_F(BadData, InNpy) {
  train();
  Matrix<float> matrix(3, 3, 1.0f);
  matrix(1, 2) = std::numeric_limits<float>::quiet_NaN();
  const std::string not_a_number = encode_npy(matrix);
  matrix(1, 2) = -std::numeric_limits<float>::infinity();
  const std::string infinite = encode_npy(matrix);
  const auto header = [](const std::string& type, const std::string& shape) {
    return "{'descr': '" + type + "', 'fortran_order': False, 'shape': " + shape + ", }";
  };
  const std::vector<std::pair<std::string, Words>> cases{
      {not_a_number, {"bad: ", "row 2, column 3", "not a finite"}},
      {infinite, {"bad: ", "row 2, column 3", "not a finite"}},
      {infinite.substr(0, 140), {"bad", "truncated"}},
      {infinite.substr(0, 40), {"bad", "header"}},
      {infinite.substr(0, 6), {"bad"}},
      {infinite + "more", {"bad"}},
      {npy(header("<f4", "(1000000000000000, 3)"), "1234"), {"bad", "truncated"}},
      {npy(header("<f4", "(4294967296, 4294967296)"), "1234"), {"bad", "truncated"}},
      {npy(header("<f4", "(99999999999999999999999, 3)"), "1234"), {"bad"}},
      {npy(header("<f4", "(0, 3)"), ""), {"bad", "empty"}},
      {npy(header("<f4", "(2, 3, 4)"), std::string(96, '\0')), {"bad", "3 dimensions", "reshape"}},
      {npy(header("<c8", "(1, 3)"), std::string(24, '\0')), {"bad", "c8"}},
      {npy("a header of nonsense", ""), {"bad"}}};
  for (const auto& [bytes, says] : cases) {
    write("bad", bytes);
    expect_unusable("bad", says);
  }
}

TEST_F(BadData, OfAnotherWidthThanTheMap) {
  train();
  write("wide.csv", "1,2,3,4\n5,6,7,8\n");
  const Words says{"wide.csv", "4 columns", "the map requires 3", "trained on"};
  expect_refused(1, {{{"som", "map", "good.map", "wide.csv"}, says},
                     {{"som", "quality", "good.map", "wide.csv"}, says},
                     {{"som", "plot", "good.map", "wide.csv", "-o", "x"}, says}});
}

TEST_F(BadData, TooLittleToLearnFrom) {
  write("one.csv", "1,2,3\n");
  expect_refused(1, {"som", "train", "one.csv", "-o", "x"},
                 {"one.csv", "only one sample", "at least two rows"});
}

TEST_F(BadData, ConstantColumnsAreNamedAndMayBeKept) {
  write("plain.csv", "1,7,3\n4,7,6\n");
  write("named.csv", "height,weight,age\n1,7,3\n4,7,6\n");
  expect_refused(1, {{{"som", "train", "plain.csv", "-o", "x"},
                      {"plain.csv", "column 2 ", "same value", "--keep-constant-columns"}},
                     {{"som", "train", "named.csv", "-o", "x", "--standardize"},
                      {"named.csv", "column 2 ('weight')", "--keep-constant-columns"}}});
  for (const char* more : {"--keep-constant-columns", "--standardize"}) {
    output_of({"som", "train", "named.csv", "-o", "x", "--rows", "2", "--columns", "2",
               more == std::string("--standardize") ? "--keep-constant-columns" : "--seed=2",
               more});
    EXPECT_FALSE(read("x").empty());
  }
}

TEST_F(BadData, Labels) {
  train();
  write("few", "a\nb\n");
  write("gap", "a\n\nb\n");
  write("many", std::string(26, 'x').replace(1, 25, "\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx\nx"));
  write("none", "");
  write("named.csv", "kind,a,b\nx,1,2\n,3,4\n");
  write("plain.csv", "1,2\n3,4\n");
  const auto train_with = [](const std::string& labels) {
    return Words{"som", "train", "data.csv", "--labels", labels, "-o", "x"};
  };
  expect_refused(
      1, {{train_with("few"), {"few", "2 labels for 12 rows", "one label per line"}},
          {train_with("many"), {"many", "13 labels for 12 rows"}},
          {train_with("gap"), {"gap:2", "line is empty"}},
          {train_with("none"), {"none"}},
          {train_with("missing"), {"missing", "No such file"}},
          {train_with("."), {".: ", "folder"}},
          {{"som", "quality", "good.map", "data.csv", "--labels", "few"}, {"2 labels"}},
          {{"som", "plot", "good.map", "data.csv", "--labels", "few", "-o", "x"}, {"2 labels"}},
          {{"som", "train", "named.csv", "--label-column", "kind", "-o", "x"},
           {"named.csv:3:1", "label is empty"}}});
  expect_refused(2, {{{"som", "train", "named.csv", "--label-column", "kid", "-o", "x"},
                      {"named.csv", "no column 'kid'", "did you mean 'kind'?"}},
                     {{"som", "train", "plain.csv", "--label-column", "9", "-o", "x"},
                      {"plain.csv", "no column '9'", "there are 2 columns"}}});
}

TEST_F(BadData, PathsThatAreNoFiles) {
  train();
  std::filesystem::create_symlink("nowhere", path("dangling"));
  std::filesystem::create_symlink("loop", path("loop"));
  expect_unusable("missing", {"missing: cannot open", "No such file", "check the path"});
  expect_unusable(".", {".: cannot read", "name a file, not a folder"});
  expect_unusable("dangling", {"dangling: cannot open", "No such file"});
  expect_unusable("loop", {"loop: cannot open", "symbolic links"});
  expect_unusable("data.csv/x", {"data.csv/x: cannot open", "not a folder"});
}

}  // namespace
}  // namespace somato
