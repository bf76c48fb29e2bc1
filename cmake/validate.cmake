# validate.cmake -- builds the experiments of scree validate, which scree_peers repeats with Box2D.
file(GLOB validate_sources CONFIGURE_DEPENDS validate/*.c)

if(TARGET scree_scene_internals)
	add_library(scree_validate STATIC ${validate_sources})
	scree_flags(scree_validate)
	target_link_libraries(scree_validate PUBLIC scree_scene_internals scree_common scree_internals m)
endif()
