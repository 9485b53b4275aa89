#include "base/archives/checksum.h"
#include "base/support/sanitized.h"
#include "program/support/program_test.h"

namespace somato {
namespace {

class BadModel : public ProgramTest {
 protected:
  void expect_unusable(const std::string& name, const Words& says) const {
    expect_refused(1, {{{"som", "map", name, "data.csv", "-o", "x", "--activity", "y"}, says},
                       {{"som", "quality", name, "data.csv"}, says},
                       {{"som", "plot", name, "-o", "x"}, says}});
  }
};

void put(std::string& bytes, std::size_t at, std::uint64_t number, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) {
    bytes[at + i] = static_cast<char>(number >> (8 * i) & 0xff);
  }
}

// The checksum is right again, so that only the claim is wrong.
std::string resealed(std::string bytes) {
  const std::string_view body(bytes.data(), bytes.size() - 4);
  put(bytes, bytes.size() - 4, crc32c(body), 4);
  return bytes;
}

TEST_F(BadModel, CutShortAnywhere) {
  train();
  const std::string whole = read("good.map");
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, std::size_t{11}, std::size_t{12}, std::size_t{20},
        std::size_t{32}, whole.size() / 2, whole.size() - 1}) {
    write("bad", whole.substr(0, length));
    expect_refused(1, {"som", "map", "bad", "data.csv", "-o", "x"}, {"bad: "});
  }
  write("bad", whole + "x");
  expect_unusable("bad", {"bad: ", "bytes"});
}

TEST_F(BadModel, AnyFlippedBitIsNoticed) {
  train();
  const std::string whole = read("good.map");
  constexpr auto kFlips = static_cast<std::size_t>(testing::fewer_if_sanitized(60));
  for (std::size_t at = 0; at < whole.size(); at += 1 + whole.size() / kFlips) {
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ (1 << at % 8));
    write("bad", flipped);
    expect_refused(1, {"som", "map", "bad", "data.csv", "-o", "x"}, {"bad: "});
  }
}

TEST_F(BadModel, SomethingElseAltogether) {
  train();
  output_of({"som", "plot", "good.map", "-o", "picture.svg"});
  write("picture.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16) + std::string(500, '\x7f'));
  for (const char* name : {"data.csv", "picture.svg", "picture.png"}) {
    expect_unusable(name, {std::string(name) + ": this is not a model file", "check the path"});
  }
}

TEST_F(BadModel, AbsurdClaims) {
  train();
  const std::string whole = read("good.map");
  const std::vector<std::pair<std::size_t, std::size_t>> fields{{16, 8}, {24, 4}, {28, 4}};
  for (const auto& [at, size] : fields) {
    std::string bytes = whole;
    put(bytes, at, ~std::uint64_t{0} >> 1, size);
    write("bad", resealed(bytes));
    expect_unusable("bad", {"bad: "});
  }
  // The first dimension of the largest entry, wherever it is: 20 neurons become 2^40.
  std::size_t claims = 0;
  for (std::size_t at = 32; at + 8 < whole.size(); at += 8) {
    std::string bytes = whole;
    if (whole.substr(at, 8) != std::string("\x14\0\0\0\0\0\0\0", 8)) continue;
    put(bytes, at, std::uint64_t{1} << 40, 8);
    write("bad", resealed(bytes));
    expect_unusable("bad", {"bad: "});
    ++claims;
  }
  EXPECT_GE(claims, 1u);
}

TEST_F(BadModel, ANewerVersionIsSaidToBeNewer) {
  train();
  std::string bytes = read("good.map");
  put(bytes, 12, 2, 4);
  write("bad", resealed(bytes));
  expect_unusable("bad", {"bad: ", "newer"});
}

TEST_F(BadModel, PathsThatAreNoFiles) {
  train();
  std::filesystem::create_symlink("nowhere", path("dangling"));
  std::filesystem::create_symlink("loop", path("loop"));
  expect_unusable("missing", {"missing: cannot open", "No such file"});
  expect_unusable(".", {".: cannot read", "name a file, not a folder"});
  expect_unusable("dangling", {"dangling: cannot open", "No such file"});
  expect_unusable("loop", {"loop: cannot open", "symbolic links"});
}

}  // namespace
}  // namespace somato
