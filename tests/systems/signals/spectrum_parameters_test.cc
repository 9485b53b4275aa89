#include "somato/codes/spectrum.h"

#include <gtest/gtest.h>

namespace somato {
namespace {

std::string complaint(const SpectrumParameters& parameters) {
  const Result<void> valid = parameters.validate();
  if (valid) return {};
  EXPECT_EQ(valid.error().kind, ErrorKind::kUsage);
  return valid.error().what;
}

TEST(SpectrumParameters, FitEachOtherByDefault) {
  EXPECT_EQ(complaint({}), "");
}

TEST(SpectrumParameters, AreReadByTheirNames) {
  const Table table{"",
                    {{"window", "", Value{std::string("hamming")}},
                     {"segment_length", "", Value{std::int64_t{100}}},
                     {"overlap", "", Value{0.25}},
                     {"transform_length", "", Value{std::int64_t{200}}},
                     {"remove_mean", "", Value{false}},
                     {"quantity", "", Value{std::string("power")}},
                     {"bands", "", Value{std::int64_t{12}}},
                     {"band_spacing", "", Value{std::string("geometric")}},
                     {"low", "", Value{0.5}},
                     {"high", "", Value{4.5}},
                     {"scale", "", Value{std::string("logarithmic")}},
                     {"floor", "", Value{0.125}}}};
  const auto parameters = read_parameters<SpectrumParameters>(table);
  ASSERT_TRUE(parameters);
  EXPECT_EQ(parameters->window, SpectrumWindow::kHamming);
  EXPECT_EQ(parameters->segment_length, 100U);
  EXPECT_EQ(parameters->overlap, 0.25);
  EXPECT_EQ(parameters->transform_length, 200U);
  EXPECT_FALSE(parameters->remove_mean);
  EXPECT_EQ(parameters->quantity, SpectrumQuantity::kPower);
  EXPECT_EQ(parameters->bands, 12U);
  EXPECT_EQ(parameters->band_spacing, BandSpacing::kGeometric);
  EXPECT_EQ(parameters->low, 0.5);
  EXPECT_EQ(parameters->high, 4.5);
  EXPECT_EQ(parameters->scale, SpectrumScale::kLogarithmic);
  EXPECT_EQ(parameters->floor, 0.125);
  EXPECT_EQ(complaint(*parameters), "");
}

TEST(SpectrumParameters, RefuseWhatIsOutOfRange) {
  SpectrumParameters parameters;
  parameters.overlap = 1.0;
  EXPECT_NE(complaint(parameters).find("overlap"), std::string::npos);
  parameters = {};
  parameters.floor = 0.0;
  EXPECT_NE(complaint(parameters).find("floor"), std::string::npos);
  parameters = {};
  parameters.segment_length = 0;
  EXPECT_NE(complaint(parameters).find("segment_length"), std::string::npos);
}

TEST(SpectrumParameters, RefuseATransformShorterThanItsSegment) {
  SpectrumParameters parameters;
  parameters.segment_length = 64;
  parameters.transform_length = 63;
  EXPECT_EQ(complaint(parameters), "a transform of 63 frames cannot take segments of 64");
  parameters.transform_length = 64;
  EXPECT_EQ(complaint(parameters), "");
}

TEST(SpectrumParameters, RefuseBandsWithoutAWidth) {
  SpectrumParameters parameters;
  parameters.low = 5.0;
  parameters.high = 5.0;
  EXPECT_EQ(complaint(parameters),
            "the bands of a spectrum cannot lie between 'low' 5 and 'high' 5");
  parameters.high = 5.1;
  EXPECT_EQ(complaint(parameters), "");
}

TEST(SpectrumParameters, RefuseGeometricBandsFromZero) {
  SpectrumParameters parameters;
  parameters.band_spacing = BandSpacing::kGeometric;
  EXPECT_EQ(complaint(parameters), "geometric bands cannot start at the frequency 0");
  parameters.low = 0.1;
  EXPECT_EQ(complaint(parameters), "");
}

TEST(SpectrumParameters, TakeEveryBinOnlyWhereTheirNumberIsKnown) {
  SpectrumParameters parameters;
  parameters.bands = 0;
  EXPECT_NE(complaint(parameters).find("depends on the exploration"), std::string::npos);
  parameters.segment_length = 64;
  EXPECT_EQ(complaint(parameters), "");
  parameters.segment_length.reset();
  parameters.transform_length = 64;
  EXPECT_EQ(complaint(parameters), "");
  parameters.high = 3.0;
  EXPECT_EQ(complaint(parameters), "'low' and 'high' have no effect, because 'bands' is 0");
}

}  // namespace
}  // namespace somato
