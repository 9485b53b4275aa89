#include "base/numbers/number_source.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "base/files/whole_file.h"
#include "base/numbers/number_file.h"
#include "base/support/failing_file_system.h"
#include "base/support/places.h"
#include "base/support/temporary_folder.h"
#include "somato/core/random.h"
#include "somato/files/npy.h"

namespace somato {
namespace {

struct Read {
  std::vector<float> values;
  std::vector<std::string> labels;
  std::vector<std::size_t> counts;
};

Result<Read> read_all(NumberSource& source) {
  if (auto rewound = source.rewind(); !rewound) return fail(rewound.error());
  Read read;
  for (;;) {
    const auto part = source.next_part();
    if (!part) return fail(part.error());
    if (!*part) return read;
    const NumberPart& rows = **part;
    read.counts.push_back(rows.samples.count());
    for (std::size_t i = 0; i < rows.samples.count(); ++i) {
      const auto row = rows.samples[i].values;
      read.values.insert(read.values.end(), row.begin(), row.end());
    }
    read.labels.insert(read.labels.end(), rows.labels.begin(), rows.labels.end());
  }
}

// Opens and reads twice, in parts of so many bytes.
Result<Read> read_parts(const std::string& path, std::size_t bytes,
                        const CsvOptions& options = {}) {
  auto source = open_numbers(path, options, bytes);
  if (!source) return fail(source.error());
  auto once = read_all(**source);
  auto again = read_all(**source);
  EXPECT_EQ(once.has_value(), again.has_value());
  EXPECT_TRUE(!once || !again || once->values == again->values);
  return again;
}

// The same numbers, labels, names and failures as when all is read at once.
void expect_as_whole(const std::string& path, const CsvOptions& options = {}) {
  const auto whole = read_numbers(path, options);
  for (const std::size_t bytes : {1U, 50U, 1000000U}) {
    SCOPED_TRACE(bytes);
    const auto parts = read_parts(path, bytes, options);
    if (!whole) {
      ASSERT_FALSE(parts);
      EXPECT_EQ(to_string(parts.error()), to_string(whole.error()));
      EXPECT_EQ(parts.error().kind, whole.error().kind);
      continue;
    }
    ASSERT_TRUE(parts) << to_string(parts.error());
    const auto values = whole->values.values();
    EXPECT_EQ(parts->values, std::vector<float>(values.begin(), values.end()));
    EXPECT_EQ(parts->labels, whole->labels);
    const auto source = open_numbers(path, options, bytes);
    EXPECT_EQ((*source)->columns().feature_names(), whole->names);
    EXPECT_EQ((*source)->size(), whole->values.columns());
    EXPECT_EQ((*source)->columns().label.has_value(), !whole->labels.empty());
  }
}

Matrix<float> numbered(std::size_t rows, std::size_t columns) {
  Matrix<float> matrix(rows, columns);
  float next = 0.5F;
  for (float& value : matrix.values()) value = next++;
  return matrix;
}

TEST(NumberSource, PartsHoldAsManyRowsAsAreAllowed) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_npy(folder.file("a"), numbered(10, 3)));
  ASSERT_TRUE(write_csv(folder.file("b"), {{}, numbered(10, 3), {}}));
  for (const char* name : {"a", "b"}) {
    EXPECT_EQ(read_parts(folder.file(name), 50)->counts, (std::vector<std::size_t>{4, 4, 2}));
    EXPECT_EQ(read_parts(folder.file(name), 1)->counts, std::vector<std::size_t>(10, 1));
    EXPECT_EQ(read_parts(folder.file(name), 120)->counts, (std::vector<std::size_t>{10}));
  }
}

// Three columns of which the second is chosen away: numbers beside it may be anything.
TEST(NumberSource, ReadsTheChosenColumnsOfNpyInPartsAsAtOnce) {
  const TemporaryFolder folder;
  Matrix<float> matrix(3, 3, {1, 2, 3, 4, std::numeric_limits<float>::infinity(), 6, 7, 8, 9});
  std::string rows_first = encode_npy(matrix);
  std::string columns_first = encode_npy(
      Matrix<float>(3, 3, {1, 4, 7, 2, std::numeric_limits<float>::infinity(), 8, 3, 6, 9}));
  const std::size_t order = columns_first.find("False");
  columns_first.replace(order, 5, "True ");
  CsvOptions options;
  options.columns.skip = {"2"};
  for (const std::string& bytes : {rows_first, columns_first}) {
    const std::string path = folder.with("x", bytes);
    EXPECT_EQ(read_numbers(path, options)->values, Matrix<float>(3, 2, {1, 3, 4, 6, 7, 9}));
    expect_as_whole(path, options);
    EXPECT_FALSE(read_numbers(path));
  }
  options.columns.skip = {"2", "4"};
  expect_as_whole(folder.file("x"), options);
  options.columns.skip = {"a"};
  expect_as_whole(folder.file("x"), options);
}

