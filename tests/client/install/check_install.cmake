# Installs the client library into WORK and builds and runs a user's project against it.
#   cmake -DBUILD=... -DWORK=... -DCONSUMER=... -DGENERATOR=... -DFLAGS=... -P check_install.cmake
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "failed: ${ARGN}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
run(${CMAKE_COMMAND} --install ${BUILD} --component client_development --prefix ${WORK}/tree)
if(NOT EXISTS ${WORK}/tree/share/remeshd/Apache-2.0.txt)
  message(FATAL_ERROR "the library is installed without its licence")
endif()
run(${CMAKE_COMMAND} -S ${CONSUMER} -B ${WORK}/build -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK}/tree -DCMAKE_CXX_FLAGS=${FLAGS} -DCMAKE_BUILD_TYPE=Release)
run(${CMAKE_COMMAND} --build ${WORK}/build)
run(${WORK}/build/consumer)
file(REMOVE_RECURSE ${WORK})
