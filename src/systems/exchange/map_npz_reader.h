#pragma once

#include <string>
#include <string_view>

#include "somato/core/result.h"
#include "somato/graph/som_model.h"

namespace somato {

/// Whether `bytes` are an archive that save_map_npz() may have written, possibly damaged or of a
/// newer version.
bool is_map_npz(std::string_view bytes);

/// The same model, bit by bit, from the source `where`. Errors: kData for bytes that are damaged
/// or contain something else, with the name of the array; kSystem for too little memory.
Result<SomModel> map_in_npz(std::string_view bytes, const std::string& where);

}  // namespace somato