TEST(NumberSource, KeepsMissingNumbersOfNpyButNoInfiniteOnes) {
  const TemporaryFolder folder;
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CsvOptions options;
  options.keeps_missing = true;
  const auto path = folder.with("x", encode_npy(Matrix<float>(2, 2, {1, nan, 3, 4})));
  const auto parts = read_parts(path, 1, {.columns = {{"1"}, {}, {}}, .keeps_missing = true});
  EXPECT_EQ(parts->values, (std::vector<float>{1, 3}));
  const NumberTable table = read_numbers(path, options).value();
  EXPECT_TRUE(std::isnan(table.values(0, 1)));
  EXPECT_EQ(table.values(1, 1), 4.0F);
  const Error refused = read_numbers(path).error();
  EXPECT_NE(to_string(refused).find("row 1, column 2"), std::string::npos) << to_string(refused);
  EXPECT_NE(refused.advice.find("keep missing values"), std::string::npos);
  folder.with("x", encode_npy(Matrix<float>(2, 2, {1, -1.0F / 0.0F, 3, 4})));
  EXPECT_FALSE(read_numbers(path, options));
  expect_as_whole(path, options);
}

// A boolean that is neither 0 nor 1 is damage, not a missing value.
TEST(NumberSource, TakesADamagedBooleanForNoMissingNumber) {
  const TemporaryFolder folder;
  std::string bytes = encode_npy(Matrix<float>(1, 1, 1.0F));
  bytes.replace(bytes.find("<f4"), 3, "|b1").resize(bytes.size() - 3);
  bytes.back() = 2;
  CsvOptions options;
  options.keeps_missing = true;
  EXPECT_FALSE(read_numbers(folder.with("x", bytes), options));
  bytes.back() = 1;
  EXPECT_EQ(read_numbers(folder.with("x", bytes), options)->values(0, 0), 1.0F);
}

TEST(NumberSource, ReadsChosenColumnsOfTextInPartsAsAtOnce) {
  const TemporaryFolder folder;
  CsvOptions options;
  options.columns.skip = {"note", "*c"};
  options.label_column = "kind";
  options.decimal = DecimalMark::kComma;
  expect_as_whole(folder.with("x", "note;a;kind;b;cc\nx;1,5;cup;2;?\ny;3;ball;4,25;z\n"), options);
  EXPECT_EQ(read_numbers(folder.file("x"), options)->values,
            Matrix<float>(2, 2, {1.5F, 2, 3, 4.25F}));
  options.columns.features = {"b", "a"};
  expect_as_whole(folder.file("x"), options);
  EXPECT_EQ(read_numbers(folder.file("x"), options)->values,
            Matrix<float>(2, 2, {2, 1.5F, 4.25F, 3}));
  options.columns.features = {"b", "d"};
  expect_as_whole(folder.file("x"), options);
}

TEST(NumberSource, OfBytesIsOnePartAgainAndAgain) {
  for (const std::string& bytes :
       {std::string("1,2\n3,4\n"), encode_npy(Matrix<float>(2, 2, {1, 2, 3, 4}))}) {
    auto source = numbers_in(bytes, "f", {.columns = {{"2"}, {}, {}}}).value();
    for (int i = 0; i < 2; ++i) {
      ASSERT_TRUE(source->rewind());
      const auto part = source->next_part().value();
      ASSERT_TRUE(part);
      EXPECT_EQ(part->samples.count(), 2U);
      EXPECT_EQ(part->samples[1].values[0], 4.0F);
      EXPECT_FALSE(source->next_part().value());
    }
    EXPECT_EQ(source->columns().left_out(), (std::vector<std::size_t>{0}));
  }
  EXPECT_EQ(to_string(numbers_in("1,x\n", "f", {.header = false}).error()).substr(0, 6), "f:1:3:");
}

