#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "recordings/bags/bag_metadata.h"
#include "recordings/bags/sorted_bag.h"
#include "somato/core/result.h"

namespace somato {

/// A bag: a file, or a folder with metadata.yaml and one or more files.
struct BagLocation {
  std::string path;                  ///< The folder, or the file.
  std::string name;                  ///< Its path below the folder that was searched, with slashes.
  std::vector<std::string> files;    ///< In the order in which they were recorded.
  BagMetadata metadata;              ///< Empty without metadata.yaml.
  std::vector<std::string> remarks;  ///< Sentences about files that differ from the description.
};

/// The bags at `path`, in natural order: a file; a folder with metadata.yaml, which is one bag; or
/// a folder with such folders and files (*.mcap, *.db3). Files with the name of their folder and a
/// number, as rosbag2 splits a bag, are one bag, too, without metadata.yaml or if that lists no
/// files; they are in the order of their first messages. Errors: kSystem for a folder that cannot
/// be read; kData for no bag, a file of metadata.yaml that is missing, compressed messages or
/// files, and bags of ROS 1 (with the command that converts them).
Result<std::vector<BagLocation>> find_bags(const std::filesystem::path& path);

/// Reads the files of a bag one after the other, in the order of SortedBag. Topics without a
/// definition get those of `definitions`, a folder with .msg files (`package/msg/Name.msg`), unless
/// it is empty. Errors: as the kinds of files.
Result<std::unique_ptr<SortedBag>> open_bag(const BagLocation& bag,
                                            const std::string& definitions = {});

/// How a bag differs from its description, a sentence each: BagLocation::remarks, and the numbers
/// of messages that were read, by topic and by file. `read` is at its end.
std::vector<std::string> remarks_on(const BagLocation& bag, const SortedBag& read);

}  // namespace somato
