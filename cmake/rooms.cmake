# A room is a folder of src/ built as one static library. It links only to the rooms it may include;
# tests/rooms_test.py holds every #include against the same table.
add_library(druse_options INTERFACE)
target_include_directories(druse_options INTERFACE ${PROJECT_SOURCE_DIR}/src)
target_compile_options(druse_options INTERFACE
    -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Werror
    # One result on every machine: no fused multiply-add behind our back, and no errno from sqrt.
    -ffp-contract=off -fno-math-errno)
if(DRUSE_SANITIZE)
    target_compile_options(druse_options INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(druse_options INTERFACE -fsanitize=address,undefined)
endif()

function(druse_room name)
    cmake_parse_arguments(ROOM "" "" "SOURCES;USES" ${ARGN})
    add_library(druse_${name} STATIC ${ROOM_SOURCES})
    target_link_libraries(druse_${name} PUBLIC druse_options)
    foreach(room IN LISTS ROOM_USES)
        target_link_libraries(druse_${name} PUBLIC druse_${room})
    endforeach()
endfunction()