// By hand: twelve numbers of four bytes, three times; the shortest rows that there can be.
TEST(NumberSource, KnowsHowMuchMemoryItsRowsTakeAtMost) {
  const TemporaryFolder folder;
  const std::string npy = folder.with("x.npy", encode_npy(numbered(4, 3)));
  const std::string csv = folder.with("x.csv", "1,2,3\n4,5,6\n7,8,9\n1,2,3\n");  // 24 bytes
  CsvOptions options;
  EXPECT_EQ(open_numbers(npy, options, 8).value()->memory_of_all(), 3 * 48);
  EXPECT_EQ(open_numbers(csv, options, 8).value()->memory_of_all(), 4 * 48);
  options.keeps_missing = true;
  EXPECT_EQ(open_numbers(csv, options, 8).value()->memory_of_all(), 4 * 96);
  options.keeps_missing = false;
  options.columns.skip = {"2"};
  EXPECT_EQ(open_numbers(npy, options, 8).value()->memory_of_all(), 3 * 32);
  EXPECT_DOUBLE_EQ(open_numbers(csv, options, 8).value()->memory_of_all(), 4 * 24 / 5.0 * 2 * 4);
}

// Every seed input of the fuzzers, wrong ones too, and each cut off anywhere.
TEST(NumberSource, ReadsAndRefusesWhatReadingAllAtOnceDoes) {
  const TemporaryFolder folder;
  for (const char* kind : {"npy", "csv"}) {
    const std::string corpus = source_path("fuzz/corpus/" + std::string(kind));
    for (const auto& entry : std::filesystem::directory_iterator(corpus)) {
      const std::string bytes = bytes_of(entry.path().string());
      for (std::size_t length = 0; length <= bytes.size(); length += 1 + length / 40) {
        SCOPED_TRACE(entry.path().string() + " " + std::to_string(length));
        const std::string path = folder.with("x", bytes.substr(0, length));
        expect_as_whole(path);
        CsvOptions labelled;
        labelled.label_column = "kind";
        expect_as_whole(path, labelled);
      }
    }
  }
}

std::string field_of(Random& random) {
  const std::string numbers[] = {"1", "-2.5", "3e2", "\"4\"", "0.1234567890123456", " 7 "};
  return numbers[random.below(6)];
}

// Larger than the window through which text is read, with everything that could be cut by its edge.
TEST(NumberSource, ReadsTextWhereverItsWindowEnds) {
  const TemporaryFolder folder;
  Random random(3);
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text =
        "\xEF\xBB\xBF"
        "a,\"b\nb\",kind\r\n";
    while (text.size() < 1200000) {
      if (random.below(20) == 0) text += "# a r\xC3\xB6w\xE2\x82\xAC" + std::string(end);
      if (random.below(20) == 0) text += end;
      text +=
          field_of(random) + "," + field_of(random) + ",\"gr\xC3\xBCn\ntwo \"\"lines\"\"\"" + end;
    }
    const std::string path = folder.with("x", text);
    CsvOptions options;
    options.label_column = "kind";
    const auto whole = read_numbers(path, options);
    ASSERT_TRUE(whole) << to_string(whole.error());
    const auto parts = read_parts(path, 1000, options);
    ASSERT_TRUE(parts) << to_string(parts.error());
    const auto values = whole->values.values();
    EXPECT_TRUE(parts->values == std::vector<float>(values.begin(), values.end()));
    EXPECT_TRUE(parts->labels == whole->labels);
    // An error at the end is reported with its line and column.
    for (const char* wrong : {"1,nan,x", "1,2", "1,2,\"x", "1,\xFF,3", "1,2,"}) {
      folder.with("x", text + wrong);
      const auto expected = read_numbers(path, options);
      const auto refused = read_parts(path, 1000, options);
      ASSERT_FALSE(refused);
      EXPECT_EQ(to_string(refused.error()), to_string(expected.error()));
    }
  }
}

TEST(NumberSource, ARowMayBeLongerThanTheWindowButNotWithoutEnd) {
  const TemporaryFolder folder;
  std::string row = "1";
  for (int i = 0; i < 300000; ++i) row += ",1";
  const std::string path = folder.with("x", row + "\n" + row);
  EXPECT_EQ(read_parts(path, 1)->counts, (std::vector<std::size_t>{1, 1}));
  std::ofstream(path) << std::string(std::size_t{70} << 20, '7');
  const auto refused = open_numbers(path, {}, 1);
  ASSERT_FALSE(refused);
  EXPECT_NE(to_string(refused.error()).find("x:1: a row is longer"), std::string::npos)
      << to_string(refused.error());
}

