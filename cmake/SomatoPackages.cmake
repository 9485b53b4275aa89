# 'cpack' makes the packages of Debian (docs/packages.md) of a build with SOMATO_BUILD_SHARED: somato, the program
# with the physics engine, libsomato1 and libsomato-dev. What only Debian wants is added by debian_files.cmake.
if(NOT SOMATO_BUILD_SHARED OR NOT SOMATO_BUILD_PROGRAM)
  return()
endif()

set(SOMATO_DEBIAN_REVISION "1" CACHE STRING "Revision of the packages, such as 1~deb12")
set(SOMATO_DEBIAN_SUITE "unstable" CACHE STRING "Release of Debian in the changelog, such as bookworm")
# The project has no public address yet.
set(SOMATO_DEBIAN_MAINTAINER "Somato contributors <somato@localhost>" CACHE STRING "Who makes the packages")
# The names of Debian: amd64 and arm64.
string(REPLACE "x86_64" "amd64" architecture "${CMAKE_SYSTEM_PROCESSOR}")
string(REPLACE "aarch64" "arm64" architecture "${architecture}")

install(FILES packaging/systemd/somato-live@.service DESTINATION lib/systemd/system COMPONENT service)
install(FILES packaging/udev/70-somato.rules DESTINATION lib/udev/rules.d COMPONENT service)
install(FILES packaging/example.conf DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples COMPONENT service)

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME somato)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # The first line of each description is its own.
set(CPACK_PACKAGE_VENDOR "Somato contributors")
set(CPACK_PACKAGE_CONTACT "${SOMATO_DEBIAN_MAINTAINER}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE
                                                WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
set(CPACK_COMPONENTS_ALL program printed data physics_engine service library development)
foreach(component program printed data physics_engine service)
  string(TOUPPER ${component} upper)
  set(CPACK_COMPONENT_${upper}_GROUP program)
endforeach()
set(CPACK_COMPONENT_LIBRARY_GROUP library)
set(CPACK_COMPONENT_DEVELOPMENT_GROUP development)

set(CPACK_DEBIAN_PACKAGE_RELEASE "${SOMATO_DEBIAN_REVISION}")
set(CPACK_DEBIAN_PACKAGE_ARCHITECTURE "${architecture}")
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS "${MUJOCO_ROOT}/lib" "${PROJECT_BINARY_DIR}/src")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME somato)
set(CPACK_DEBIAN_PROGRAM_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "self-organizing sense of touch for robots
Somato trains self-organizing maps on what a robot hand has felt, so that it
distinguishes shapes, sizes, materials and objects without supervision; it
also maps any table of numbers.

This package contains the program, simulated hands with their physics engine,
and a service that reads what a skin or a robot feels.")
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS "bash-completion")

set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME libsomato${SOMATO_SOVERSION})
set(CPACK_DEBIAN_LIBRARY_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
# CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS would also offer the physics engine to other packages.
set(shlibs ${PROJECT_BINARY_DIR}/debian/shlibs)
file(WRITE ${shlibs}
     "libsomato ${SOMATO_SOVERSION} libsomato${SOMATO_SOVERSION} (>= ${PROJECT_VERSION})\n")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${PROJECT_SOURCE_DIR}/packaging/debian/triggers ${shlibs})
set(CPACK_DEBIAN_LIBRARY_DESCRIPTION "self-organizing maps and systems of touch (shared library)
Somato trains self-organizing maps on what a robot hand has felt, so that it
distinguishes shapes, sizes, materials and objects without supervision.

This package contains the library for programs in C and C++.")

set(version "${PROJECT_VERSION}-${SOMATO_DEBIAN_REVISION}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libsomato-dev)
set(CPACK_DEBIAN_DEVELOPMENT_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)
set(dependencies "libsomato${SOMATO_SOVERSION} (= ${version})" libexpected-dev libfmt-dev liblz4-dev libzstd-dev
    zlib1g-dev libpng-dev)
if(SOMATO_BUILD_PROTOBUF)
  list(APPEND dependencies libprotobuf-dev)
endif()
list(JOIN dependencies ", " CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_RECOMMENDS "somato (= ${version})")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "self-organizing maps and systems of touch (development files)
Somato trains self-organizing maps on what a robot hand has felt, so that it
distinguishes shapes, sizes, materials and objects without supervision.

This package contains the headers, the static library and the files for CMake.
The simulated bodies also need the physics engine of the package somato.")

set(CPACK_PRE_BUILD_SCRIPTS ${PROJECT_SOURCE_DIR}/cmake/debian_files.cmake)
set(CPACK_SOMATO_SOURCE ${PROJECT_SOURCE_DIR})
set(CPACK_SOMATO_VERSION ${version})
set(CPACK_SOMATO_SUITE ${SOMATO_DEBIAN_SUITE})
set(CPACK_SOMATO_LIBRARY libsomato${SOMATO_SOVERSION})
include(CPack)
