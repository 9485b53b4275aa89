#include "somato/studies/vectors.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

using Texts = std::vector<std::string>;

Exploration exploration(float offset) {
  const Matrix<float> joints(3, 2, {1 + offset, 2, 50, 60, 4 + offset, 2.5F});
  return {{},
          "ball_1.txt",
          {{"joints", "deg", {"thumb", "index"}, joints, {}},
           {"touch", "counts", {}, Matrix<float>(1, 2, {7, 8}), {}}}};
}

const Recording kRecording{{exploration(0), exploration(10)}};

std::vector<float> vector_of(const Vectors& vectors, std::size_t sample) {
  std::vector<float> values(vectors.samples.size());
  write_dense(vectors.samples[sample], values);
  return values;
}

std::vector<float> second_vector(FrameChoice frames, Texts channels = {"joints"}) {
  VectorParameters parameters;
  parameters.channels = std::move(channels);
  parameters.frames = frames;
  return vector_of(make_vectors(kRecording, parameters).value(), 1);
}

TEST(Vectors, TakeTheFrameThatIsAskedFor) {
  EXPECT_EQ(second_vector(FrameChoice::kFirst), (std::vector<float>{11, 2}));
  EXPECT_EQ(second_vector(FrameChoice::kLast), (std::vector<float>{14, 2.5F}));
  EXPECT_EQ(second_vector(FrameChoice::kChange), (std::vector<float>{3, 0.5F}));
}

TEST(Vectors, PutChannelsAfterEachOtherInTheOrderAskedFor) {
  EXPECT_EQ(second_vector(FrameChoice::kLast, {"touch", "joints"}),
            (std::vector<float>{7, 8, 14, 2.5F}));
  // The change over a single frame is none.
  EXPECT_EQ(second_vector(FrameChoice::kChange, {"touch"}), (std::vector<float>{0, 0}));
}

TEST(Vectors, KeepTheOrderOfTheExplorations) {
  VectorParameters parameters;
  parameters.channels = {"joints"};
  const Vectors vectors = make_vectors(kRecording, parameters).value();
  ASSERT_EQ(vectors.samples.count(), 2U);
  EXPECT_EQ(vector_of(vectors, 0), (std::vector<float>{4, 2.5F}));
}

TEST(Vectors, NameTheirElements) {
  VectorParameters parameters;
  parameters.channels = {"joints", "touch"};
  EXPECT_EQ(make_vectors(kRecording, parameters).value().element_names,
            (Texts{"joints.thumb", "joints.index", "touch.1", "touch.2"}));
}

TEST(Vectors, RefuseAnUnknownChannelWithTheNearest) {
  VectorParameters parameters;
  parameters.channels = {"touch", "join"};
  const auto vectors = make_vectors(kRecording, parameters);
  ASSERT_FALSE(vectors);
  EXPECT_EQ(vectors.error().kind, ErrorKind::kUsage);
  EXPECT_EQ(to_string(vectors.error()),
            "ball_1.txt: unknown channel 'join'; did you mean 'joints'?");
}

}  // namespace
}  // namespace somato