TEST(NumberSource, ReadsFortranOrderAndOtherNumbersInParts) {
  const TemporaryFolder folder;
  // 5 rows of 2 columns, column by column, big-endian 16-bit integers.
  std::string bytes = npy_start(5, 2);
  const auto replace = [&](const std::string& from, const std::string& to) {
    bytes.replace(bytes.find(from), from.size(), to);
  };
  replace("<f4", ">i2");
  replace("False", "True ");
  for (const char value : {'\1', '\2', '\3', '\4', '\5', '\v', '\f', '\r', '\16', '\17'}) {
    bytes += std::string(1, '\0') + value;
  }
  const std::string path = folder.with("x", bytes);
  expect_as_whole(path);
  EXPECT_EQ(read_parts(path, 16)->values, (std::vector<float>{1, 11, 2, 12, 3, 13, 4, 14, 5, 15}));
}

TEST(NumberSource, AFaultInTheLastPartHasItsPlace) {
  const TemporaryFolder folder;
  Matrix<float> matrix = numbered(1000, 3);
  matrix(999, 1) = std::numeric_limits<float>::infinity();
  ASSERT_TRUE(save_whole(folder.file("x"), encode_npy(matrix)));
  const auto refused = read_parts(folder.file("x"), 100);
  EXPECT_NE(to_string(refused.error()).find("row 1000, column 2"), std::string::npos);
}

// Cut, grown or written over between two passes or within one.
TEST(NumberSource, AFileThatChangesIsRefused) {
  const TemporaryFolder folder;
  const std::string npy = encode_npy(numbered(1000, 30));
  const std::string csv = format_csv({{}, numbered(100000, 3), {}});
  for (const std::string& bytes : {npy, csv}) {
    std::string other = bytes;
    other.back() = static_cast<char>(other.back() ^ 1);
    for (const std::string& now : {bytes.substr(0, bytes.size() / 2), bytes + bytes, other}) {
      for (const bool within : {false, true}) {
        const std::string path = folder.with("x", bytes);
        std::filesystem::last_write_time(
            path, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
        auto source = open_numbers(path, {}, 5000);
        ASSERT_TRUE(source);
        ASSERT_TRUE((*source)->rewind());
        ASSERT_TRUE(!within || (*source)->next_part());
        folder.with("x", now);
        Error error;
        if (within) {
          for (;;) {
            const auto part = (*source)->next_part();
            ASSERT_TRUE(!part || *part) << "it came to an end";
            if (part) continue;
            error = part.error();
            break;
          }
        } else {
          const auto again = read_all(**source);
          ASSERT_FALSE(again);
          error = again.error();
        }
        EXPECT_EQ(error.kind, ErrorKind::kData);
        EXPECT_NE(to_string(error).find("x: the file changed"), std::string::npos)
            << to_string(error);
      }
    }
  }
}

TEST(NumberSource, ReplacingTheFileLeavesItAsItIs) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_npy(folder.file("x"), numbered(4, 2)));
  auto source = open_numbers(folder.file("x"), {}, 8).value();
  const std::vector<float> before = read_all(*source)->values;
  ASSERT_TRUE(write_npy(folder.file("x"), numbered(9, 9)));  // a new file of that name
  EXPECT_EQ(read_all(*source)->values, before);
}

TEST(NumberSource, ReportsAllErrorsOfTheSystem) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_npy(folder.file("npy"), numbered(9, 3)));
  ASSERT_TRUE(write_csv(folder.file("csv"), {{}, numbered(9, 3), {}}));
  for (const char* name : {"npy", "csv"}) {
    for (int failing = 0;; ++failing) {
      testing::FailingFileSystem files(failing);
      bool refused = false;
      {
        auto source = detail::open_numbers(files, folder.file(name), {}, 30);
        const auto read = source ? read_all(**source) : fail(source.error());
        refused = !read;
        EXPECT_TRUE(read || read.error().kind == ErrorKind::kSystem) << failing;
      }
      EXPECT_EQ(files.opened(), 0);
      if (!files.failed()) break;
      // Only closing may fail without a word: nothing was written.
      EXPECT_TRUE(refused || failing + 1 == files.count());
    }
    testing::FailingFileSystem slowly(-1, EIO, 3);  // three bytes at a time
    auto source = detail::open_numbers(slowly, folder.file(name), {}, 30).value();
    EXPECT_EQ(read_all(*source)->values.size(), 27u);
  }
}

TEST(NumberSource, RefusesWhatIsNoFileOrHasNoLabelColumn) {
  const TemporaryFolder folder;
  EXPECT_EQ(open_numbers(folder.path(), {}, 8).error().kind, ErrorKind::kSystem);
  EXPECT_EQ(open_numbers(folder.file("missing"), {}, 8).error().kind, ErrorKind::kSystem);
  EXPECT_EQ(open_numbers("/dev/null", {}, 8).error().kind, ErrorKind::kSystem);
}

