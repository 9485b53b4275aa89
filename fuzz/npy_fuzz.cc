#include <cmath>
#include <cstdint>
#include <string_view>

#include "somato/core/check.h"
#include "somato/files/npy.h"

// An accepted matrix is finite, and reads back when it is written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  const somato::Result<somato::Matrix<float>> matrix = somato::decode_npy(bytes, "input");
  if (!matrix) return 0;
  SOMATO_ASSERT(!matrix->empty());
  for (const float value : matrix->values()) SOMATO_ASSERT(std::isfinite(value));
  SOMATO_ASSERT(somato::decode_npy(somato::encode_npy(*matrix), "again") == *matrix);
  return 0;
}
