# The target mujoco::mujoco: the pinned library of scripts/fetch_mujoco.sh, or the distribution's.
set(MUJOCO_ROOT "${PROJECT_SOURCE_DIR}/build/mujoco" CACHE PATH "Folder with MuJoCo's include and lib")
find_path(MuJoCo_INCLUDE_DIR mujoco/mujoco.h HINTS "${MUJOCO_ROOT}/include")
# The package of Python has no link without the version.
file(GLOB versions RELATIVE "${MUJOCO_ROOT}" "${MUJOCO_ROOT}/libmujoco.so.*")
find_library(MuJoCo_LIBRARY NAMES ${versions} mujoco HINTS "${MUJOCO_ROOT}"
             PATH_SUFFIXES lib "lib/${CMAKE_LIBRARY_ARCHITECTURE}")
if(MuJoCo_INCLUDE_DIR)
  file(STRINGS "${MuJoCo_INCLUDE_DIR}/mujoco/mujoco.h" version REGEX "^#define mjVERSION_HEADER ")
  string(REGEX REPLACE "[^0-9]" "" MuJoCo_VERSION "${version}")  # 222 is 2.2.2, 3017000 is 3.17.0
endif()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(MuJoCo
  REQUIRED_VARS MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR
  VERSION_VAR MuJoCo_VERSION
  REASON_FAILURE_MESSAGE "the physics engine is missing. Either run 'scripts/setup.sh build', which \
fetches it, or give the folder of a MuJoCo of your own by -DMUJOCO_ROOT=FOLDER, or build \
without simulated bodies by -DSOMATO_BUILD_SIMULATION=OFF")
if(MuJoCo_FOUND AND NOT TARGET mujoco::mujoco)
  file(REAL_PATH "${MuJoCo_LIBRARY}" MuJoCo_FILE)
  add_library(mujoco::mujoco SHARED IMPORTED)
  set_target_properties(mujoco::mujoco PROPERTIES IMPORTED_LOCATION "${MuJoCo_FILE}")
  target_include_directories(mujoco::mujoco SYSTEM INTERFACE "${MuJoCo_INCLUDE_DIR}")
endif()
mark_as_advanced(MuJoCo_LIBRARY MuJoCo_INCLUDE_DIR)
