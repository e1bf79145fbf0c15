# Every library that Seesaw stands on, found once and given one name: SeesawDeps::<what it is for>.
# The installed package includes this same file, so a program that uses Seesaw finds what Seesaw found.

include(CMakeFindDependencyMacro)
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)

function(seesaw_dependency name)
  if(NOT TARGET SeesawDeps::${name})
    add_library(SeesawDeps::${name} INTERFACE IMPORTED GLOBAL)
    target_link_libraries(SeesawDeps::${name} INTERFACE ${ARGN})
  endif()
endfunction()

# Matrices. Memory that Eigen hands over a library's border must be allocated and freed alike, whatever processor
# flags each side was compiled with: 16 bytes of alignment is what every malloc on x86-64 and arm64 gives.
find_package(Eigen3 3.4 REQUIRED NO_MODULE)
seesaw_dependency(eigen Eigen3::Eigen)
set_property(TARGET SeesawDeps::eigen PROPERTY INTERFACE_COMPILE_DEFINITIONS EIGEN_MAX_ALIGN_BYTES=16)

# Dense factorizations by LAPACK where it is installed, by plain Eigen where it is not.
pkg_check_modules(SEESAW_LAPACKE QUIET IMPORTED_TARGET GLOBAL lapacke)
pkg_check_modules(SEESAW_LAPACK QUIET IMPORTED_TARGET GLOBAL lapack)
pkg_check_modules(SEESAW_BLAS QUIET IMPORTED_TARGET GLOBAL blas)
if(SEESAW_LAPACKE_FOUND AND SEESAW_LAPACK_FOUND AND SEESAW_BLAS_FOUND)
  seesaw_dependency(lapack PkgConfig::SEESAW_LAPACKE PkgConfig::SEESAW_LAPACK PkgConfig::SEESAW_BLAS)
  set_property(TARGET SeesawDeps::lapack PROPERTY INTERFACE_COMPILE_DEFINITIONS SEESAW_HAS_LAPACK=1)
else()
  message(STATUS "Seesaw: no LAPACK found; fits run on plain Eigen, about three times slower")
  seesaw_dependency(lapack)
endif()

# xsimd is headers; Debian's CMake target for it asks to link a library (xtl) that it does not need.
find_path(SEESAW_XSIMD_INCLUDE_DIR NAMES xsimd/xsimd.hpp REQUIRED)
seesaw_dependency(simd)
set_property(TARGET SeesawDeps::simd PROPERTY INTERFACE_INCLUDE_DIRECTORIES ${SEESAW_XSIMD_INCLUDE_DIR})
find_package(TBB REQUIRED)
seesaw_dependency(threads TBB::tbb Threads::Threads)

pkg_check_modules(SEESAW_CAIRO REQUIRED IMPORTED_TARGET GLOBAL cairo>=1.16 cairo-pdf cairo-svg)
seesaw_dependency(cairo PkgConfig::SEESAW_CAIRO)
# stb is two headers; its pkg-config file would bring a shared library along.
find_path(SEESAW_STB_INCLUDE_DIR NAMES stb_image_write.h PATH_SUFFIXES stb REQUIRED)
seesaw_dependency(stb)
set_property(TARGET SeesawDeps::stb PROPERTY INTERFACE_INCLUDE_DIRECTORIES ${SEESAW_STB_INCLUDE_DIR})

find_package(nlohmann_json 3.11 REQUIRED)
seesaw_dependency(json nlohmann_json::nlohmann_json)
find_package(CLI11 REQUIRED)
seesaw_dependency(cli CLI11::CLI11)

# Mesh files and mesh simplification.
find_package(assimp 5.2 REQUIRED CONFIG)
seesaw_dependency(assimp assimp::assimp)
find_package(meshoptimizer REQUIRED CONFIG)
seesaw_dependency(meshoptimizer meshoptimizer::meshoptimizer)

# Triangles and discs in ray-traced pictures; version 3 and 4 differ in the include and the two query calls.
find_package(embree 4 CONFIG QUIET)
if(embree_FOUND)
  set(SEESAW_EMBREE_VERSION 4)
else()
  find_package(embree 3.13 REQUIRED CONFIG)
  set(SEESAW_EMBREE_VERSION 3)
endif()
seesaw_dependency(embree embree)
set_property(TARGET SeesawDeps::embree PROPERTY INTERFACE_COMPILE_DEFINITIONS SEESAW_EMBREE_VERSION=${SEESAW_EMBREE_VERSION})

# Windows: only where all three are installed.
pkg_check_modules(SEESAW_SDL2 QUIET IMPORTED_TARGET GLOBAL sdl2>=2.0.22)
pkg_check_modules(SEESAW_EPOXY QUIET IMPORTED_TARGET GLOBAL epoxy)
pkg_check_modules(SEESAW_IMGUI QUIET IMPORTED_TARGET GLOBAL imgui>=1.86)
if(SEESAW_SDL2_FOUND AND SEESAW_EPOXY_FOUND AND SEESAW_IMGUI_FOUND)
  seesaw_dependency(window PkgConfig::SEESAW_SDL2 PkgConfig::SEESAW_EPOXY PkgConfig::SEESAW_IMGUI)
else()
  message(STATUS "Seesaw: SDL2, libepoxy or Dear ImGui not found; the programs with windows are left out")
endif()
