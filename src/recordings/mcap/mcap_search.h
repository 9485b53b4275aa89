#pragma once

#include <cstddef>
#include <optional>

#include "recordings/mcap/exploration_notes.h"
#include "recordings/mcap/mcap_input.h"
#include "recordings/mcap/mcap_records.h"
#include "somato/core/result.h"

namespace somato {

/// Before the bytes of a chunk come opcode, length, times, sizes, checksum and the compression.
inline constexpr std::size_t kLargestChunkHead = kMcapRecordHead + 8 + 8 + 8 + 4 + 4 + 4 + 8;

/// The place of the first chunk at `from` or later whose sizes agree, or nothing. Errors: kSystem
/// with the system's reason.
Result<std::optional<std::size_t>> find_mcap_chunk(McapInput& input, std::size_t from);

/// The notes about explorations in the file, wherever they are; none in a file of another program.
/// Errors: kSystem with the system's reason; kData if they exceed 8 MiB.
Result<ExplorationNotes> find_notes(McapInput& input);

}  // namespace somato
