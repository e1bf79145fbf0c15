# Installs the build to a fresh folder, builds the consumer against that alone, and runs it.
#   cmake -DBUILD=<build tree> -DWORK=<scratch folder> -P run.cmake
file(REMOVE_RECURSE ${WORK})
function(step)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\n${output}")
  endif()
endfunction()
step(${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/installed)
step(${CMAKE_COMMAND} -G Ninja -S ${CMAKE_CURRENT_LIST_DIR} -B ${WORK}/build -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_PREFIX_PATH=${WORK}/installed -DCMAKE_CXX_COMPILER=${CXX})
step(${CMAKE_COMMAND} --build ${WORK}/build)
step(${WORK}/build/consumer ${WORK}/curve.png)
# The installed programs find their scenes beside themselves.
step(${WORK}/installed/bin/figures make turk2002-fig01 --out ${WORK}/figures --scale 0.5)
step(${WORK}/installed/bin/seesaw info ${WORK}/installed/share/seesaw/scenes/turk2002-fig01-left.json)
