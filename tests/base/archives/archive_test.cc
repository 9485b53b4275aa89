#include "base/archives/archive.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "base/archives/checksum.h"
#include "base/support/no_malloc.h"
#include "base/support/temporary_folder.h"
#include "somato/core/check.h"
#include "somato/core/random.h"

namespace somato {
namespace {

Archive small_archive() {
  Archive archive("som");
  archive.add("settings", std::string("rows = 2\n"));
  archive.add("weights", Array<float>{{2, 3}, {1.0f, -0.0f, 0.5f, 3.25f, 1e-40f, -7.0f}});
  archive.add("counts", Array<std::int64_t>{{2}, {-1, std::numeric_limits<std::int64_t>::max()}});
  return archive;
}

// Bytes put together as docs/formats/model-file.md says, so that any field can be wrong.
class Bytes {
 public:
  Bytes& raw(std::string_view bytes) {
    bytes_ += bytes;
    return *this;
  }
  Bytes& number(std::uint64_t value, int size) {
    for (int i = 0; i < size; ++i) bytes_ += static_cast<char>(value >> (8 * i) & 0xFF);
    return *this;
  }
  Bytes& padded(std::string_view bytes, char padding = '\0') {
    bytes_ += bytes;
    while (bytes_.size() % 8 != 0) bytes_ += padding;
    return *this;
  }
  Bytes& entry(std::uint64_t type, std::string_view name, std::vector<std::uint64_t> shape,
               std::string_view content) {
    number(type, 2).number(shape.size(), 2).number(name.size(), 4).padded(name);
    for (const std::uint64_t size : shape) number(size, 8);
    return padded(content);
  }
  const std::string& get() const { return bytes_; }

 private:
  std::string bytes_;
};

const std::string kMagic("\x8FSOMATO\r\n\x1A\n\0", 12);

std::string file(const std::string& magic, std::uint64_t version, std::uint64_t entries,
                 const std::string& kind, const std::string& body) {
  const std::string content = Bytes().padded(kind).raw(body).get();
  Bytes head;
  head.raw(magic).number(version, 4).number(32 + content.size() + 4, 8).number(entries, 4);
  const std::string all = head.number(kind.size(), 4).raw(content).get();
  return Bytes().raw(all).number(crc32c(all), 4).get();
}

// A file of kind "som" with everything right around `body`.
std::string file_with(std::uint64_t entries, const Bytes& body) {
  return file(kMagic, 1, entries, "som", body.get());
}

std::string one_value() {
  return Bytes().number(0x3F800000, 4).get();
}

void expect_refused(const std::string& bytes, const std::string& because) {
  const Result<Archive> archive = decode_archive(bytes, "model");
  ASSERT_FALSE(archive) << because;
  EXPECT_EQ(archive.error().kind, ErrorKind::kData);
  EXPECT_NE(archive.error().what.find(because), std::string::npos) << to_string(archive.error());
  EXPECT_TRUE(archive.error().where.starts_with("model")) << archive.error().where;
  EXPECT_FALSE(archive.error().advice.empty());
}

TEST(Archive, HasTheDocumentedBytes) {
  Archive archive("som");
  archive.add("a", std::string("text"));
  archive.add("weight", Array<float>{{1, 1}, {1.0f}});
  Bytes body;
  body.entry(1, "a", {4}, "text").entry(2, "weight", {1, 1}, one_value());
  EXPECT_EQ(encode_archive(archive), file_with(2, body));
}

TEST(Archive, FindsEntriesByNameAndType) {
  const Archive archive = small_archive();
  EXPECT_EQ(**archive.get<std::string>("settings", "f"), "rows = 2\n");
  EXPECT_EQ((*archive.get<Array<float>>("weights", "f"))->values[3], 3.25f);
  EXPECT_EQ(archive.find("weight"), nullptr);
  const auto missing = archive.get<std::string>("weight", "f");
  EXPECT_EQ(to_string(missing.error()),
            "f: the entry 'weight' is missing; check that it is the right file; one that another "
            "version of Somato wrote in format 1 has to be trained again");
  const auto other = archive.get<Array<double>>("weights", "f");
  EXPECT_NE(other.error().what.find("another type"), std::string::npos);
}

TEST(Archive, RefusesToHoldWhatCannotBeRead) {
  EXPECT_THROW(Archive(""), InvalidArgument);
  Archive archive = small_archive();
  EXPECT_THROW(archive.add("weights", std::string()), InvalidArgument);
  EXPECT_THROW(archive.add("", std::string()), InvalidArgument);
  EXPECT_THROW(archive.add("a", std::string("\xFF")), InvalidArgument);
  EXPECT_THROW(archive.add("a", Array<float>{{2}, {1.0f}}), InvalidArgument);
  EXPECT_THROW(archive.add("a", Array<float>{{}, {1.0f}}), InvalidArgument);
  EXPECT_THROW(archive.add("a", Array<float>{{0}, {}}), InvalidArgument);
  EXPECT_THROW(archive.add("a", Array<float>{std::vector<std::uint64_t>(9, 1), {1.0f}}),
               InvalidArgument);
  EXPECT_EQ(archive, small_archive());
  for (std::size_t i = 3; i < 1000; ++i) archive.add(std::to_string(i), std::string());
  EXPECT_THROW(archive.add("one more", std::string()), InvalidArgument);
  EXPECT_EQ(decode_archive(encode_archive(archive), "f").value(), archive);
}

TEST(Archive, RefusesEveryTruncation) {
  const std::string bytes = encode_archive(small_archive());
  ASSERT_TRUE(decode_archive(bytes, "f"));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(decode_archive(bytes.substr(0, size), "f")) << size;
  }
}

TEST(Archive, RefusesEveryFlippedBit) {
  std::string bytes = encode_archive(small_archive());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
    EXPECT_FALSE(decode_archive(bytes, "f")) << bit;
    bytes[bit / 8] = static_cast<char>(bytes[bit / 8] ^ (1 << bit % 8));
  }
  EXPECT_TRUE(decode_archive(bytes, "f"));
}

