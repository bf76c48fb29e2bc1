# scene_library.cmake -- builds the library scree_scene.

# files below scene/ that its functions call
add_library(scree_scene_base OBJECT src/platform/processor.c tools/common/clock.c tools/common/open_input.c tools/common/whole_file.c)
scree_flags(scree_scene_base)
target_compile_definitions(scree_scene_base PRIVATE SCREE_LANES=${lanes})
scree_second_library(scene scree_scene_objects scree_scene_base)
if(TARGET scree_scene_static)
	# an installed library names Jansson only, which pkg-config may not know there
	target_link_libraries(scree_scene_static INTERFACE $<BUILD_INTERFACE:${jansson}> $<INSTALL_INTERFACE:jansson>
		$<$<NOT:$<BOOL:${WIN32}>>:m>)
endif()
if(TARGET scree_scene_shared)
	target_link_libraries(scree_scene_shared PRIVATE $<BUILD_INTERFACE:${jansson}> m)
endif()
