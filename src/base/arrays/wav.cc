#include "base/arrays/wav.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/archives/little_endian.h"

namespace somato {
namespace {

constexpr std::size_t kChunkHead = 8;
constexpr std::size_t kFileHead = 12;
constexpr std::size_t kShortestFormat = 16;
constexpr std::size_t kSubformat = 24;  // Its place in an extensible format.
constexpr std::uint16_t kPcm = 1;
constexpr std::uint16_t kFloat = 3;
constexpr std::uint16_t kExtensible = 0xFFFE;

struct Format {
  std::uint16_t coding = 0;
  std::size_t channels = 0;
  std::uint32_t rate = 0;
  std::size_t bits = 0;

  std::size_t sample_bytes() const { return bits / 8; }
};

tl::unexpected<Error> bad(std::string what, const std::string& where,
                          std::string advice = "record or save it again") {
  return fail(ErrorKind::kData, std::move(what), where, std::move(advice));
}

template <typename T>
T wav_number_at(std::string_view bytes, std::size_t place) {
  return little_endian<T>(bytes.data() + place);
}

Format format_in(std::string_view chunk) {
  Format format{wav_number_at<std::uint16_t>(chunk, 0), wav_number_at<std::uint16_t>(chunk, 2),
                wav_number_at<std::uint32_t>(chunk, 4), wav_number_at<std::uint16_t>(chunk, 14)};
  if (format.coding == kExtensible && chunk.size() >= kSubformat + 2) {
    format.coding = wav_number_at<std::uint16_t>(chunk, kSubformat);
  }
  return format;
}

Result<void> check_format(const Format& format, const std::string& where) {
  const bool is_pcm = format.coding == kPcm && (format.bits == 8 || format.bits == 16 ||
                                                format.bits == 24 || format.bits == 32);
  const bool is_float = format.coding == kFloat && (format.bits == 32 || format.bits == 64);
  if (!is_pcm && !is_float) {
    return bad(
        fmt::format("its samples are in the coding {} with {} bits", format.coding, format.bits),
        where, "save it as PCM of 16 or 24 bits");
  }
  if (format.channels > 0 && format.rate > 0) return {};
  return bad(fmt::format("it has {} channels of {} Hz", format.channels, format.rate), where);
}

// The sample in the range [-1, 1) for integers.
float sample_at(const char* bytes, const Format& format) {
  constexpr float kByteMiddle = 128.0F;
  constexpr double kHalfRange = 2147483648.0;  // 2^31
  const std::size_t size = format.sample_bytes();
  if (format.coding == kFloat) {
    return size == sizeof(float) ? little_endian<float>(bytes)
                                 : static_cast<float>(little_endian<double>(bytes));
  }
  if (size == 1) {
    return (static_cast<float>(static_cast<unsigned char>(*bytes)) - kByteMiddle) / kByteMiddle;
  }
  std::uint32_t bits = 0;  // The sample in the highest bytes.
  for (std::size_t i = 0; i < size; ++i) {
    bits |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8 * (4 - size + i));
  }
  return static_cast<float>(static_cast<double>(static_cast<std::int32_t>(bits)) / kHalfRange);
}

// Whether `size` bytes of samples, with `rest` after its chunk's head, are what a writer to a pipe
// states: ffmpeg the largest number, sox and arecord about 2 GiB, with or without their headers,
// and GStreamer 0. `riff` is the size of the file that its head states.
bool is_unknown(std::size_t size, std::size_t rest, std::size_t riff, std::size_t file) {
  constexpr std::size_t kHalf = std::size_t{1} << 31;
  constexpr std::size_t kWhole = std::size_t{1} << 32;
  constexpr std::size_t kHeaders = 4096;
  if (size == 0) return rest > 0 && riff + kChunkHead != file && riff + kChunkHead + 1 != file;
  const bool is_largest = size >= kWhole - kHeaders;
  const bool is_half = size >= kHalf - kHeaders && size < kHalf + kHeaders;
  return size > rest && (is_largest || is_half);
}

// All bytes behind the head of a chunk of unknown size. A sample of odd length may be padded.
std::string_view samples_to_the_end(std::string_view rest, const Format& format) {
  const std::size_t block = format.sample_bytes() * format.channels;
  const bool is_padded = block > 1 && block % 2 == 1 && rest.size() % block == 1 &&
                         rest.size() % 2 == 0 && rest.back() == '\0';
  return is_padded ? rest.substr(0, rest.size() - 1) : rest;
}

Result<Sound> sound_of(const Format& format, std::string_view data, const std::string& where) {
  SOMATO_TRY_VOID(check_format(format, where));
  const std::size_t size = format.sample_bytes();
  const std::size_t count = data.size() / (size * format.channels);
  if (count == 0) return bad("it has no samples", where);
  if (data.size() % (size * format.channels) != 0) {
    return bad("its last sample is cut", where);
  }
  Sound sound{static_cast<double>(format.rate), Matrix<float>(count, format.channels)};
  for (std::size_t i = 0; i < sound.samples.values().size(); ++i) {
    const float sample = sample_at(data.data() + i * size, format);
    if (!std::isfinite(sample)) {
      return bad(fmt::format("sample {} is not a finite number", i / format.channels + 1), where);
    }
    sound.samples.values()[i] = sample;
  }
  return sound;
}

}  // namespace

Result<Sound> decode_wav(std::string_view bytes, const std::string& where) {
  if (bytes.starts_with("RF64") || bytes.starts_with("RIFX")) {
    return bad(fmt::format("it is a file of the kind {}", bytes.substr(0, 4)), where,
               "save it as WAV below 4 GiB");
  }
  if (bytes.size() < kFileHead || !bytes.starts_with("RIFF") || bytes.substr(8, 4) != "WAVE") {
    return bad("it is not a WAV file", where);
  }
  std::optional<Format> format;
  for (std::size_t place = kFileHead; bytes.size() - place >= kChunkHead;) {
    const std::string_view name = bytes.substr(place, 4);
    const std::size_t size = wav_number_at<std::uint32_t>(bytes, place + 4);
    const std::string_view rest = bytes.substr(place + kChunkHead);
    const std::size_t riff = wav_number_at<std::uint32_t>(bytes, 4);
    if (name == "data" && format && is_unknown(size, rest.size(), riff, bytes.size())) {
      return sound_of(*format, samples_to_the_end(rest, *format), where);
    }
    if (size > rest.size()) {
      return bad(fmt::format("the file is cut within its part '{}'", name), where);
    }
    const std::string_view chunk = rest.substr(0, size);
    if (name == "fmt " && size >= kShortestFormat) format = format_in(chunk);
    if (name == "data" && format) return sound_of(*format, chunk, where);
    // A chunk of odd length is padded.
    place = std::min(place + kChunkHead + size + size % 2, bytes.size());
  }
  return bad("it has no samples", where);
}

}  // namespace somato
