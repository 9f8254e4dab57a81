# SPDX-License-Identifier: MIT
# Finds what the Python package is built and tested with: a Python 3.11 or newer that has NumPy and
# its headers, and pybind11. Debian's NumPy belongs to Debian's Python, which need not be the first
# on PATH: the interpreters that are there are asked in turn. Python_EXECUTABLE chooses one.
# Sets hodograph_has_python and hodograph_note_python.

set(hodograph_has_python FALSE)
set(hodograph_note_python "off")
if(HODOGRAPH_WITH_PYTHON)
  if(NOT Python_EXECUTABLE)
    foreach(candidate IN ITEMS /usr/bin/python3 python3)
      execute_process(COMMAND ${candidate} -c "import numpy, sys; assert sys.version_info >= (3, 11)"
                      RESULT_VARIABLE failed OUTPUT_QUIET ERROR_QUIET)
      if(NOT failed)
        find_program(Python_EXECUTABLE ${candidate})
        break()
      endif()
    endforeach()
  endif()
  set(hodograph_note_python "off (no Python with NumPy found)")
  if(Python_EXECUTABLE)
    find_package(Python 3.11 COMPONENTS Interpreter Development.Module QUIET)
    find_package(pybind11 CONFIG QUIET)
    if(Python_Development.Module_FOUND AND pybind11_FOUND)
      set(hodograph_has_python TRUE)
      set(hodograph_note_python "on")
    else()
      set(hodograph_note_python "off (pybind11 or Python's headers not found)")
    endif()
  endif()
  if(NOT hodograph_has_python AND NOT HODOGRAPH_WITH_PYTHON STREQUAL "AUTO")
    message(FATAL_ERROR "HODOGRAPH_WITH_PYTHON is ON: ${hodograph_note_python}")
  endif()
endif()
