# glsl.cmake -- scree_glsl(target): adds the shaders of view/glsl to a target, as texts.
file(GLOB SCREE_SHADERS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/view/glsl/*)

function(scree_glsl target)
	set(glsl ${PROJECT_BINARY_DIR}/glsl.c)
	string(REPLACE ";" " " files "${SCREE_SHADERS}")
	add_custom_command(OUTPUT ${glsl}
		COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DOUT=${glsl} -P ${PROJECT_SOURCE_DIR}/cmake/texts.cmake
		DEPENDS ${SCREE_SHADERS} ${PROJECT_SOURCE_DIR}/cmake/texts.cmake
		COMMENT "Embedding view/glsl" VERBATIM)
	target_sources(${target} PRIVATE ${glsl})
endfunction()
