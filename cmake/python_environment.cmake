# Makes a Python environment with the packages of the files REQUIREMENTS, installed without their
# dependencies, in the folder TO; costs nothing when it is there. -DPYTHON=PROGRAM
# [-DREQUIREMENTS=FILE[;FILE...]] -DTO=FOLDER [-DBASE=FOLDER]
# BASE is another environment of the same interpreter, whose packages, pip among them, are used instead of
# installed again. Modules are not compiled here: most of them are never imported, and Python compiles the
# others when they are imported for the first time.
set(stamp ${TO}/installed)
set(options)
foreach(file IN LISTS REQUIREMENTS)
  file(READ ${file} text)
  string(APPEND wanted "${text}")
  list(APPEND options -r ${file})
endforeach()
if(EXISTS ${stamp})
  file(READ ${stamp} installed)
endif()
if(EXISTS ${stamp} AND "${wanted}" STREQUAL "${installed}")
  return()
endif()
file(REMOVE_RECURSE ${TO})
set(without_pip)
if(BASE)
  set(without_pip --without-pip)
endif()
execute_process(COMMAND ${PYTHON} -m venv ${without_pip} ${TO} RESULT_VARIABLE status)
if(status EQUAL 0 AND BASE)
  set(packages "import sysconfig; print(sysconfig.get_path('purelib'), end='')")
  execute_process(COMMAND ${BASE}/bin/python -c "${packages}" OUTPUT_VARIABLE of_base COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${TO}/bin/python -c "${packages}" OUTPUT_VARIABLE own COMMAND_ERROR_IS_FATAL ANY)
  file(WRITE ${own}/base.pth "${of_base}\n")
endif()
if(status EQUAL 0 AND REQUIREMENTS)
  execute_process(COMMAND ${TO}/bin/python -m pip install --quiet --disable-pip-version-check
                          --no-deps --no-compile ${options}
                  RESULT_VARIABLE status)
endif()
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the packages of ${REQUIREMENTS} cannot be installed (${status}); is python3-venv "
                      "installed, and the package index within reach? 'pip config list' shows which it is")
endif()
file(WRITE ${stamp} "${wanted}")