TEST(HostileArchive, WrongMagic) {
  std::string magic = kMagic;
  magic[7] = '\n';  // As a copy that changes the ends of lines would.
  expect_refused(file(magic, 1, 0, "som", ""), "not a model file");
  expect_refused("", "not a model file");
}

TEST(HostileArchive, NewerVersion) {
  expect_refused(file(kMagic, 2, 0, "som", ""), "written by a newer version of Somato");
}

TEST(HostileArchive, VersionZero) {
  expect_refused(file(kMagic, 0, 0, "som", ""), "format 0 does not exist");
}

TEST(HostileArchive, WrongChecksum) {
  std::string bytes = file_with(0, {});
  bytes.back() = static_cast<char>(bytes.back() ^ 1);
  expect_refused(bytes, "checksum");
}

TEST(HostileArchive, BytesAfterTheEnd) {
  expect_refused(file_with(0, {}) + std::string(8, '\0'), "instead of");
}

TEST(HostileArchive, BytesAfterTheLastEntry) {
  expect_refused(file_with(0, Bytes().number(0, 8)), "after the last entry");
}

TEST(HostileArchive, EntryCountTooLarge) {
  expect_refused(file_with(0xFFFFFFFF, {}), "too many");
  Bytes many;
  for (int i = 0; i < 1001; ++i) many.entry(1, std::to_string(i), {0}, "");
  expect_refused(file_with(1001, many), "too many");
  expect_refused(file_with(2, Bytes().entry(1, "a", {1}, "x")), "beyond the end");
}

TEST(HostileArchive, KindEmptyOrEndless) {
  expect_refused(file(kMagic, 1, 0, "", ""), "name");
  std::string bytes = file_with(0, {});
  bytes.resize(bytes.size() - 4);
  bytes.replace(28, 4, "\xFF\xFF\xFF\xFF");
  expect_refused(Bytes().raw(bytes).number(crc32c(bytes), 4).get(), "beyond the end");
}

