#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "somato/core/result.h"
#include "somato/recording/recording.h"

namespace somato {

/// An import of dumps, and the folders of those that are not channels with the reasons.
struct YarpImport {
  Recording recording;
  std::vector<std::string> left_out;
};

/// Reads the dumps that `yarpdatadumper` of YARP has written: each folder with a `data.log` is a
/// channel, whose frames are its lines: a counter, a time stamp in seconds (with `Stamp: tx+rx;` in
/// `info.log` two, of which the sender's is used), and the numbers of a bottle, whose lists are
/// joined. Dumps of images and text are left out.
///
/// `files` is a pattern of the folders of explorations, such as "{object}_{trial:number}" or
/// "{object}/{trial}"; the path of a dump below it is the name of its channel. Other folders are
/// refused unless `pass_over_others`. If `files` is empty, all dumps form one exploration without
/// labels. Times are relative to the first frame of the exploration, in whole microseconds. The
/// source is the folder of the exploration.
///
/// Errors: kUsage for an invalid pattern; kSystem for files that cannot be read; kData with file
/// and line for lines without a time, with text or another number of numbers than the first line,
/// and for times that decrease; kData for no dump, folders that do not match, and explorations with
/// other channels than the first one.
Result<YarpImport> import_yarp_dumps(const std::filesystem::path& folder, const std::string& files,
                                     bool pass_over_others);

}  // namespace somato
