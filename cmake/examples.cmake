# examples.cmake -- builds the example of rollback, which a test runs. Its sockets are those of POSIX.
file(GLOB rollback_sources CONFIGURE_DEPENDS examples/rollback/*.c)

# not installed: it is a source to read; examples/CMakeLists.txt builds all examples with an installed library
if(UNIX)
	add_executable(rollback ${rollback_sources})
	scree_flags(rollback)
	target_link_libraries(rollback PRIVATE scree::scree m)
endif()
