# Files installed by 'cmake --install'. The components are packed by SomatoPackages.cmake and the wheel.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/somato)

# Packages of a distribution keep libraries of others out of the folder that all programs search.
option(SOMATO_PRIVATE_ENGINE "Install the physics engine in a folder that only Somato searches" OFF)
set(engine_folder ${CMAKE_INSTALL_LIBDIR})
if(SOMATO_PRIVATE_ENGINE)
  set(engine_folder ${CMAKE_INSTALL_LIBDIR}/somato)
endif()

configure_package_config_file(cmake/somato-config.cmake.in somato-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(somato-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/somato-config.cmake
              ${PROJECT_BINARY_DIR}/somato-config-version.cmake
              cmake/Findlz4.cmake cmake/Findzstd.cmake
        DESTINATION ${package_folder} COMPONENT development)
install(TARGETS somato EXPORT somato-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
if(SOMATO_BUILD_SHARED)
  install(TARGETS somato_shared EXPORT somato-shared-targets
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT development)
  install(EXPORT somato-shared-targets NAMESPACE somato:: DESTINATION ${package_folder} COMPONENT development)
endif()
install(EXPORT somato-targets NAMESPACE somato:: DESTINATION ${package_folder} COMPONENT development)
# The view is only used by the program.
install(DIRECTORY include/somato DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT development
        PATTERN live EXCLUDE)
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT licences)
foreach(folder models objects)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.xml ${folder}/*.toml)
  install(FILES ${files} DESTINATION ${CMAKE_INSTALL_DATADIR}/somato/${folder} COMPONENT data)
endforeach()

# A separate package, so that users of maps do not need the physics engine.
if(SOMATO_BUILD_SIMULATION)
  get_target_property(mujoco_file mujoco::mujoco IMPORTED_LOCATION)
  get_filename_component(mujoco_name "${mujoco_file}" NAME)
  configure_package_config_file(cmake/somato-simulation.cmake.in somato-simulation.cmake
    INSTALL_DESTINATION ${package_folder} PATH_VARS engine_folder)
  install(FILES ${PROJECT_BINARY_DIR}/somato-simulation.cmake DESTINATION ${package_folder}
          COMPONENT development)
  set_target_properties(somato_simulation PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS somato_simulation EXPORT somato-simulation-targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT development
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library)
  install(EXPORT somato-simulation-targets NAMESPACE somato:: DESTINATION ${package_folder}
          COMPONENT development)

  # An engine that the system does not provide is installed as well, with its licences.
  file(REAL_PATH "${MUJOCO_ROOT}" mujoco_folder)
  cmake_path(IS_PREFIX mujoco_folder "${mujoco_file}" mujoco_is_ours)
  if(mujoco_is_ours)
    install(FILES "${mujoco_file}" DESTINATION ${engine_folder} COMPONENT physics_engine)
    file(GLOB licences "${MUJOCO_ROOT}/licenses/*" "${MUJOCO_ROOT}/LICENSE*"
         "${MUJOCO_ROOT}-*.dist-info/licenses/*")
    install(FILES ${licences} DESTINATION ${CMAKE_INSTALL_DOCDIR}/mujoco COMPONENT physics_engine)
  endif()
endif()

if(SOMATO_BUILD_PROGRAM)
  cmake_path(ABSOLUTE_PATH engine_folder BASE_DIRECTORY ${CMAKE_INSTALL_PREFIX} OUTPUT_VARIABLE engine_path)
  file(RELATIVE_PATH from_program ${CMAKE_INSTALL_FULL_BINDIR} ${engine_path})
  set_target_properties(somato_program PROPERTIES INSTALL_RPATH "$ORIGIN/${from_program}")
  install(TARGETS somato_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  if(SOMATO_BUILD_MPI)
    install(TARGETS somato_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/somato COMPONENT program)
  endif()
  foreach(folder systems studies examples devices)
    install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/somato COMPONENT data)
  endforeach()

  # The program prints its manual page and its shell completion scripts.
  function(install_printed folder name)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/printed/${name}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/printed
      COMMAND somato_program ${ARGN} > ${PROJECT_BINARY_DIR}/printed/${name}
      DEPENDS somato_program)
    set_property(GLOBAL APPEND PROPERTY SOMATO_PRINTED ${PROJECT_BINARY_DIR}/printed/${name})
    install(FILES ${PROJECT_BINARY_DIR}/printed/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder}
            COMPONENT printed)
  endfunction()
  install_printed(man/man1 somato.1 reference --man)
  install_printed(bash-completion/completions somato completions bash)
  install_printed(zsh/site-functions _somato completions zsh)
  install_printed(fish/vendor_completions.d somato.fish completions fish)
  get_property(printed GLOBAL PROPERTY SOMATO_PRINTED)
  add_custom_target(somato_printed ALL DEPENDS ${printed})
endif()
