#include "bodies/hands/hand_picture.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/files/whole_file.h"
#include "base/support/temporary_folder.h"
#include "bodies/support/things.h"

namespace somato {
namespace {

std::unique_ptr<SimulatedHand> hand_before(const Object& object) {
  const auto scene = HandScene::build(Hand::kLucs2, object);
  EXPECT_TRUE(scene);
  return std::move(SimulatedHand::create(*scene, {}, 1).value());
}

std::string picture_of(const SimulatedHand& hand) {
  const TemporaryFolder folder;
  const auto saved = save_hand_picture(hand, folder.file("hand.png"));
  EXPECT_TRUE(saved) << saved.error().what;
  return read_whole(folder.file("hand.png")).value();
}

// A PNG file contains its width and height, big-endian, from byte 16.
unsigned number_at(const std::string& png, std::size_t at) {
  unsigned number = 0;
  for (std::size_t i = at; i < at + 4; ++i)
    number = number * 256 + static_cast<unsigned char>(png[i]);
  return number;
}

TEST(HandPicture, IsAPngOfItsSize) {
  const std::string png = picture_of(*hand_before(cylinder_thing()));
  EXPECT_TRUE(png.starts_with("\x89PNG\r\n"));
  EXPECT_EQ(number_at(png, 16), 480U);
  EXPECT_EQ(number_at(png, 20), 360U);
}

TEST(HandPicture, ShowsTheObjectAndThePosture) {
  const auto hand = hand_before(cylinder_thing());
  const std::string open = picture_of(*hand);
  EXPECT_NE(picture_of(*hand_before(sphere_thing())), open);
  EXPECT_EQ(picture_of(*hand_before(cylinder_thing())), open);
  ASSERT_TRUE(hand->command(std::vector<double>{130, 0, 10, -40, 10, -40, 10, -40}));
  ASSERT_TRUE(hand->step(2.0));
  EXPECT_NE(picture_of(*hand), open);
}

TEST(HandPicture, OfAGraspIsNamedByThingTrialAndGraspFromOneOn) {
  const TemporaryFolder folder;
  GraspPictures pictures(folder.path());
  pictures.save(*hand_before(cylinder_thing()), "tall/tube", 3, 6);
  EXPECT_EQ(pictures.lost(), 0U);
  EXPECT_TRUE(std::filesystem::exists(folder.file("tall_tube-4-7.png")));
}

TEST(HandPicture, AMissingFolderIsReported) {
  const TemporaryFolder folder;
  const auto refused =
      save_hand_picture(*hand_before(cylinder_thing()), folder.file("missing/hand.png"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::kSystem);
}

}  // namespace
}  // namespace somato
