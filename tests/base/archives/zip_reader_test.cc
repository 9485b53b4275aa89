#include "base/archives/zip_reader.h"

#include <gtest/gtest.h>

#include "base/archives/made_zip.h"
#include "somato/core/random.h"

namespace somato {
namespace {

std::string zip_refusal(const std::string& bytes) {
  const auto reader = ZipReader::open(bytes, "a.npz");
  if (!reader) return to_string(reader.error());
  for (const ZipReader::Member& member : reader->members()) {
    const auto read = reader->read(member);
    if (!read) return to_string(read.error());
  }
  return "read";
}

TEST(ZipReader, MembersAreStoredOrDeflated) {
  const std::string text(3000, 'x');
  for (const bool is_deflated : {false, true}) {
    SCOPED_TRACE(is_deflated);
    const std::string bytes = made_zip({{"a", text}, {"b", ""}, {"c", "last"}}, is_deflated);
    const auto reader = ZipReader::open(bytes, "a.npz").value();
    ASSERT_EQ(reader.members().size(), 3U);
    EXPECT_EQ(reader.members()[2].name, "c");
    EXPECT_EQ(reader.read(reader.members()[0]).value(), text);
    EXPECT_EQ(reader.read(reader.members()[1]).value(), "");
    EXPECT_EQ(reader.read(reader.members()[2]).value(), "last");
  }
}

TEST(ZipReader, DamageIsNamed) {
  const std::string bytes = made_zip({{"a", "some text"}}, false);
  EXPECT_TRUE(is_zip(bytes));
  EXPECT_NE(zip_refusal(bytes.substr(0, bytes.size() - 1)).find("no list of its members"),
            std::string::npos);
  std::string changed = bytes;
  changed[31] = 'S';
  EXPECT_EQ(zip_refusal(changed),
            "a.npz: the member 'a' does not match its checksum; copy or save it again");
  changed = bytes;
  changed[bytes.find("PK\1\2") + 10] = 12;
  EXPECT_NE(zip_refusal(changed).find("the method 12"), std::string::npos);
  changed = bytes;
  changed[bytes.find("PK\1\2") + 8] = 1;
  EXPECT_NE(zip_refusal(changed).find("encrypted"), std::string::npos);
}

TEST(ZipReader, ADamagedNumberOfMembersHidesNone) {
  const std::string bytes = made_zip({{"a", "1"}, {"b", "2"}, {"c", "3"}}, false);
  for (const char count : {'\0', '\1', '\2'}) {
    std::string changed = bytes;
    changed[bytes.find("PK\5\6") + 10] = count;
    EXPECT_NE(zip_refusal(changed).find("does not have its size"), std::string::npos);
  }
}

TEST(ZipReader, AnyBytesAreReadOrRefused) {
  Random random(3);
  const std::string bytes = made_zip({{"a", std::string(200, 'x')}, {"b", "1234567"}}, true);
  for (int i = 0; i < 3000; ++i) {
    std::string changed = bytes;
    for (int k = 0; k < 3; ++k) {
      changed[random.below(changed.size())] = static_cast<char>(random.below(256));
    }
    if (i % 3 == 0) changed.resize(random.below(changed.size()));
    (void)zip_refusal(changed);
  }
}

}  // namespace
}  // namespace somato
