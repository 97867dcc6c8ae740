# How every file of the project is compiled: strict warnings, which the dev preset makes errors, and its sanitizers.
add_library(stretch_options INTERFACE)
target_compile_options(stretch_options INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wno-sign-conversion
                       -Wnon-virtual-dtor -Woverloaded-virtual -Wold-style-cast -Wcast-qual -Wimplicit-fallthrough
                       $<$<CXX_COMPILER_ID:GNU>:-Wduplicated-cond>)
# Between sources that are compiled together (stretch_unity) a local name may repeat a helper's, and the compiler, which sees
# a pointer through many calls, asks of it what another source promised.
if(STRETCH_UNITY)
  target_compile_options(stretch_options INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
else()
  target_compile_options(stretch_options INTERFACE -Wshadow $<$<CXX_COMPILER_ID:GNU>:-Wnull-dereference>)
endif()
if(STRETCH_STRICT)
  target_compile_options(stretch_options INTERFACE -Werror)
endif()
target_include_directories(stretch_options INTERFACE ${CMAKE_SOURCE_DIR})
# GLM: no implicit conversions of scalars, sizes as std::size_t; radians are GLM's only unit.
target_compile_definitions(stretch_options INTERFACE GLM_FORCE_EXPLICIT_CTOR GLM_FORCE_SIZE_T_LENGTH GLM_ENABLE_EXPERIMENTAL)
# The same bits on every machine and at every optimisation level: no fused multiply-add that the source did not ask for.
target_compile_options(stretch_options INTERFACE -ffp-contract=off)
if(STRETCH_SANITIZE STREQUAL "thread")
  target_compile_options(stretch_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(stretch_options INTERFACE -fsanitize=thread)
elseif(STRETCH_SANITIZE STREQUAL "fuzz")
  # For libFuzzer, which brings its own main (tests/fuzz).
  target_compile_options(stretch_options INTERFACE -fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(stretch_options INTERFACE -fsanitize=address,undefined)
elseif(STRETCH_SANITIZE)
  target_compile_options(stretch_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(stretch_options INTERFACE -fsanitize=address,undefined)
endif()
