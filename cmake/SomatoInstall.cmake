# Files installed by 'cmake --install'.
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/somato)

configure_package_config_file(cmake/somato-config.cmake.in somato-config.cmake
  INSTALL_DESTINATION ${package_folder})
write_basic_package_version_file(somato-config-version.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/somato-config.cmake
              ${PROJECT_BINARY_DIR}/somato-config-version.cmake
              cmake/Findlz4.cmake cmake/Findzstd.cmake
        DESTINATION ${package_folder})
install(TARGETS somato EXPORT somato-targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT somato-targets NAMESPACE somato:: DESTINATION ${package_folder})
# The view is only used by the program.
install(DIRECTORY include/somato DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} PATTERN live EXCLUDE)
install(FILES LICENSE NOTICE DESTINATION ${CMAKE_INSTALL_DOCDIR})
foreach(folder models objects)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.xml ${folder}/*.toml)
  install(FILES ${files} DESTINATION ${CMAKE_INSTALL_DATADIR}/somato/${folder})
endforeach()

# A separate package, so that users of maps do not need the physics engine.
if(SOMATO_BUILD_SIMULATION)
  get_target_property(mujoco_file mujoco::mujoco IMPORTED_LOCATION)
  get_filename_component(mujoco_name "${mujoco_file}" NAME)
  configure_package_config_file(cmake/somato-simulation.cmake.in somato-simulation.cmake
    INSTALL_DESTINATION ${package_folder} PATH_VARS CMAKE_INSTALL_LIBDIR)
  install(FILES ${PROJECT_BINARY_DIR}/somato-simulation.cmake DESTINATION ${package_folder})
  set_target_properties(somato_simulation PROPERTIES INSTALL_RPATH "$ORIGIN")
  install(TARGETS somato_simulation EXPORT somato-simulation-targets
          ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT somato-simulation-targets NAMESPACE somato:: DESTINATION ${package_folder})

  # An engine that the system does not provide is installed as well, with its licences.
  file(REAL_PATH "${MUJOCO_ROOT}" mujoco_folder)
  cmake_path(IS_PREFIX mujoco_folder "${mujoco_file}" mujoco_is_ours)
  if(mujoco_is_ours)
    install(FILES "${mujoco_file}" DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT physics_engine)
    file(GLOB licences "${MUJOCO_ROOT}/licenses/*" "${MUJOCO_ROOT}/LICENSE*"
         "${MUJOCO_ROOT}-*.dist-info/licenses/*")
    install(FILES ${licences} DESTINATION ${CMAKE_INSTALL_DOCDIR}/mujoco COMPONENT physics_engine)
  endif()
endif()

if(SOMATO_BUILD_PROGRAM)
  file(RELATIVE_PATH from_program ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
  set_target_properties(somato_program PROPERTIES INSTALL_RPATH "$ORIGIN/${from_program}")
  install(TARGETS somato_program RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT program)
  if(SOMATO_BUILD_MPI)
    install(TARGETS somato_mpi LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/somato COMPONENT program)
  endif()
  foreach(folder systems studies examples)
    install(DIRECTORY ${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/somato)
  endforeach()

  # The program prints its manual page and its shell completion scripts.
  function(install_printed folder name)
    add_custom_command(OUTPUT ${PROJECT_BINARY_DIR}/printed/${name}
      COMMAND ${CMAKE_COMMAND} -E make_directory ${PROJECT_BINARY_DIR}/printed
      COMMAND somato_program ${ARGN} > ${PROJECT_BINARY_DIR}/printed/${name}
      DEPENDS somato_program)
    set_property(GLOBAL APPEND PROPERTY SOMATO_PRINTED ${PROJECT_BINARY_DIR}/printed/${name})
    install(FILES ${PROJECT_BINARY_DIR}/printed/${name} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder})
  endfunction()
  install_printed(man/man1 somato.1 reference --man)
  install_printed(bash-completion/completions somato completions bash)
  install_printed(zsh/site-functions _somato completions zsh)
  install_printed(fish/vendor_completions.d somato.fish completions fish)
  get_property(printed GLOBAL PROPERTY SOMATO_PRINTED)
  add_custom_target(somato_printed ALL DEPENDS ${printed})
endif()
