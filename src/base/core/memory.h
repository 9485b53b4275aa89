#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "somato/core/result.h"

namespace somato {

/// The working memory that the machine has, in bytes, however much of it is in use; the largest
/// number where that is not known.
std::size_t memory_of_machine();

/// The most memory there can be for this process, in bytes: the machine's, or less where its
/// control groups (Linux) have a limit or its own (ulimit -v) leaves it less.
std::size_t memory_limit();

/// The memory in bytes that this process can still allocate: the free memory of the machine,
/// including caches of files, within the same limits.
std::size_t free_memory();

/// An amount of memory for a person: "12 B", "1.5 GiB".
std::string memory_text(double bytes);

/// Fails (kSystem, at `where`) if `count` items of `size` bytes, which the content of a file asks
/// for, take more than a quarter of the free memory.
Result<void> check_free_memory(std::size_t count, std::size_t size, std::string_view where);

namespace detail {

/// For a process whose control groups /proc/self/cgroup lists as `groups`, below `root`: the
/// minimum limit of its group and the parent groups, minus their usage, or the limits themselves.
std::size_t control_group_memory(const std::string& root, const std::string& groups, bool free);

}  // namespace detail

}  // namespace somato