TEST(HostileArchive, NameEmpty) {
  expect_refused(file_with(1, Bytes().entry(1, "", {1}, "x")), "name");
}

TEST(HostileArchive, NameNotUtf8) {
  expect_refused(file_with(1, Bytes().entry(1, "\xC3\x28", {1}, "x")), "name");
}

TEST(HostileArchive, NameWithALineBreak) {
  expect_refused(file_with(1, Bytes().entry(1, "a\nb", {1}, "x")), "name");
}

TEST(HostileArchive, TextNotUtf8) {
  expect_refused(file_with(1, Bytes().entry(1, "a", {1}, "\xFF")), "UTF-8");
}

TEST(HostileArchive, TextOfTwoDimensions) {
  expect_refused(file_with(1, Bytes().entry(1, "a", {1, 1}, "x")), "one dimension");
}

TEST(HostileArchive, DuplicateEntry) {
  expect_refused(file_with(2, Bytes().entry(1, "a", {1}, "x").entry(1, "a", {1}, "y")), "twice");
}

TEST(HostileArchive, UnknownType) {
  expect_refused(file_with(1, Bytes().entry(5, "a", {1}, one_value())), "type 5 is unknown");
  expect_refused(file_with(1, Bytes().entry(0, "a", {1}, one_value())), "type 0 is unknown");
}

TEST(HostileArchive, NoDimensionsOrTooMany) {
  expect_refused(file_with(1, Bytes().entry(2, "a", {}, one_value())), "dimensions");
  const std::vector<std::uint64_t> nine(9, 1);
  expect_refused(file_with(1, Bytes().entry(2, "a", nine, one_value())), "dimensions");
}

TEST(HostileArchive, DimensionOfZero) {
  expect_refused(file_with(1, Bytes().entry(2, "a", {0}, "")), "no values");
  expect_refused(file_with(1, Bytes().entry(2, "a", {~0ull, ~0ull, 0}, "")), "no values");
}

TEST(HostileArchive, ProductOfDimensionsOverflows) {
  // 2^32 * 2^32 is 0 modulo 2^64, and (2^64 - 1) * (2^64 - 1) is 1.
  expect_refused(file_with(1, Bytes().entry(2, "a", {1ull << 32, 1ull << 32}, one_value())),
                 "more than the file");
  expect_refused(file_with(1, Bytes().entry(2, "a", {~0ull, ~0ull}, one_value())),
                 "more than the file");
}

TEST(HostileArchive, SizeInBytesOverflows) {
  // 2^62 + 1 float32 values are 4 bytes more than 2^64.
  expect_refused(file_with(1, Bytes().entry(2, "a", {(1ull << 62) + 1}, one_value())),
                 "more than the file");
}

TEST(HostileArchive, AbsurdSize) {
  expect_refused(file_with(1, Bytes().entry(3, "a", {1ull << 40}, one_value())),
                 "more than the file");
  expect_refused(file_with(1, Bytes().entry(1, "a", {~0ull}, "x")), "beyond the end");
}

TEST(HostileArchive, ArrayPastTheEnd) {
  expect_refused(file_with(1, Bytes().entry(2, "a", {3}, one_value())), "more than the file");
}

TEST(HostileArchive, PaddingNotZero) {
  Bytes body;
  body.number(2, 2).number(1, 2).number(1, 4).padded("a").number(1, 8).padded(one_value(), 'x');
  expect_refused(file_with(1, body), "padding");
  expect_refused(
      file_with(1, Bytes().number(2, 2).number(1, 2).number(1, 4).padded("a", 'x').number(1, 8)),
      "padding");
}

