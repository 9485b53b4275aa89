# The target mujoco::mujoco: the pinned library of scripts/fetch_mujoco.sh, or the distribution's.
set(MUJOCO_ROOT "${PROJECT_SOURCE_DIR}/build/mujoco" CACHE PATH "Folder with MuJoCo's include and lib")
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h HINTS "${MUJOCO_ROOT}/include")
find_library(MuJoCo_LIBRARY mujoco HINTS "${MUJOCO_ROOT}/lib")
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo
  REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR
  REASON_FAILURE_MESSAGE "scripts/setup.sh build fetches it")
if(MuJoCo_FOUND AND NOT TARGET mujoco::mujoco)
  add_library(mujoco::mujoco SHARED IMPORTED)
  file(REAL_PATH "${MuJoCo_LIBRARY}" mujoco_file)
  set_target_properties(mujoco::mujoco PROPERTIES IMPORTED_LOCATION "${mujoco_file}")
  target_include_directories(mujoco::mujoco SYSTEM INTERFACE "${MuJoCo_INCLUDE_DIR}")
endif()
mark_as_advanced(MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR)
