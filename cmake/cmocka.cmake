# cmocka.cmake -- builds cmocka, the test framework, from its sources, because Debian has no package of it for other systems.
set(SCREE_CMOCKA_SOURCE ${PROJECT_SOURCE_DIR}/build/sources/cmocka CACHE PATH
	"Folder of cmocka's sources; tools/source.sh cmocka FOLDER fetches them")
if(EXISTS ${SCREE_CMOCKA_SOURCE}/src/cmocka.c)
	add_library(scree_cmocka STATIC EXCLUDE_FROM_ALL ${SCREE_CMOCKA_SOURCE}/src/cmocka.c)
	target_include_directories(scree_cmocka SYSTEM PUBLIC ${SCREE_CMOCKA_SOURCE}/include)
	# cmocka's own configuration is replaced by these definitions; every system of cmake/cross.cmake has them
	target_compile_definitions(scree_cmocka PRIVATE HAVE_INTTYPES_H HAVE_MALLOC_H HAVE_SIGNAL_H HAVE_STRUCT_TIMESPEC
		$<$<BOOL:${UNIX}>:HAVE_STRINGS_H>)
	set(cmocka scree_cmocka)
	set(CMOCKA_FOUND ON)
endif()
