#include "recordings/imports/wav_trials.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/support/temporary_folder.h"

namespace somato {
namespace {

// A sound of two samples at 8 Hz.
std::string wav(char channels) {
  std::string bytes("RIFF\0\0\0\0WAVEfmt \x10\0\0\0\1\0", 22);
  bytes += channels;
  bytes += std::string("\0\x08\0\0\0\0\0\0\0\2\0\x10\0data", 17);
  bytes += static_cast<char>(4 * channels);
  bytes += std::string("\0\0\0", 3);
  for (int i = 0; i < 2 * channels; ++i) bytes += std::string("\0\x40", 2);
  return bytes;
}

class WavTrialsTest : public ::testing::Test {
 protected:
  WavTrialsTest() {
    (void)folder_.with("cork_1.wav", wav(1));
    (void)folder_.with("foam_2.wav", wav(1));
  }

  Result<Recording> read() const {
    return import_wav_trials(folder_.file(""), "{material}_{trial:number}.wav", false);
  }

  TemporaryFolder folder_;
};

TEST_F(WavTrialsTest, AFileIsAnExplorationWithItsLabels) {
  const Recording recording = read().value();
  ASSERT_EQ(recording.explorations.size(), 2U);
  EXPECT_EQ(recording.explorations[1].labels,
            (std::vector<Label>{{"material", "foam"}, {"trial", "2"}}));
  const Channel& sound = recording.explorations[1].channels[0];
  EXPECT_EQ(sound.name, "sound");
  EXPECT_EQ(sound.rate, 8.0);
  EXPECT_EQ(sound.frames, Matrix<float>(2, 1, 0.5F));
  EXPECT_TRUE(validate(recording));
}

TEST_F(WavTrialsTest, FilesAreAlikeAndWhole) {
  const std::string stereo = folder_.with("wood_3.wav", wav(2));
  auto refused = read();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().where, stereo);
  std::filesystem::remove(stereo);
  (void)folder_.with("a_1.wav", "RIFF");
  refused = read();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().what, "it is not a WAV file");
}

}  // namespace
}  // namespace somato
