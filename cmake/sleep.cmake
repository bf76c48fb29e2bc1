# sleep.cmake -- builds scree_sleep, which measures the cost of sleeping bodies.
file(GLOB sleep_sources CONFIGURE_DEPENDS bench/sleep/*.c)

# not installed, because it only repeats measurements
if(TARGET scree_validate)
	add_executable(scree_sleep ${sleep_sources})
	scree_flags(scree_sleep)
	set_target_properties(scree_sleep PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
	target_link_libraries(scree_sleep PRIVATE scree_validate scree_common scree_internals)
endif()