// Text with names and fields that contain line ends, so that bytes say nothing about rows.
TEST(NumberSource, TakesPartsOfEveryFormatThatTogetherAreTheWhole) {
  const TemporaryFolder folder;
  const Matrix<float> numbers = numbered(23, 3);
  ASSERT_TRUE(write_npy(folder.file("rows.npy"), numbers));
  ASSERT_TRUE(write_csv(folder.file("rows.csv"), {{}, numbers, {}}));
  std::string text = "\xEF\xBB\xBF\"a\nb\",c,name\r\n";
  for (std::size_t i = 0; i < 23; ++i) {
    text += std::to_string(i) + ",0.25,\"" + std::string(i, '\n') + "\"\n\n";
  }
  folder.with("names.csv", text + "# the end\n");
  CsvOptions names;
  names.columns.skip = {"name"};
  const std::vector<std::pair<std::string, CsvOptions>> files{
      {"rows.npy", {}}, {"rows.csv", {}}, {"names.csv", names}};
  for (const auto& [name, options] : files) {
    const std::vector<float> whole = read_parts(folder.file(name), 40, options)->values;
    for (const std::size_t of : {1U, 2U, 3U, 7U, 40U}) {
      std::vector<float> together;
      for (std::size_t part = 0; part < of; ++part) {
        const auto source = open_numbers(folder.file(name), options, 40);
        take_part(**source, part, of);
        ASSERT_TRUE(read_all(**source));
        const auto again = read_all(**source);
        ASSERT_TRUE(again) << to_string(again.error());
        together.insert(together.end(), again->values.begin(), again->values.end());
        EXPECT_EQ((*source)->share_read(), 1.0);
      }
      EXPECT_EQ(together, whole) << name << " in " << of;
    }
  }
}

TEST(NumberSource, ReportsTheLineOfAnErrorInAPart) {
  const TemporaryFolder folder;
  const auto source = open_numbers(folder.with("x", "1,2\n3,4\n\"5\",6\n7,x\n"), {}, 1);
  take_part(**source, 1, 2);
  EXPECT_EQ(read_all(**source).error().where, folder.file("x") + ":4:3");
  EXPECT_EQ(read_all(**source).error().where, folder.file("x") + ":4:3");
}

TEST(NumberSource, JoinsFilesOfTheSameColumns) {
  const TemporaryFolder folder;
  const std::string text = folder.with("a.csv", "p,q,r\n1,2,3\n4,5,6\n");
  const std::string more = folder.with("b.csv", "p,q,r\n7,8,9\n");
  ASSERT_TRUE(write_npy(folder.file("c.npy"), Matrix<float>(2, 3, 0.5F)));
  const std::vector<std::string> paths{text, more, text};
  const std::vector<float> whole{1, 2, 3, 4, 5, 6, 7, 8, 9, 1, 2, 3, 4, 5, 6};
  for (const std::size_t of : {1U, 2U, 5U}) {
    std::vector<float> together;
    for (std::size_t part = 0; part < of; ++part) {
      const auto source = open_numbers(paths, {}, 12);
      take_part(**source, part, of);
      ASSERT_TRUE(read_all(**source));
      const std::vector<float> own = read_all(**source)->values;
      together.insert(together.end(), own.begin(), own.end());
    }
    EXPECT_EQ(together, whole) << of;
  }
  const Error other = open_numbers({text, folder.file("c.npy")}, {}, 12).error();
  EXPECT_EQ(other.where, folder.file("c.npy"));
  EXPECT_EQ(other.kind, ErrorKind::kData);
}

// All of a file in memory is one part; with labels.
TEST(NumberSource, TakesPartsOfNumbersInMemory) {
  const std::string text = "1,a\n2,b\n3,a\n4,b\n5,c\n";
  CsvOptions options;
  options.label_column = "2";
  std::vector<float> values;
  std::vector<std::string> labels;
  for (std::size_t part = 0; part < 3; ++part) {
    const auto source = numbers_in(text, "text", options);
    take_part(**source, part, 3);
    const auto own = read_all(**source);
    values.insert(values.end(), own->values.begin(), own->values.end());
    labels.insert(labels.end(), own->labels.begin(), own->labels.end());
  }
  EXPECT_EQ(values, (std::vector<float>{1, 2, 3, 4, 5}));
  EXPECT_EQ(labels, (std::vector<std::string>{"a", "b", "a", "b", "c"}));
}

}  // namespace
}  // namespace somato
