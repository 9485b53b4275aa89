
#include "somato/codes/spectrum.h"

#include <fmt/format.h>

namespace somato {
namespace {

constexpr double kLongestSegment = 1 << 24;

tl::unexpected<Error> misfit(std::string what, std::string advice) {
  return fail(ErrorKind::kUsage, std::move(what), {}, std::move(advice));
}

Result<void> validate_bins(const SpectrumParameters& parameters) {
  if (!parameters.segment_length && !parameters.transform_length) {
    return misfit("with 'bands' 0 every bin is used, and their number depends on the exploration",
                  "set 'segment_length', or a number of 'bands'");
  }
  if (parameters.low != 0.0 || parameters.high) {
    return misfit("'low' and 'high' have no effect, because 'bands' is 0",
                  "leave them out, or set a number of 'bands'");
  }
  return {};
}

Result<void> validate_bands(const SpectrumParameters& parameters) {
  if (parameters.high && *parameters.high <= parameters.low) {
    return misfit(fmt::format("the bands of a spectrum cannot lie between 'low' {} and 'high' {}",
                              parameters.low, *parameters.high),
                  "'low' must be below 'high'");
  }
  if (parameters.band_spacing == BandSpacing::kGeometric && parameters.low == 0.0) {
    return misfit("geometric bands cannot start at the frequency 0", "set 'low' above 0");
  }
  return {};
}

}  // namespace

const std::vector<std::pair<SpectrumWindow, std::string>>& Choices<SpectrumWindow>::all() {
  static const std::vector<std::pair<SpectrumWindow, std::string>> kAll{
      {SpectrumWindow::kRectangular, "rectangular"},
      {SpectrumWindow::kHann, "hann"},
      {SpectrumWindow::kHamming, "hamming"}};
  return kAll;
}

const std::vector<std::pair<SpectrumQuantity, std::string>>& Choices<SpectrumQuantity>::all() {
  static const std::vector<std::pair<SpectrumQuantity, std::string>> kAll{
      {SpectrumQuantity::kMagnitude, "magnitude"}, {SpectrumQuantity::kPower, "power"}};
  return kAll;
}

const std::vector<std::pair<BandSpacing, std::string>>& Choices<BandSpacing>::all() {
  static const std::vector<std::pair<BandSpacing, std::string>> kAll{
      {BandSpacing::kLinear, "linear"}, {BandSpacing::kGeometric, "geometric"}};
  return kAll;
}

const std::vector<std::pair<SpectrumScale, std::string>>& Choices<SpectrumScale>::all() {
  static const std::vector<std::pair<SpectrumScale, std::string>> kAll{
      {SpectrumScale::kLinear, "linear"}, {SpectrumScale::kLogarithmic, "logarithmic"}};
  return kAll;
}

const Declarations<SpectrumParameters>& SpectrumParameters::declarations() {
  using P = SpectrumParameters;
  static const Declarations<P> kAll =
      Declarations<P>()
          .add("window", &P::window, "", Range::any(),
               "Window by which a segment is multiplied before the transform. Not given in the "
               "paper.")
          .add("segment_length", &P::segment_length, "frames", Range::between(1, kLongestSegment),
               "Number of frames of a segment; automatic: the whole exploration. 4096 give the "
               "2049 magnitudes of P11.")
          .add("overlap", &P::overlap, "", Range::between(0, 0.99),
               "Overlap of consecutive segments, as a share of their length. Not given in the "
               "paper.")
          .add("transform_length", &P::transform_length, "frames",
               Range::between(2, kLongestSegment),
               "Length of the transform, to which a segment is padded with zeros; fast without "
               "large prime factors; automatic: the next power of two. 4096 "
               "give the 2049 magnitudes of P11.")
          .add("remove_mean", &P::remove_mean, "", Range::any(),
               "Whether each segment's mean is subtracted before the window. Not given in the "
               "paper.")
          .add("quantity", &P::quantity, "", Range::any(),
               "Mean squares or their square roots. Not given in the paper.")
          .add("bands", &P::bands, "", Range::between(0, 1 << 20),
               "Number of bands from 'low' to 'high', each the sum of its bins' power; 0: every "
               "bin of the transform, as in P11.")
          .add("band_spacing", &P::band_spacing, "", Range::any(),
               "Whether bands have equal widths or equal ratios. Not given in the paper.")
          .add("low", &P::low, "Hz, or cycles/mm with a speed", Range::at_least(0),
               "Lower edge of the first band. Not given in the paper.")
          .add("high", &P::high, "Hz, or cycles/mm with a speed", Range::above(0),
               "Upper edge of the last band; automatic, without a speed: half of 'rate'. Not given "
               "in the paper.")
          .add("rate", &P::rate, "Hz", Range::above(0),
               "Frame rate of the spectra that are compared, if 'high' is automatic or 'bands' is "
               "0: bands end at half of it, and bins require it; automatic: the lowest of the "
               "recording.")
          .add("scale", &P::scale, "", Range::any(),
               "Whether values are linear or log(floor + value). Not given in the "
               "paper.")
          .add("floor", &P::floor, "unit of the quantity", Range::above(0),
               "Value added before the logarithm, which makes it finite for silence. Not given in "
               "the "
               "paper.");
  return kAll;
}

Result<void> SpectrumParameters::validate() const {
  SOMATO_TRY_VOID(check_ranges(*this));
  if (transform_length && segment_length && *transform_length < *segment_length) {
    return misfit(fmt::format("a transform of {} frames cannot take segments of {}",
                              *transform_length, *segment_length),
                  "raise 'transform_length', or leave it out");
  }
  if (rate && !depend_on_rate()) {
    return misfit("'rate' has no effect, because 'high' is set", "leave out one of them");
  }
  return bands == 0 ? validate_bins(*this) : validate_bands(*this);
}

}  // namespace somato