std::string random_text(Random& random, std::size_t least) {
  const char* const pieces[] = {"a", "Z", "0", " ", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\xA4\x96"};
  std::string text;
  for (std::size_t i = random.below(20) + least; i > 0; --i) text += pieces[random.below(7)];
  return text;
}

template <typename T>
Array<T> random_array(Random& random) {
  Array<T> array;
  std::size_t count = 1;
  for (std::size_t i = 1 + random.below(3); i > 0; --i) {
    array.shape.push_back(1 + random.below(4));
    count *= array.shape.back();
  }
  for (; count > 0; --count) {
    array.values.push_back(static_cast<T>(1000.0 * random.normal()));
  }
  return array;
}

Archive::Content random_content(Random& random) {
  switch (random.below(4)) {
    case 0:
      return random_text(random, 0);
    case 1:
      return random_array<float>(random);
    case 2:
      return random_array<double>(random);
    default:
      return random_array<std::int64_t>(random);
  }
}

TEST(Archive, ReadsBackWhatItWrote) {
  Random random(1);
  for (int i = 0; i < 500; ++i) {
    Archive archive(random_text(random, 1));
    for (std::size_t k = random.below(6); k > 0; --k) {
      archive.add(random_text(random, 1) + std::to_string(k), random_content(random));
    }
    const std::string bytes = encode_archive(archive);
    const Result<Archive> decoded = decode_archive(bytes, "f");
    ASSERT_TRUE(decoded) << to_string(decoded.error());
    EXPECT_EQ(*decoded, archive);
    EXPECT_EQ(encode_archive(*decoded), bytes);
  }
}

TEST(Archive, KeepsTheBitsOfNumbers) {
  Archive archive("bits");
  archive.add("a",
              Array<float>{{3},
                           {std::bit_cast<float>(0x7FC12345u), std::bit_cast<float>(0x80000000u),
                            std::numeric_limits<float>::infinity()}});
  const Archive decoded = decode_archive(encode_archive(archive), "f").value();
  const Array<float>& a = **decoded.get<Array<float>>("a", "f");
  EXPECT_EQ(std::bit_cast<std::uint32_t>(a.values[0]), 0x7FC12345u);
  EXPECT_EQ(std::bit_cast<std::uint32_t>(a.values[1]), 0x80000000u);
}

TEST(Archive, TakesLittleMoreMemoryThanTheFileTwice) {
  if (!testing::counts_allocations()) GTEST_SKIP() << "sanitizers bring their own operator new";
  const TemporaryFolder folder;
  std::vector<std::string> files;
  Archive large("som");
  large.add("weights", Array<float>{{1000, 2000}, std::vector<float>(2000000, 1.0f)});
  files.push_back(encode_archive(large));
  Archive many("som");
  for (int i = 0; i < 1000; ++i) {
    many.add(std::to_string(i), Array<double>{{1, 1, 1, 1, 1, 1, 1, 1}, {1.0}});
  }
  files.push_back(encode_archive(many));
  files.push_back(file_with(1, Bytes().entry(2, "a", {1ull << 40}, one_value())));
  files.push_back(file_with(1000, Bytes().entry(1, "a", {1ull << 40}, "x")));
  for (const std::string& bytes : files) {
    const std::string path = folder.with("file", bytes);
    const testing::AllocationCounter counter;
    const Result<Archive> archive = load_archive(path);
    EXPECT_LE(counter.most_bytes(), 2 * bytes.size() + (1u << 20));
    EXPECT_GE(counter.most_bytes(), bytes.size()) << "nothing was counted";
  }
}

TEST(Archive, IsSavedAndLoaded) {
  const TemporaryFolder folder;
  ASSERT_TRUE(save_archive(folder.file("model"), small_archive()));
  EXPECT_EQ(load_archive(folder.file("model")).value(), small_archive());
  EXPECT_EQ(folder.count(), 1);
  const Result<Archive> missing = load_archive(folder.file("missing"));
  EXPECT_EQ(missing.error().kind, ErrorKind::kSystem);
  const Result<Archive> text = load_archive(folder.with("text", "rows = 2\n"));
  EXPECT_EQ(to_string(text.error()),
            folder.file("text") + ": this is not a model file of Somato; check the path");
}

}  // namespace
}  // namespace somato
