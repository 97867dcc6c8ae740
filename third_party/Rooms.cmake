# The rooms of the house and what each may link. The include-direction test guards the same arrows in the sources.
find_package(PkgConfig REQUIRED)
find_package(Threads REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(TBB REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
find_package(OpenMesh REQUIRED)
find_package(embree 3 REQUIRED)
find_package(CLI11 REQUIRED)
find_package(glfw3 REQUIRED)
find_package(Fontconfig REQUIRED)
find_package(draco REQUIRED)
find_package(meshoptimizer REQUIRED)
find_package(TinyGLTF REQUIRED)
find_package(assimp REQUIRED)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
pkg_check_modules(FREETYPE REQUIRED IMPORTED_TARGET freetype2)
pkg_check_modules(WEBP REQUIRED IMPORTED_TARGET libwebp)
pkg_check_modules(SNDFILE REQUIRED IMPORTED_TARGET sndfile)
pkg_check_modules(OPENAL REQUIRED IMPORTED_TARGET openal)

# Headers of packages are no code of ours: their warnings stay off.
function(stretch_system_includes target)
  foreach(package IN LISTS ARGN)
    get_target_property(directories ${package} INTERFACE_INCLUDE_DIRECTORIES)
    if(directories)
      target_include_directories(${target} SYSTEM PUBLIC ${directories})
    endif()
  endforeach()
endfunction()

# Debian's shared libdraco exports copies of its own of tinygltf and of stb, of other versions, which the program would get for
# those that it asks for: the archive gives the decoder alone (tests/core/gltf_new_file_test.cpp asks which copy answers).
set(STRETCH_LINKS_core fmt::fmt nlohmann_json::nlohmann_json Threads::Threads TBB::tbb stb TinyGLTF::TinyGLTF
    draco::draco_static meshoptimizer::meshoptimizer PkgConfig::WEBP assimp::assimp)
set(STRETCH_LINKS_rig stretch_core)
set(STRETCH_LINKS_skinning stretch_core embree Eigen3::Eigen OpenMeshCore)
set(STRETCH_LINKS_app stretch_core stretch_rig stretch_skinning CLI11::CLI11 PkgConfig::SNDFILE)
set(STRETCH_LINKS_ui stretch_app glfw PkgConfig::IMGUI stb PkgConfig::EPOXY PkgConfig::FREETYPE Fontconfig::Fontconfig
    PkgConfig::OPENAL)

# Sources of one target share the cost of the headers that they all read, a few large compilations for each target: so a
# helper's name is its room's own, even in an unnamed namespace. The dev preset compiles each source by itself.
function(stretch_unity target)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${STRETCH_UNITY} UNITY_BUILD_BATCH_SIZE 14)
endfunction()

# stretch_room(name): the library stretch_<name> of every source in that folder; app/main.cpp belongs to the program.
function(stretch_room room)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${room}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "app/main\\.cpp$")
  if(NOT sources)
    add_library(stretch_${room} INTERFACE)
    target_link_libraries(stretch_${room} INTERFACE stretch_options ${STRETCH_LINKS_${room}})
    return()
  endif()
  add_library(stretch_${room} STATIC ${sources})
  target_link_libraries(stretch_${room} PUBLIC stretch_options ${STRETCH_LINKS_${room}})
  stretch_unity(stretch_${room})
endfunction()

# The one executable: joins the program without a screen (app) with the editor and the pictures (ui).
function(stretch_program)
  if(EXISTS ${CMAKE_SOURCE_DIR}/app/main.cpp)
    add_executable(stretch-engine ${CMAKE_SOURCE_DIR}/app/main.cpp)
    target_link_libraries(stretch-engine PRIVATE stretch_app stretch_ui)
  endif()
endfunction()

# The program that makes the bundled character, and what it is made of as a library for its tests.
function(stretch_assets)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/assets/*.cpp)
  list(FILTER sources EXCLUDE REGEX "assets/make_dummy\\.cpp$")
  add_library(stretch_assets STATIC ${sources})
  target_link_libraries(stretch_assets PUBLIC stretch_core)
  stretch_unity(stretch_assets)
  add_executable(make-dummy ${CMAKE_SOURCE_DIR}/assets/make_dummy.cpp)
  target_link_libraries(make-dummy PRIVATE stretch_assets)
endfunction()
