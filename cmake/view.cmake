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

# the window: GLFW, and Dear ImGui for its panel, in C++
file(GLOB window_sources CONFIGURE_DEPENDS view/window/*.c view/window/*.cpp)
include(CheckLanguage)
if(NOT CMAKE_CXX_COMPILER)
	unset(CMAKE_CXX_COMPILER CACHE) # it may have been installed since
endif()
check_language(CXX)
if(PkgConfig_FOUND)
	pkg_check_modules(GLFW IMPORTED_TARGET glfw3)
	pkg_check_modules(IMGUI IMPORTED_TARGET imgui)
endif()
if(TARGET scree_view AND GLFW_FOUND AND IMGUI_FOUND AND CMAKE_CXX_COMPILER)
	enable_language(CXX)
	add_library(scree_window STATIC ${window_sources})
	scree_flags(scree_window)
	set_target_properties(scree_window PROPERTIES CXX_STANDARD 17 CXX_STANDARD_REQUIRED ON CXX_EXTENSIONS OFF)
	target_include_directories(scree_window SYSTEM PRIVATE ${IMGUI_INCLUDE_DIRS})
	target_link_libraries(scree_window PUBLIC scree_view PRIVATE PkgConfig::GLFW PkgConfig::IMGUI)
else()
	message(NOTICE "scree: the viewer is left out, because it needs libepoxy, GLFW, Dear ImGui and a C++ compiler; "
		"Debian has them in libepoxy-dev, libglfw3-dev, libimgui-dev and g++")
endif()
