# What every target of the project is compiled with.
add_library(texbrdf_options INTERFACE)
# No -ffast-math: NaN must stay visible. No contraction: a result must not depend on the instruction set.
target_compile_options(texbrdf_options INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Wimplicit-fallthrough -Werror
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 warns of impossible overlaps in std::string's operator+ (GCC bug 105651).
  target_compile_options(texbrdf_options INTERFACE -Wno-restrict)
elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # The stable_sort of libstdc++ 12 uses what C++17 deprecates, and clang says so.
  target_compile_options(texbrdf_options INTERFACE -Wno-deprecated-declarations)
endif()
if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "GNU" OR NOT TEXBRDF_SANITIZERS)
  target_compile_options(texbrdf_options INTERFACE -ffunction-sections -fdata-sections)
endif()
if(TEXBRDF_SANITIZERS)
  target_compile_options(texbrdf_options INTERFACE
    -fsanitize=${TEXBRDF_SANITIZERS} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  if(TEXBRDF_SANITIZERS MATCHES "undefined")
    # Debian's glslang has no RTTI, which this check needs.
    target_compile_options(texbrdf_options INTERFACE -fno-sanitize=vptr)
  endif()
  target_link_options(texbrdf_options INTERFACE -fsanitize=${TEXBRDF_SANITIZERS})
endif()

# texbrdf_library(<folder> [DEPENDS <target>…]): the folder of that name here as one static library `texbrdf_<folder>`,
# with the folder above it as include root.
function(texbrdf_library folder)
  cmake_parse_arguments(ARG "" "" "DEPENDS" ${ARGN})
  set(target texbrdf_${folder})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.cpp)
  if(sources)
    add_library(${target} STATIC ${sources})
    target_include_directories(${target} PUBLIC ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${target} PUBLIC ${ARG_DEPENDS} PRIVATE texbrdf_options)
  else()
    add_library(${target} INTERFACE)
    target_include_directories(${target} INTERFACE ${CMAKE_CURRENT_SOURCE_DIR})
    target_link_libraries(${target} INTERFACE ${ARG_DEPENDS})
  endif()
endfunction()
