# scene.cmake -- builds the reader of scene files, which needs Jansson, and pictures of scenes, which need Cairo.
file(GLOB scene_sources CONFIGURE_DEPENDS scene/*.c)

if(CMAKE_CROSSCOMPILING)
	# Debian has neither Jansson nor Cairo for WebAssembly or Windows; Jansson is built from its sources
	include(cmake/jansson.cmake)
else()
	find_package(PkgConfig)
	if(PkgConfig_FOUND)
		pkg_check_modules(JANSSON IMPORTED_TARGET jansson)
		pkg_check_modules(CAIRO IMPORTED_TARGET cairo)
	endif()
	set(jansson PkgConfig::JANSSON)
endif()

if(NOT JANSSON_FOUND AND CMAKE_CROSSCOMPILING)
	message(NOTICE "scree: scenes are left out, because the sources of Jansson are not in ${SCREE_JANSSON_SOURCE}")
elseif(NOT JANSSON_FOUND)
	message(NOTICE "scree: the command line is left out, because Jansson was not found; Debian has it in libjansson-dev")
elseif(scene_sources)
	add_library(scree_scene STATIC ${scene_sources})
	scree_flags(scree_scene)
	target_link_libraries(scree_scene PUBLIC scree_internals ${jansson} m PRIVATE scree_common)
	if(CAIRO_FOUND)
		target_link_libraries(scree_scene PRIVATE PkgConfig::CAIRO)
		target_compile_definitions(scree_scene PRIVATE SCREE_HAVE_CAIRO)
	elseif(NOT EMSCRIPTEN)
		message(NOTICE "scree: pictures are left out, because Cairo was not found; Debian has it in libcairo2-dev")
	endif()
	# scenes are searched first in the sources, then in the folder of the installation
	target_compile_definitions(scree_scene PUBLIC SCREE_SCENE_DIR="${PROJECT_SOURCE_DIR}/scenes"
		SCREE_INSTALLED_SCENE_DIR="${CMAKE_INSTALL_FULL_DATADIR}/scree/scenes")

	# golden, whose hashes tests compare; it needs no test framework, so it is built for every platform
	add_executable(golden EXCLUDE_FROM_ALL tests/tools/golden.c)
	scree_flags(golden)
	target_link_libraries(golden PRIVATE scree_scene scree_internals)
endif()
