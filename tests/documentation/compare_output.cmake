# SPDX-License-Identifier: MIT
# Runs PROGRAM ARGUMENT and fails unless it prints exactly what the file EXPECTED holds.
execute_process(COMMAND "${PROGRAM}" ${ARGUMENT} OUTPUT_VARIABLE printed RESULT_VARIABLE code)
file(READ "${EXPECTED}" expected)
if(NOT code EQUAL 0 OR NOT printed STREQUAL expected)
  message(FATAL_ERROR "exit code ${code}; printed\n${printed}\nexpected\n${expected}")
endif()
