#pragma once

namespace somato {

// The file names of known data sets, as patterns for NamePattern.
inline constexpr const char* kIcubGraspFiles = "{object}_{trial:number}.txt";
inline constexpr const char* kFabricslideFiles =
    "{fabric}_F{force:number}_V{velocity:number}mmps_{trial:number}.csv";
inline constexpr const char* kHkustPressSlideFiles = "Material_{material}_raw_{trial:number}.csv";
inline constexpr const char* kAcousticHardnessFiles = "{sample}.json";

}  // namespace somato
