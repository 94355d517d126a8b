# A room is a folder of src/ built as one static library. It links only to the rooms it may include;
# tests/rooms_test.py holds every #include against the same table.
add_library(druse_options INTERFACE)
target_include_directories(druse_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(druse_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror
    # One result on every machine: no fused multiply-add behind our back, and no errno from sqrt.
    -ffp-contract=off -fno-math-errno)
target_include_directories(druse_options SYSTEM INTERFACE ${GLM_INCLUDE_DIR})
target_link_libraries(druse_options INTERFACE fmt::fmt)
if(DRUSE_SANITIZE)
    target_compile_options(druse_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(druse_options INTERFACE -fsanitize=address,undefined)
endif()

# Headers of libraries that most files read are compiled once. Every file still includes what it uses, and compiles with this switched off.
option(DRUSE_PRECOMPILE "Compile the headers of libraries once for all files" ON)
if(DRUSE_PRECOMPILE)
    # GCC 12 takes the small buffer of a std::string from a precompiled header for a fault in it.
    target_compile_options(druse_options INTERFACE -Wno-array-bounds -Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread)
endif()

# druse_headers(NAME HEADERS... USES library...): compiles them; druse_use_headers(TARGET NAME): lets a target read them.
function(druse_headers name)
    cmake_parse_arguments(HEADERS "" "" "USES" ${ARGN})
    if(DRUSE_PRECOMPILE)
        set(source ${PROJECT_BINARY_DIR}/${name}.cpp)
        file(CONFIGURE OUTPUT ${source} CONTENT "")
        add_library(druse_${name} OBJECT ${source})
        target_link_libraries(druse_${name} PUBLIC druse_options ${HEADERS_USES})
        target_precompile_headers(druse_${name} PRIVATE ${HEADERS_UNPARSED_ARGUMENTS})
    endif()
endfunction()
function(druse_use_headers target name)
    if(DRUSE_PRECOMPILE)
        target_precompile_headers(${target} REUSE_FROM druse_${name})
    endif()
endfunction()

# Sources of a room are compiled several at a time, which halves the time of a clean build: what is in an unnamed namespace has a name
# that no other file of its room uses so. Off, a changed file alone is compiled again.
option(DRUSE_UNITY "Compile the sources of a room in batches" ON)

set(DRUSE_LIBRARY_HEADERS
    <algorithm> <array> <charconv> <cmath> <cstdint> <filesystem> <functional> <limits> <map> <memory> <optional> <span> <string> <string_view>
    <unordered_map> <utility> <variant> <vector> <fmt/format.h> <glm/geometric.hpp> <glm/mat4x4.hpp> <glm/vec2.hpp> <glm/vec3.hpp>)
druse_headers(library_headers ${DRUSE_LIBRARY_HEADERS})

function(druse_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;USES" ${ARGN})
    add_library(druse_${name} STATIC ${ROOM_SOURCES})
    target_link_libraries(druse_${name} PUBLIC druse_options)
    druse_use_headers(druse_${name} library_headers)
    set_target_properties(druse_${name} PROPERTIES UNITY_BUILD ${DRUSE_UNITY} UNITY_BUILD_BATCH_SIZE 8)
    foreach(room IN LISTS ROOM_USES)
        target_link_libraries(druse_${name} PUBLIC druse_${room})
    endforeach()
endfunction()
