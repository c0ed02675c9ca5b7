# Headers that most files include, read once instead of in every file; those of tests have more.
file(WRITE ${CMAKE_BINARY_DIR}/headers.cpp.new "")
file(COPY_FILE ${CMAKE_BINARY_DIR}/headers.cpp.new ${CMAKE_BINARY_DIR}/headers.cpp ONLY_IF_DIFFERENT)
function(washtub_headers name)
  add_library(${name} OBJECT ${CMAKE_BINARY_DIR}/headers.cpp)
  target_link_libraries(${name} PRIVATE washtub_libraries washtub_compiler)
  target_precompile_headers(${name} PRIVATE
    <Eigen/Dense> <fmt/format.h> <fmt/ranges.h> <algorithm> <array> <cmath> <functional> <map>
    <memory> <optional> <span> <string> <vector> ${ARGN})
endfunction()
washtub_headers(washtub_headers)
washtub_headers(washtub_test_headers <gmock/gmock.h> <gtest/gtest.h>)
target_link_libraries(washtub_test_headers PRIVATE GTest::gtest GTest::gmock)

# A room is a folder of src/ that becomes the static library washtub_<room>.
# `washtub_room(flow DEPENDS grid)` also says which way its includes may point.
function(washtub_room room)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/src/${room}/*.cpp
    ${CMAKE_SOURCE_DIR}/src/${room}/*.S)
  list(TRANSFORM ARG_DEPENDS PREPEND washtub_)
  if(sources)
    add_library(washtub_${room} STATIC ${sources})
    set(scope PUBLIC)
  else()
    add_library(washtub_${room} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_include_directories(washtub_${room} ${scope} ${CMAKE_SOURCE_DIR}/src)
  target_link_libraries(washtub_${room} ${scope} ${ARG_DEPENDS} washtub_libraries)
  if(sources)
    target_link_libraries(washtub_${room} PRIVATE $<BUILD_INTERFACE:washtub_compiler>)
    target_precompile_headers(washtub_${room} REUSE_FROM washtub_headers)
  endif()
endfunction()

# Tests of a room: tests/<room>/*.cpp becomes test_<room>; WITH names further rooms they need, RANKS
# adds a run on so many MPI ranks. Suites named Verification* take seconds: they run once, without
# sanitizers, which also leave out three ranks.
function(washtub_tests room)
  cmake_parse_arguments(ARG "" "" "RANKS;WITH" ${ARGN})
  list(TRANSFORM ARG_WITH PREPEND washtub_)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/tests/${room}/*.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(test_${room} ${sources} ${CMAKE_SOURCE_DIR}/tests/main.cpp)
  target_link_libraries(test_${room} PRIVATE washtub_${room} ${ARG_WITH} washtub_compiler GTest::gtest GTest::gmock)
  target_include_directories(test_${room} PRIVATE ${CMAKE_SOURCE_DIR}/tests)
  target_precompile_headers(test_${room} REUSE_FROM washtub_test_headers)
  set(quick --gtest_filter=-Verification*)
  if(WASHTUB_SANITIZE)
    set(filter ${quick})
    list(REMOVE_ITEM ARG_RANKS 3)
  endif()
  add_test(NAME ${room} COMMAND test_${room} ${filter} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
  foreach(n ${ARG_RANKS})
    add_test(NAME ${room}_ranks_${n}
      COMMAND ${MPIEXEC_EXECUTABLE} --allow-run-as-root --oversubscribe ${MPIEXEC_NUMPROC_FLAG} ${n}
              $<TARGET_FILE:test_${room}> ${quick}
      WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    set_tests_properties(${room}_ranks_${n} PROPERTIES PROCESSORS 2)
  endforeach()
endfunction()
