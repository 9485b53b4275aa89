#include "views/exports/npz_export.h"

#include <gtest/gtest.h>

#include <map>

#include "base/archives/checksum.h"
#include "base/archives/little_endian.h"
#include "base/support/temporary_folder.h"
#include "recordings/explorations/exploration_frames.h"
#include "somato/files/npy.h"
#include "views/exports/varied_recording.h"

namespace somato {
namespace {

constexpr std::size_t kHead = 30;  // Bytes of the head of a member of a ZIP archive.

// The members of an archive by their heads, without its directory.
std::map<std::string, std::string> members_of(const std::string& zip) {
  std::map<std::string, std::string> members;
  for (std::size_t place = 0; zip.substr(place, 4) == "PK\3\4";) {
    const char* head = zip.data() + place;
    const auto size = little_endian<std::uint32_t>(head + 18);
    const auto name = little_endian<std::uint16_t>(head + 26);
    const std::string bytes = zip.substr(place + kHead + name, size);
    EXPECT_EQ(little_endian<std::uint32_t>(head + 14), crc32(bytes));
    EXPECT_TRUE(members.emplace(zip.substr(place + kHead, name), bytes).second);
    place += kHead + name + size;
  }
  return members;
}

std::map<std::string, std::string> written(const std::string& path, const Recording& recording) {
  auto to = NpzExport::begin(path).value();
  for (const Exploration& exploration : recording.explorations)
    EXPECT_TRUE(hand_frames(exploration, *to));
  EXPECT_TRUE(to->finish());
  return members_of(bytes_of(path));
}

TEST(NpzExport, HasTheFramesAndTimesOfEachExploration) {
  const TemporaryFolder folder;
  const Recording recording = varied_recording();
  const auto members = written(folder.file("out.npz"), recording);
  EXPECT_EQ(members.size(), 2U * 3U * 2U + 2U + 2U * 3U + 2U);
  for (std::size_t e = 0; e < recording.explorations.size(); ++e) {
    const Channel& joints = recording.explorations[e].channels[0];
    const std::string place = "/joints/" + std::to_string(e) + ".npy";
    EXPECT_EQ(decode_npy(members.at("frames" + place), "").value(), joints.frames);
    const Matrix<float> times = decode_npy(members.at("times" + place), "").value();
    ASSERT_EQ(times.rows(), joints.frames.rows());
    EXPECT_EQ(times(2, 0), 0.04F);
  }
  EXPECT_NE(members.at("frames/skin/left/0.npy").find("'shape': (3, 2, 3)"), std::string::npos);
}

TEST(NpzExport, TextsAreCodePoints) {
  const TemporaryFolder folder;
  const auto members = written(folder.file("out.npz"), varied_recording());
  const std::string& label = members.at("labels/trial number.npy");
  EXPECT_NE(label.find("'descr': '<U3', 'fortran_order': False, 'shape': (2,)"), std::string::npos);
  EXPECT_EQ(label.substr(label.size() - 24),
            std::string("1\0\0\0\0\0\0\0\0\0\0\0T\0\0\0\xFC\0\0\0r\0\0\0", 24));
}

TEST(NpzExport, AFileIsReplacedAsAWhole) {
  const TemporaryFolder folder;
  folder.with("out.npz", "before");
  {
    auto to = NpzExport::begin(folder.file("out.npz")).value();
    ASSERT_TRUE(hand_frames(varied_recording().explorations.front(), *to));
  }
  EXPECT_EQ(bytes_of(folder.file("out.npz")), "before");
  EXPECT_EQ(folder.count(), 1);
}

}  // namespace
}  // namespace somato
