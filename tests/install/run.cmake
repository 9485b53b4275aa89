# Installs BUILD into a fresh prefix below WORK, builds the users' projects in SOURCE against it, runs
# them. SIMULATION: whether BUILD has simulated bodies.
set(prefix ${WORK}/prefix)
file(REMOVE_RECURSE ${WORK})

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

# user_project(FOLDER): sets 'configure' to the command that configures it
macro(user_project folder)
  set(configure ${CMAKE_COMMAND} -S ${SOURCE}/${folder} -B ${WORK}/${folder} -G Ninja
      -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${prefix})
endmacro()

function(build_and_run folder)
  user_project(${folder})
  run(${configure})
  run(${CMAKE_COMMAND} --build ${WORK}/${folder})
  run(${WORK}/${folder}/user)
endfunction()

# The example in C answers two frames of a system that the installed program has trained.
function(example_in_c_answers)
  set(tree ${SOURCE}/../..)
  run(${prefix}/bin/somato run icub_joints --data ${tree}/examples/synthetic_grasps --seeds 1 --out ${WORK}/icub)
  run(${CMAKE_COMMAND} -S ${tree}/examples/c -B ${WORK}/c -G Ninja -DCMAKE_CXX_COMPILER=${COMPILER}
      -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${prefix})
  run(${CMAKE_COMMAND} --build ${WORK}/c)
  file(WRITE ${WORK}/frames.txt "1 2 3 4 5 6 7 8 9\n\n10 20 30 40 50 60 70 80 90\n")
  execute_process(COMMAND ${WORK}/c/user ${WORK}/icub/system.somato INPUT_FILE ${WORK}/frames.txt
                  OUTPUT_VARIABLE answers COMMAND_ERROR_IS_FATAL ANY)
  if(NOT answers MATCHES "^[a-z_]+ [0-9.e+]+\n\n[a-z_]+ [0-9.e+]+\n$")
    message(FATAL_ERROR "The example in C printed: ${answers}")
  endif()
endfunction()

# refused(FOLDER TEXT): find_package says TEXT
function(refused folder text)
  user_project(${folder})
  execute_process(COMMAND ${configure} --fresh RESULT_VARIABLE status ERROR_VARIABLE errors)
  string(REGEX REPLACE "[ \n]+" " " errors "${errors}")
  string(FIND "${errors}" "${text}" place)
  if(status EQUAL 0 OR place EQUAL -1)
    message(FATAL_ERROR "'${folder}' should have been refused with '${text}':\n${errors}")
  endif()
endfunction()

# Everything that lies in FOLDER of the tree lies in the installed one.
function(shared_files_are_there folder)
  file(GLOB files ${SOURCE}/../../${folder}/*.xml ${SOURCE}/../../${folder}/*.toml)
  foreach(file ${files})
    get_filename_component(name ${file} NAME)
    run(${CMAKE_COMMAND} -E compare_files ${file} ${prefix}/share/somato/${folder}/${name})
  endforeach()
endfunction()

run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${prefix})
shared_files_are_there(models)
shared_files_are_there(objects)

if(SIMULATION)
  run(${prefix}/bin/somato --version)
  run(${CMAKE_COMMAND} -E chdir ${WORK} ${prefix}/bin/somato run systems/texture.toml --explain)
  foreach(printed man/man1/somato.1 bash-completion/completions/somato zsh/site-functions/_somato
          fish/vendor_completions.d/somato.fish somato/systems/texture.toml
          somato/studies/fabricslide.toml somato/examples/synthetic_grasps/README.md)
    file(SIZE ${prefix}/share/${printed} size)
    if(size EQUAL 0)
      message(FATAL_ERROR "${printed} was installed empty")
    endif()
  endforeach()
  build_and_run(simulation)
  example_in_c_answers()
  # Without the engine that came along, if one did, only who wants simulated bodies is refused.
  file(GLOB_RECURSE engine ${prefix}/lib*/libmujoco*)
  if(engine)
    file(GLOB licences ${prefix}/share/doc/*/mujoco/LICENSE)
    if(NOT licences)
      message(FATAL_ERROR "The engine was installed without its licence")
    endif()
    file(REMOVE ${engine})
    refused(simulation "The physics engine of somato's simulated bodies, libmujoco.so.")
  endif()
else()
  refused(simulation "This somato was built without simulated bodies")
endif()
build_and_run(maps)
user_project(ros2_node)
run(${configure})
run(${CMAKE_COMMAND} --build ${WORK}/ros2_node)
