# How every target of Seesaw is made: one function for a floor of core/, one for a program.

add_library(seesaw_flags INTERFACE)
target_compile_options(seesaw_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
  # g++ 12 sees overlapping copies in std::string that are not there (GCC bug 105651).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>
  $<$<BOOL:${SEESAW_WERROR}>:-Werror>
  # Files of one folder are compiled together (CMAKE_UNITY_BUILD), where g++ takes their unnamed namespaces for a header's.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${CMAKE_UNITY_BUILD}>>:-Wno-subobject-linkage>
  # Where a processor has fused multiply-add, only code that asks for it by name uses it: digits do not depend on flags.
  -ffp-contract=off)
if(SEESAW_SANITIZE)
  target_compile_options(seesaw_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(seesaw_flags INTERFACE -fsanitize=address,undefined)
endif()

# seesaw_library(rbf SOURCES a.cpp b.cpp USES base implicit PRIVATE SeesawDeps::blas PUBLIC SeesawDeps::eigen)
#   makes the static library seesaw_rbf, also known as Seesaw::rbf; USES names other floors.
function(seesaw_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PUBLIC;PRIVATE" ${ARGN})
  set(target seesaw_${name})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:seesaw_flags> ${ARG_PRIVATE})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  add_library(Seesaw::${name} ALIAS ${target})
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(${target} ${scope}
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/seesaw>)
  target_compile_features(${target} ${scope} cxx_std_20)
  foreach(floor IN LISTS ARG_USES)
    target_link_libraries(${target} ${scope} seesaw_${floor})
  endforeach()
  target_link_libraries(${target} ${scope} ${ARG_PUBLIC})
  set_property(GLOBAL APPEND PROPERTY SEESAW_LIBRARIES ${target})
endfunction()

# seesaw_program(figures SOURCES main.cpp USES scene): a program of build/<preset>/bin.
function(seesaw_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;PRIVATE" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE seesaw_flags ${ARG_PRIVATE})
  foreach(floor IN LISTS ARG_USES)
    target_link_libraries(${name} PRIVATE seesaw_${floor})
  endforeach()
endfunction()
