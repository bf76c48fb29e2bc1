# common.cmake -- builds scree_common: clock, random numbers, hash, medians, spaced names and files for programs.
file(GLOB common_sources CONFIGURE_DEPENDS tools/common/*.c)
add_library(scree_common STATIC EXCLUDE_FROM_ALL ${common_sources})
scree_flags(scree_common)
target_link_libraries(scree_common PUBLIC Threads::Threads) # on Windows it has the clock
