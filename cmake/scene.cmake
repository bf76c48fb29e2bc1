# scene.cmake -- builds the reader and writer of scene files, which need Jansson: the library scree_scene, and a form of it for the
# programs of this build, which also draws scenes, by Cairo.
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

# files that draw, search the folders of scenes, use internal functions of the library, or are for programs of this build
set(drawing ${scene_sources})
list(FILTER drawing INCLUDE REGEX
	"/(canvas|caption|detail|find|heading|links|moment_file|picture|player_file|regions|scan_picture|shades|sleepers|sprites|stage_times|video|viewport|wall_inputs)\\.c$")
list(REMOVE_ITEM scene_sources ${drawing})

if(NOT JANSSON_FOUND AND CMAKE_CROSSCOMPILING)
	message(NOTICE "scree: scenes are left out, because the sources of Jansson are not in ${SCREE_JANSSON_SOURCE}")
elseif(NOT JANSSON_FOUND)
	message(NOTICE "scree: scenes and the command line are left out, because Jansson was not found; Debian has it in libjansson-dev")
elseif(scene_sources)
	add_library(scree_scene_objects OBJECT ${scene_sources})
	scree_flags(scree_scene_objects)
	target_link_libraries(scree_scene_objects PRIVATE ${jansson})

	add_library(scree_scene_internals STATIC EXCLUDE_FROM_ALL ${drawing} $<TARGET_OBJECTS:scree_scene_objects>)
	scree_flags(scree_scene_internals)
	target_link_libraries(scree_scene_internals PUBLIC scree_internals ${jansson} m PRIVATE scree_common)
	if(CAIRO_FOUND)
		target_link_libraries(scree_scene_internals PRIVATE PkgConfig::CAIRO)
		target_compile_definitions(scree_scene_internals PRIVATE SCREE_HAVE_CAIRO)
	elseif(NOT EMSCRIPTEN)
		message(NOTICE "scree: pictures are left out, because Cairo was not found; Debian has it in libcairo2-dev")
	endif()
	# scenes are searched first in the sources, then in the folder of the installation
	target_compile_definitions(scree_scene_internals PUBLIC SCREE_SCENE_DIR="${PROJECT_SOURCE_DIR}/scenes"
		SCREE_INSTALLED_SCENE_DIR="${CMAKE_INSTALL_FULL_DATADIR}/scree/scenes")

	# golden, whose hashes tests compare; it needs no test framework, so it is built for every platform
	add_executable(golden EXCLUDE_FROM_ALL tests/tools/golden.c)
	scree_flags(golden)
	target_link_libraries(golden PRIVATE scree_scene_internals scree_internals)

	if(SCREE_BUILD_SCENE AND NOT EMSCRIPTEN)
		include(cmake/scene_library.cmake)
	endif()
endif()
