# Calls PROGRAM with CALL (a list) in an empty FOLDER; checks the exit code and that the output matches OUTPUT.
file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${PROGRAM} ${CALL} WORKING_DIRECTORY ${FOLDER}
  RESULT_VARIABLE exit_code OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT exit_code STREQUAL EXIT)
  message(FATAL_ERROR "exit code ${exit_code} where ${EXIT} belongs; output:\n${output}")
endif()
if(NOT output MATCHES "${OUTPUT}")
  message(FATAL_ERROR "output does not match '${OUTPUT}':\n${output}")
endif()
