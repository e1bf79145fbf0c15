# cmake --install puts programs in bin, libraries in lib, headers in include/seesaw, scenes, sessions and models in share/seesaw;
# a program elsewhere then says
#     find_package(Seesaw REQUIRED)
#     target_link_libraries(mine PRIVATE Seesaw::rbf)          and     #include <core/rbf/fit.h>

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Seesaw)

get_property(libraries GLOBAL PROPERTY SEESAW_LIBRARIES)
install(TARGETS ${libraries} EXPORT SeesawTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(EXPORT SeesawTargets NAMESPACE Seesaw:: DESTINATION ${package_dir})
install(DIRECTORY core DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/seesaw FILES_MATCHING PATTERN "*.h")
foreach(program IN ITEMS seesaw figures sandbox2d)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()
install(DIRECTORY figures/scenes figures/sessions figures/data DESTINATION ${CMAKE_INSTALL_DATADIR}/seesaw)

file(WRITE ${PROJECT_BINARY_DIR}/SeesawConfig.cmake.in [[
@PACKAGE_INIT@
include(${CMAKE_CURRENT_LIST_DIR}/SeesawDependencies.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/SeesawTargets.cmake)
check_required_components(Seesaw)
]])
configure_package_config_file(${PROJECT_BINARY_DIR}/SeesawConfig.cmake.in ${PROJECT_BINARY_DIR}/SeesawConfig.cmake
  INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/SeesawConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/SeesawConfig.cmake ${PROJECT_BINARY_DIR}/SeesawConfigVersion.cmake
  cmake/SeesawDependencies.cmake DESTINATION ${package_dir})
