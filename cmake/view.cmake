# view.cmake -- drawing with OpenGL: needs libepoxy; shares memory through Vulkan where its headers are found.
file(GLOB view_sources CONFIGURE_DEPENDS view/*.c)
file(GLOB view_shaders CONFIGURE_DEPENDS view/glsl/*)

find_package(PkgConfig)
if(PkgConfig_FOUND)
	pkg_check_modules(EPOXY IMPORTED_TARGET epoxy)
endif()
find_path(SCREE_VULKAN_INCLUDE_DIR vulkan/vulkan.h DOC "Folder that holds vulkan/vulkan.h")

if(NOT EPOXY_FOUND)
	message(NOTICE "scree: drawing with OpenGL is left out, because libepoxy was not found; Debian has it in libepoxy-dev")
elseif(NOT TARGET scree_scene)
	message(NOTICE "scree: drawing with OpenGL is left out, because scenes need Jansson")
elseif(view_sources)
	set(glsl ${PROJECT_BINARY_DIR}/glsl.c)
	string(REPLACE ";" " " files "${view_shaders}")
	add_custom_command(OUTPUT ${glsl}
		COMMAND ${CMAKE_COMMAND} "-DFILES=${files}" -DOUT=${glsl} -P ${PROJECT_SOURCE_DIR}/cmake/texts.cmake
		DEPENDS ${view_shaders} ${PROJECT_SOURCE_DIR}/cmake/texts.cmake
		COMMENT "Embedding view/glsl" VERBATIM)
	add_library(scree_view STATIC ${view_sources} ${glsl})
	scree_flags(scree_view)
	target_include_directories(scree_view PUBLIC ${PROJECT_SOURCE_DIR})
	target_link_libraries(scree_view PUBLIC scree_scene scree_static PkgConfig::EPOXY PRIVATE m ${CMAKE_DL_LIBS})
	if(SCREE_VULKAN_INCLUDE_DIR)
		target_compile_definitions(scree_view PRIVATE SCREE_HAVE_VULKAN)
		target_include_directories(scree_view SYSTEM PRIVATE ${SCREE_VULKAN_INCLUDE_DIR})
	endif()
endif()
