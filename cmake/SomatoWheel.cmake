# The wheel of the Python package is built with the physics engine of the package mujoco, which pip
# installs for the build (pyproject.toml).
find_package(Python 3.10 REQUIRED COMPONENTS Interpreter)
execute_process(COMMAND ${Python_EXECUTABLE} -c
                        "import importlib.util as u; print(u.find_spec('mujoco').submodule_search_locations[0])"
                OUTPUT_VARIABLE mujoco OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
set(MUJOCO_ROOT "${mujoco}" CACHE PATH "Folder of the package mujoco" FORCE)
